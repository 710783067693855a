//! Errors as JavaScript throws them.

use wasm_bindgen::JsValue;

use crate::document::DocumentError;
use crate::plan::PlanError;
use crate::solver::SolveError;

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

/// A `SolveError`.
pub(super) fn solve(error: &SolveError) -> JsValue {
    thrown("SolveError", &error.to_string())
}

/// A `DocumentError`, with its place as properties.
pub(super) fn document(error: &DocumentError) -> JsValue {
    let value = thrown("DocumentError", &error.to_string());
    // Setting a property of a new object cannot fail.
    let set = |key: &str, property: JsValue| {
        let _ = js_sys::Reflect::set(&value, &key.into(), &property);
    };
    match error {
        DocumentError::Syntax { line, column, found, expected } => {
            set("line", (*line as u32).into());
            set("column", (*column as u32).into());
            set("found", found.into());
            set("expected", expected.into());
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
