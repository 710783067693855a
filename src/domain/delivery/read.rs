//! Reads a `delivery` document.

use super::{Delivery, DeliveryObserver, DeliverySymbols, Factory, LoadSymbols, MAX_PACKAGES};
use crate::document::DocumentError;
use crate::document::json::Json;
use crate::document::reader::Reader;
use crate::domain::Observers;

impl Delivery {
    /// Reads keys and types; whether the parts fit together is asked by
    /// [`problem`](Self::problem).
    ///
    /// # Errors
    ///
    /// [`DocumentError`] with the place.
    pub(in crate::domain) fn read(document: &Reader<'_>) -> Result<Self, DocumentError> {
        let fields =
            document.fields(&["format", "factories", "deliver", "true_goal", "observers"])?;
        Ok(Self {
            factories: fields.required("factories", "a list of factories")?.list(factory)?,
            deliver: fields
                .required("deliver", "how many packages to deliver")?
                .integer(1..=MAX_PACKAGES as u32)?,
            true_goal: fields
                .required("true_goal", "packages joined by +, as in a1+a2")?
                .text()?
                .to_owned(),
            observers: Observers::read(&fields, observer)?,
        })
    }
}

fn factory(reader: &Reader<'_>) -> Result<Factory, DocumentError> {
    let fields = reader.fields(&["name", "packages"])?;
    let text = |reader: &Reader<'_>| reader.name().map(str::to_owned);
    Ok(Factory {
        name: fields.required("name", "the factory's name")?.name()?.to_owned(),
        packages: fields.required("packages", "a list of package names")?.list(text)?,
    })
}

fn observer(reader: &Reader<'_>) -> Result<DeliveryObserver, DocumentError> {
    let fields = reader.fields(&["sensor"])?;
    let symbols = fields
        .required("sensor", "an object with load and deliver")?
        .fields(&["load", "deliver"])?;
    let load = symbols.required("load", "a symbol, or an object with a symbol for each factory")?;
    let load = match load.value() {
        Json::Text(_) => LoadSymbols::Same(load.name()?.to_owned()),
        Json::Object(_) => {
            let entry = |(name, symbol): (&str, Reader<'_>)| {
                Ok((name.to_owned(), symbol.name()?.to_owned()))
            };
            LoadSymbols::Each(load.entries()?.named()?.map(entry).collect::<Result<_, _>>()?)
        }
        _ => return Err(load.expected("a symbol, or an object with a symbol for each factory")),
    };
    let deliver = symbols.required("deliver", "the symbol the observer sees")?.name()?.to_owned();
    Ok(DeliveryObserver { sensor: DeliverySymbols { load, deliver } })
}
