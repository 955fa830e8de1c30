//! A solution as text, JSON and CSV. A bound covers the error of the solution and the rounding of the digits that stand there.

use std::fmt::Write as _;

use super::Format;
use crate::model::Quantity;
use crate::reference::precise::{DoubleDouble, Moment, Motion, decimal};
use crate::scenes::Scene;

/// A quantity at a time: its vectors as digits.
struct Printed {
    name: &'static str,
    key: &'static str,
    unit: &'static str,
    vectors: Vec<Vec<String>>,
    bound: f64,
}

/// Every quantity at every time, with its bound.
pub(super) fn solution(format: Format, scene: &Scene, motion: &Motion, digits: usize) -> String {
    match format {
        Format::Text => text(scene, motion, digits),
        Format::Json => json(scene, motion, digits),
        Format::Csv => csv(motion, digits),
    }
}

fn text(scene: &Scene, motion: &Motion, digits: usize) -> String {
    let [(order, steps), (other, other_steps)] = motion.runs;
    let mut text = format!(
        "{}: {digits} digits; Taylor series of order {order}, {steps} steps; error bounds from a second one of order \
         {other}, {other_steps} steps\n",
        scene.name
    );
    if motion.switches > 0 {
        let _ = writeln!(text, "Contacts with the ground made or lost on the way: {}", motion.switches);
    }
    for moment in &motion.moments {
        text += &format!("\nt = {} s\n", moment.time);
        for Printed { name, unit, vectors, bound, .. } in printed(moment, digits) {
            let _ = writeln!(text, "  {name}, within {bound:.1e} {unit}");
            for numbers in vectors {
                let numbers: Vec<String> =
                    numbers.iter().map(|x| format!("{x:>width$}", width = digits + 4)).collect();
                let _ = writeln!(text, "    {}", numbers.join("  "));
            }
        }
    }
    text
}

/// Digits stand as JSON numbers, more of them than an f64 holds.
fn json(scene: &Scene, motion: &Motion, digits: usize) -> String {
    let moment = |moment: &Moment| {
        let of = |one: &Printed| {
            let rows: Vec<String> = one.vectors.iter().map(|row| format!("[{}]", row.join(","))).collect();
            let value = if rows.len() == 1 { rows.concat() } else { format!("[{}]", rows.join(",")) };
            format!("\"{}\":{value},\"{}_within\":{:e}", one.key, one.key, one.bound)
        };
        let of_all: Vec<String> = printed(moment, digits).iter().map(of).collect();
        format!("{{\"time_s\":{:?},{}}}", moment.time, of_all.join(","))
    };
    let moments: Vec<String> = motion.moments.iter().map(moment).collect();
    format!(
        "{{\"schema\":\"polhode/reference/1\",\"scene\":\"{}\",\"digits\":{digits},\"moments\":[\n{}\n]}}\n",
        scene.name,
        moments.join(",\n")
    )
}

fn csv(motion: &Motion, digits: usize) -> String {
    let mut text = "time_s,quantity,component,value,within,unit\n".to_owned();
    for moment in &motion.moments {
        for one in printed(moment, digits) {
            for (index, value) in one.vectors.iter().flatten().enumerate() {
                let (time, key, bound, unit) = (moment.time, one.key, one.bound, one.unit);
                let _ = writeln!(text, "{time:?},{key},{index},{value},{bound:e},{unit}");
            }
        }
    }
    text
}

fn printed(moment: &Moment, digits: usize) -> [Printed; 6] {
    let axes: Vec<[DoubleDouble; 3]> =
        (0..3).map(|row| [0, 1, 2].map(|column: usize| moment.axes[column][row])).collect();
    let one = |name, key, vectors: &[[DoubleDouble; 3]], quantity: Quantity| {
        let bound = moment.bound(quantity);
        let written = vectors.iter().map(|vector| decimal::write_vector(vector, bound, digits).to_vec());
        let rounding = vectors.iter().map(|vector| rounding(vector, bound, digits)).fold(0.0, f64::max);
        Printed { name, key, unit: quantity.unit(), vectors: written.collect(), bound: bound + rounding }
    };
    let quaternion = quaternion(&axes);
    // A quaternion turns by half the angle of its rotation.
    let angle = moment.bound(Quantity::Orientation) / 2.0 + DoubleDouble::ROUNDING;
    let places = digits.min((1.0 / (2.0 * angle)).log10().floor().max(1.0) as usize);
    let largest = quaternion.iter().map(|x| last_place(*x, places)).fold(0.0, f64::max);
    [
        one("X_cm [m]", "position_m", &[moment.position], Quantity::Position),
        one("U_cm [m/s]", "velocity_m_s", &[moment.velocity], Quantity::Velocity),
        one("R, body to world axes", "rotation", &axes, Quantity::Orientation),
        Printed {
            name: "q, w x y z, body to world axes",
            key: "orientation_wxyz",
            unit: "1",
            vectors: vec![quaternion.iter().map(|x| decimal::write(*x, places)).collect()],
            bound: angle + largest,
        },
        one("Omega [rad/s]", "angular_velocity_rad_s", &[moment.angular_velocity], Quantity::AngularVelocity),
        one("L [kg m²/s]", "angular_momentum_kg_m2_s", &[moment.angular_momentum], Quantity::AngularMomentum),
    ]
}

/// The most that the digits of a vector are off from the numbers that they are made from.
fn rounding(vector: &[DoubleDouble; 3], bound: f64, digits: usize) -> f64 {
    let places = decimal::certain(vector, bound).min(digits as f64);
    let size = vector.iter().map(|x| x.high.abs()).fold(0.0, f64::max);
    // A vector within its bound is written as zeros.
    if places < 1.0 {
        size
    } else {
        vector.iter().map(|x| last_place(*x, places as usize)).fold(0.0, f64::max)
    }
}

/// Half a unit of the last of so many significant digits.
fn last_place(number: DoubleDouble, places: usize) -> f64 {
    let size = number.high.abs();
    if size == 0.0 { 0.0 } else { 0.5 * 10f64.powf(size.log10().floor() + 1.0 - places as f64) }
}

/// The quaternion of a rotation, w ≥ 0: its largest entry from the diagonal of R, the others from sums and differences of the rest (Shepperd 1978).
fn quaternion(axes: &[[DoubleDouble; 3]]) -> [DoubleDouble; 4] {
    let r = |row: usize, column: usize| axes[row][column];
    let one = DoubleDouble::from(1.0);
    let (xx, yy, zz) = (r(0, 0), r(1, 1), r(2, 2));
    let squares = [one + xx + yy + zz, one + xx - yy - zz, one - xx + yy - zz, one - xx - yy + zz];
    let largest = (0..4).max_by(|a, b| squares[*a].high.total_cmp(&squares[*b].high)).unwrap_or(0);
    let twice = squares[largest].sqrt();
    let rest = DoubleDouble::from(0.5) / twice;
    let (x, y, z) = (r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
    let (xy, xz, yz) = (r(0, 1) + r(1, 0), r(0, 2) + r(2, 0), r(1, 2) + r(2, 1));
    let big = twice.scaled(0.5);
    let q = match largest {
        0 => [big, x * rest, y * rest, z * rest],
        1 => [x * rest, big, xy * rest, xz * rest],
        2 => [y * rest, xy * rest, big, yz * rest],
        _ => [z * rest, xz * rest, yz * rest, big],
    };
    if q[0].high < 0.0 { q.map(|x| -x) } else { q }
}
