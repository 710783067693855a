//! Errors as JavaScript throws them.

use wasm_bindgen::JsValue;

use crate::document::DocumentError;
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

/// A `PlanError`.
pub(super) fn plan(error: &PlanError) -> JsValue {
    thrown("PlanError", &error.to_string())
}

/// An `OptionsError`.
pub(super) fn options(error: &dyn std::error::Error) -> JsValue {
    thrown("OptionsError", &error.to_string())
}

/// A `SolveError`; an `OptionsError` where the options do not fit, and [`NEEDS_FULL_CORE`].
pub(super) fn solve(error: &SolveError) -> JsValue {
    match error {
        SolveError::Options(error) => options(error),
        SolveError::NeedsFullCore => thrown(NEEDS_FULL_CORE, &error.to_string()),
        SolveError::Replay(_) => thrown("SolveError", &error.to_string()),
    }
}

/// A `DocumentError`, with its place as properties.
pub(super) fn document(error: &DocumentError) -> JsValue {
    if *error == DocumentError::NeedsFullCore {
        return thrown(NEEDS_FULL_CORE, &error.to_string());
    }
    let value = thrown("DocumentError", &error.to_string());
    // Setting a property of a new object cannot fail.
    let set = |key: &str, property: JsValue| {
        let _ = js_sys::Reflect::set(&value, &key.into(), &property);
    };
    match error {
        DocumentError::NeedsFullCore => {}
        DocumentError::Syntax { line, column, .. } => {
            set("line", (*line as u32).into());
            set("column", (*column as u32).into());
        }
        DocumentError::Pddl { path, line, column, found, expected } => {
            set("path", path.into());
            set("line", (*line as u32).into());
            set("column", (*column as u32).into());
            set("found", found.into());
            set("expected", expected.into());
        }
        DocumentError::Invalid { path, found, expected } => {
            set("path", path.into());
            set("found", found.into());
            set("expected", expected.into());
        }
    }
    value
}
