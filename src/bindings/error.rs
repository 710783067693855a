//! Errors as JavaScript throws them.

use wasm_bindgen::JsValue;

use crate::document::{DocumentError, Place};
#[cfg(feature = "full")]
use crate::picture::PictureError;
use crate::plan::PlanError;
use crate::solver::SolveError;

/// What the page's light core throws at what only the full one can do.
const NEEDS_FULL_CORE: &str = "NeedsFullCore";

/// An `Error` of this name.
pub(super) fn thrown(name: &str, message: &str) -> JsValue {
    let error = js_sys::Error::new(message);
    error.set_name(name);
    error.into()
}

/// What the light core throws at what it is built without.
#[cfg(not(feature = "full"))]
pub(super) fn needs_full_core(message: &str) -> JsValue {
    thrown(NEEDS_FULL_CORE, message)
}

/// A `PlanError`.
pub(super) fn plan(error: &PlanError) -> JsValue {
    thrown("PlanError", &error.to_string())
}

/// An `OptionsError`.
pub(super) fn options(error: &dyn std::error::Error) -> JsValue {
    thrown("OptionsError", &error.to_string())
}

/// A `PlanError` where the plan cannot be drawn, else an `OptionsError`.
#[cfg(feature = "full")]
pub(super) fn picture(error: &PictureError) -> JsValue {
    match error {
        PictureError::Plan(error) => plan(error),
        error => options(error),
    }
}

/// An `ImportError`, with the place in the file as properties where there is one.
#[cfg(feature = "full")]
pub(super) fn import(error: &crate::domain::pddl::import::ImportError) -> JsValue {
    use crate::domain::pddl::import::ImportError;
    let value = thrown("ImportError", &error.to_string());
    match error {
        ImportError::Place { file, line, column, .. } => {
            set(&value, "file", file.into());
            set(&value, "line", JsValue::from(u32::try_from(*line).unwrap_or(u32::MAX)));
            set(&value, "column", JsValue::from(u32::try_from(*column).unwrap_or(u32::MAX)));
        }
        ImportError::File { file, .. } => set(&value, "file", file.into()),
        ImportError::Option { .. } => {}
    }
    value
}

/// A `SolveError`; an `OptionsError` where the options do not fit, and [`NEEDS_FULL_CORE`].
pub(super) fn solve(error: &SolveError) -> JsValue {
    match error {
        SolveError::Options(error) => options(error),
        SolveError::NeedsFullCore => thrown(NEEDS_FULL_CORE, &error.to_string()),
        SolveError::Replay(_) | SolveError::TooLargeToReplay => {
            thrown("SolveError", &error.to_string())
        }
    }
}

/// A `DocumentError`, with its place as properties.
pub(super) fn document(error: &DocumentError, text: &str) -> JsValue {
    if *error == DocumentError::NeedsFullCore {
        return thrown(NEEDS_FULL_CORE, &error.to_string());
    }
    let value = thrown("DocumentError", &error.to_string());
    let number = |number: usize| JsValue::from(u32::try_from(number).unwrap_or(u32::MAX));
    match error {
        DocumentError::NeedsFullCore => {}
        DocumentError::Syntax { line, column, .. } => {
            set(&value, "line", number(*line));
            set(&value, "column", number(*column));
        }
        DocumentError::Pddl { path, line, column, .. } => {
            set(&value, "path", path.into());
            set(&value, "line", number(*line));
            set(&value, "column", number(*column));
        }
        DocumentError::UnknownKey { path, .. } | DocumentError::Invalid { path, .. } => {
            set(&value, "path", path.into());
        }
    }
    if let DocumentError::Syntax { found, expected, .. }
    | DocumentError::Pddl { found, expected, .. }
    | DocumentError::Invalid { found, expected, .. } = error
    {
        set(&value, "found", found.into());
        set(&value, "expected", expected.into());
    }
    let Place { line, column, length } = error.place(text);
    let place = js_sys::Object::new();
    set(&place, "line", number(line));
    set(&place, "column", number(column));
    set(&place, "length", number(length));
    set(&value, "place", place.into());
    value
}

/// Setting a property of a new object cannot fail.
fn set(object: &JsValue, key: &str, property: JsValue) {
    let _ = js_sys::Reflect::set(object, &key.into(), &property);
}
