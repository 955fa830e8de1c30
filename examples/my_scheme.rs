//! A scheme of your own in a report, beside Peskin's: `cargo run --release --example my_scheme`.

use polhode::prelude::*;
use polhode::schemes::PeskinRk2;

/// Heun's rule: the mean of the rates at both ends of the step.
#[derive(Clone, Copy)]
struct Mine;

impl Scheme for Mine {
    fn card(&self) -> Card {
        Card::new("mine", &[Claim::Order(2)])
    }

    const STATES: usize = 1;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [end] = work.buffers();
        let k0 = model.rates(t, from)?;
        model.advance(from, h, &k0, end);
        let k1 = model.rates(t + h, end)?;
        model.advance(from, h, &((k0 + k1) / 2.0), to);
        Ok(())
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scenes = vec![Scene::find("free-asymmetric")?, Scene::find("kovalevskaya")?];
    let schemes = vec![Contestant::new(Mine), Contestant::new(PeskinRk2)];
    let records = Survey::of(scenes, schemes).run();
    polhode::write_report(&records, "reports/mine")?;
    println!("reports/mine/index.html");
    Ok(())
}
