//! Delivery: the motivating example of the paper (Figure 1).
//!
//! A truck fetches packages from factories and brings a given number of them to the delivery area.
//! The candidate goals are all the sets of that many packages. Observers know what lies at each
//! factory at first.
//!
//! Loading includes the drive to the factory, so there are two kinds of action: `load P`, while the
//! truck has room, and `deliver`, once it is full. (With drives of their own, the length of a plan
//! would tell whether the truck went to one factory or two, which Figure 1 does not mean.)

mod build;
mod generate;
mod read;

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

pub use generate::DeliveryShape;

use super::Observers;

/// The most packages a document may have.
pub const MAX_PACKAGES: usize = 64;

/// A `delivery` document.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct Delivery {
    /// The factories and their packages.
    pub factories: Vec<Factory>,
    /// How many packages are to be delivered.
    pub deliver: u32,
    /// The packages of the true goal, joined by `+`.
    pub true_goal: String,
    /// What the two observers see.
    pub observers: Observers<DeliveryObserver>,
}

/// A factory.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct Factory {
    /// Its name.
    pub name: String,
    /// The names of the packages that lie there.
    pub packages: Vec<String>,
}

/// An observer of a delivery.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct DeliveryObserver {
    /// What it sees.
    pub sensor: DeliverySymbols,
}

/// The symbols an observer sees.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct DeliverySymbols {
    /// When a package is loaded.
    pub load: LoadSymbols,
    /// When the truck delivers.
    pub deliver: String,
}

/// What an observer tells apart when a package is loaded.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LoadSymbols {
    /// Nothing: one symbol for all packages.
    Same(String),
    /// A symbol for some factories and packages; a package's own goes first.
    Each(Vec<(String, String)>),
}

impl Serialize for LoadSymbols {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Same(symbol) => serializer.serialize_str(symbol),
            Self::Each(symbols) => {
                let mut map = serializer.serialize_map(Some(symbols.len()))?;
                for (name, symbol) in symbols {
                    map.serialize_entry(name, symbol)?;
                }
                map.end()
            }
        }
    }
}

impl Delivery {
    /// The example of Figure 1: two packages at A, two at B, deliver two. The enemy cannot tell
    /// packages apart; the friend reads the factory from the barcode, not the package.
    ///
    /// ```
    /// use mo_copp::domain::Delivery;
    /// let problem = Delivery::figure_1().problem()?;
    /// assert_eq!(problem.goals().len(), 6);
    /// # Ok::<(), mo_copp::document::DocumentError>(())
    /// ```
    pub fn figure_1() -> Self {
        let factory = |name: &str, packages: [&str; 2]| Factory {
            name: name.to_owned(),
            packages: packages.map(str::to_owned).to_vec(),
        };
        let sensor = |load| DeliveryObserver {
            sensor: DeliverySymbols { load, deliver: "delivery".to_owned() },
        };
        let barcode = |name: &str| (name.to_owned(), format!("barcode {name}"));
        Self {
            factories: vec![factory("A", ["a1", "a2"]), factory("B", ["b1", "b2"])],
            deliver: 2,
            true_goal: "a1+a2".to_owned(),
            observers: Observers {
                adversarial: sensor(LoadSymbols::Same("package".to_owned())),
                cooperative: sensor(LoadSymbols::Each(vec![barcode("A"), barcode("B")])),
            },
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
impl schemars::JsonSchema for LoadSymbols {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "LoadSymbols".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({"anyOf": [{"type": "string"}, {"type": "object", "additionalProperties": {"type": "string"}}]})
    }
}
