//! Draws random deliveries.

use rand::RngExt;

use super::{Delivery, DeliveryObserver, DeliverySymbols, Factory, LoadSymbols, MAX_PACKAGES};
use crate::document::DocumentError;
use crate::domain::Observers;
use crate::domain::generate::{Drawn, GenerateError, draw, in_range, random};

/// The size of a random delivery. Packages are dealt to factories at random, and so are the two
/// packages of the true goal. The sensors are the paper's.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DeliveryShape {
    /// Factories, named A, B, C, ….
    pub factories: u32,
    /// Packages in all.
    pub packages: u32,
    /// How many of them to deliver.
    pub deliver: u32,
}

impl Default for DeliveryShape {
    fn default() -> Self {
        Self { factories: 3, packages: 6, deliver: 2 }
    }
}

impl DeliveryShape {
    /// Draws a delivery. Any is solvable.
    ///
    /// # Errors
    ///
    /// The numbers make no sense together.
    pub fn generate(self, seed: u64) -> Result<Drawn<Delivery>, GenerateError> {
        in_range("factories", self.factories, 1..=26)?;
        in_range("packages", self.packages, self.factories.max(2)..=MAX_PACKAGES as u32)?;
        in_range("deliver", self.deliver, 1..=self.packages - 1)?;
        let mut random = random(seed);
        let letter = |index: u32| char::from(b'A' + index as u8);
        // Every factory has one package at least.
        let mut counts = vec![1_u32; self.factories as usize];
        for _ in self.factories..self.packages {
            counts[random.random_range(0..self.factories) as usize] += 1;
        }
        let mut names = Vec::new();
        let mut factories = Vec::new();
        for (index, count) in (0..).zip(counts) {
            let name = letter(index);
            let packages: Vec<String> =
                (1..=count).map(|n| format!("{}{n}", name.to_ascii_lowercase())).collect();
            names.extend(packages.iter().cloned());
            factories.push(Factory { name: name.to_string(), packages });
        }
        let mut goal = draw(&mut random, &mut names, self.deliver as usize);
        goal.sort_unstable();
        let barcodes = factories.iter().map(|f| (f.name.clone(), format!("barcode {}", f.name)));
        let sensor = |load| DeliveryObserver {
            sensor: DeliverySymbols { load, deliver: "delivery".to_owned() },
        };
        let observers = Observers {
            adversarial: sensor(LoadSymbols::Same("package".to_owned())),
            cooperative: sensor(LoadSymbols::Each(barcodes.collect())),
        };
        let document =
            Delivery { factories, deliver: self.deliver, true_goal: goal.join("+"), observers };
        // There may be too many sets of packages, which are the goals.
        if let Err(DocumentError::Invalid { found, expected, .. }) = document.problem() {
            return Err(GenerateError::Shape { what: "deliver", found, expected });
        }
        Ok(Drawn { document, redraws: 0 })
    }
}
