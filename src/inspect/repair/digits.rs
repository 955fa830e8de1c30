//! How the numbers are printed as a witness: repeated numbers, equal round ones, a lost point, digits that are too few.

use nalgebra::{Matrix3, Vector3};

use super::super::change::Change;
use super::super::link::{MOMENTS, PRODUCTS, SIX, tensor_of};
use super::super::outline::Outline;
use super::super::verdict::{Verdict, principal};
use super::{BY_NUMBERS, CLOSE, Case, Repair};

pub(super) fn repairs(case: &Case, changes: &[Change]) -> Vec<Repair> {
    if case.judged.verdict == Verdict::Rounding {
        return vec![more_digits(case)];
    }
    if case.judged.findings.iter().all(|finding| !BY_NUMBERS.contains(finding)) {
        return Vec::new();
    }
    let witnessed = [row_major(case), equal_round_products(case, changes), lost_point(case, changes)];
    let found: Vec<Repair> = witnessed.into_iter().flatten().collect();
    if found.is_empty() { products_of_cad(case, changes).into_iter().collect() } else { found }
}

/// What is odd about the digits of an impossible body, and says nothing about the right ones.
pub(super) fn oddities(case: &Case) -> Vec<String> {
    let six = &case.inertial.six;
    let first = &six[0];
    if first.value != 0.0 && six.iter().all(|number| number.text == first.text && !number.text.is_empty()) {
        return vec![format!("all six numbers are {}: a form that was filled in", first.text)];
    }
    let mut seen = Vec::new();
    for product in PRODUCTS {
        let repeated = MOMENTS.into_iter().find(|moment| {
            six[*moment].text == six[product].text && six[product].significant_digits() >= REPEATED
        });
        if let Some(moment) = repeated {
            let (own, other) = (SIX[product], SIX[moment]);
            seen.push(format!(
                "{own} repeats {other} to the last digit, {}: a slip of transcription, by which {own} is lost",
                six[product].text
            ));
        }
    }
    seen
}

/// Digits of a number that are not repeated by chance.
const REPEATED: usize = 4;

/// Some possible body prints these very digits: the uniform outline where it does, else the nearest one.
fn more_digits(case: &Case) -> Repair {
    let own = tensor_of(&case.inertial.values());
    let hidden = tensor_of(&std::array::from_fn(|i| case.inertial.six[i].half_unit));
    let uniform = Outline::of(case.link).filter(|outline| outline.exact).and_then(|outline| outline.uniform);
    let back = case.inertial.pose.axes.transpose();
    let printed_alike = uniform.map(|uniform| uniform.tensor * case.mass()).filter(|tensor| {
        let turned = back * tensor * back.transpose();
        // Exact zeros are hidden by nothing: sums of products round.
        (turned - own).abs().iter().zip(&hidden).all(|(off, hidden)| *off <= hidden + 1e-12 * own.amax())
    });
    let excess = -case.judged.slack;
    let how = format!(
        "the excess, {excess:.2e} kg m², is below what the printed digits can hide, {:.2e}: some possible body prints these very digits",
        case.judged.resolution
    );
    let tensor = printed_alike.unwrap_or_else(|| case.inertial.pose.turned(&nearest(&own)));
    let what = "print more digits".to_owned();
    Repair { unique: false, ..case.repair("more-digits", what, how, tensor) }
}

/// The nearest tensor with I₁ + I₂ = I₃: a third of the excess off the largest moment and on each of the others.
fn nearest(tensor: &Matrix3<f64>) -> Matrix3<f64> {
    let (moments, axes) = principal(tensor);
    let third = (moments[2] - moments[0] - moments[1]) / 3.0;
    axes * Matrix3::from_diagonal(&(moments + Vector3::new(third, third, -third))) * axes.transpose()
}

/// M00 M01 M02 M10 M11 M12 in the slots ixx ixy ixz iyy iyz izz: iyy repeats ixy, and the last moment is lost.
fn row_major(case: &Case) -> Option<Repair> {
    let six = &case.inertial.six;
    let [xx, xy, xz, yx, yy, yz] = case.inertial.values();
    if six[3].text != six[1].text
        || six[1].text.is_empty()
        || xy == 0.0
        || case.judged.verdict != Verdict::Impossible
    {
        return None;
    }
    let uniform = Outline::of(case.link).filter(|outline| outline.exact)?.uniform?;
    let back = case.inertial.pose.axes.transpose();
    let wanted = back * uniform.tensor * back.transpose() * case.mass();
    let read = tensor_of(&[xx, yx, xz, yy, yz, wanted[(2, 2)]]);
    if (read - wanted).amax() > CLOSE * wanted.trace() {
        return None;
    }
    let what = "read the six numbers as the first two rows of the matrix: iyy from the slot iyz, iyz from the slot izz; izz is not in the \
                file and is taken from the outline";
    let how = format!(
        "iyy repeats ixy to the last digit ({}), and the five numbers that are left are those of the uniform outline; another izz between \
         |ixx − iyy| and ixx + iyy would do as well",
        six[1].text
    );
    let tensor = case.inertial.pose.turned(&read);
    Some(Repair { unique: false, ..case.repair("reorder", what.to_owned(), how, tensor) })
}

/// Three equal products of one digit: the floor of a rounding, and no product.
fn equal_round_products(case: &Case, changes: &[Change]) -> Option<Repair> {
    let [a, b, c] = PRODUCTS.map(|place| &case.inertial.six[place]);
    let equal = a.value != 0.0 && a.value == b.value && b.value == c.value;
    // Moments that are the same number too are a filled-in form, of which nothing is known.
    let filled = MOMENTS.iter().all(|place| case.inertial.six[*place].value == a.value);
    if !equal || filled || a.significant_digits() != 1 {
        return None;
    }
    let change = changes.iter().find(|change| change.kind == "zero-products")?;
    let how = format!("all three products are the same round number, {}", a.text);
    Some(case.repair(
        change.kind,
        change.label.clone(),
        how,
        case.inertial.pose.turned(&tensor_of(&change.six)),
    ))
}

/// One number without a decimal point among numbers with one and with the same exponent.
fn lost_point(case: &Case, changes: &[Change]) -> Option<Repair> {
    let [change] = changes else { return None };
    let (place, power) = change.scaled?;
    let odd = &case.inertial.six[place];
    let (mantissa, exponent) = odd.parts();
    let alike = |i: &usize| {
        let (others, own) = case.inertial.six[*i].parts();
        own == exponent && others.contains('.')
    };
    let others = (0..6).filter(|i| *i != place).filter(alike).count();
    let digits = usize::try_from(-power).ok()?;
    if mantissa.contains('.') || others < 4 || digits >= mantissa.len() {
        return None;
    }
    let (whole, decimals) = mantissa.split_at(mantissa.len() - digits);
    let suffix = &odd.text[mantissa.len()..];
    let what = format!("{} = {whole}.{decimals}{suffix} (times 1e{power})", SIX[place]);
    let how = format!(
        "{} has no decimal point, and {others} of the other five have one and the same exponent; of all single changes only this one \
         gives a possible tensor",
        odd.text
    );
    Some(case.repair(change.kind, what, how, case.inertial.pose.turned(&tensor_of(&change.six))))
}

/// Three positive products where CAD prints + ∫ x y dm: any odd number of turned signs gives the same moments, so it is one of several.
fn products_of_cad(case: &Case, changes: &[Change]) -> Option<Repair> {
    if PRODUCTS.iter().any(|place| case.inertial.values()[*place] <= 0.0) {
        return None;
    }
    let change =
        changes.iter().find(|change| change.kind == "flip-products" && change.label == "ixy ixz iyz")?;
    let how = "all three products are positive, as in the convention of CAD, +∫ x y dm; turning one sign alone gives the same moments, \
               and nothing in the file says which";
    let what = "ixy, ixz, iyz change their signs (CAD convention)".to_owned();
    let tensor = case.inertial.pose.turned(&tensor_of(&change.six));
    Some(Repair { unique: false, ..case.repair(change.kind, what, how.to_owned(), tensor) })
}
