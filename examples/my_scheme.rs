//! A scheme of your own in a report, beside Peskin's: `cargo run --release --example my_scheme`.

use polhode::prelude::*;
use polhode::schemes::PeskinRk2;

/// Heun's rule: the mean of the rates at both ends of the step.
struct Mine;

impl Scheme for Mine {
    const CARD: Card = Card::new("mine", &[Claim::Order(2)]);
    const STATES: usize = 1;

    fn step<M: Model>(
        model: &M,
        t: f64,
        h: f64,
        from: &M::State,
        to: &mut M::State,
        work: &mut Workspace<M>,
    ) -> Result<(), Broken> {
        let [end] = work.buffers();
        let k0 = model.rates(t, from)?;
        model.advance(from, h, &k0, end);
        let k1 = model.rates(t + h, end)?;
        model.advance(from, h, &((k0 + k1) * 0.5), to);
        Ok(())
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scenes = vec![Scene::find("free-asymmetric")?, Scene::find("kovalevskaya")?];
    let schemes = vec![Contestant::new::<Mine>(), Contestant::new::<PeskinRk2>()];
    let records = Survey::of(scenes, schemes).run();
    polhode::write_report(&records, "reports/mine")?;
    println!("reports/mine/index.html");
    Ok(())
}
