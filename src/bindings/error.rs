//! Errors as JavaScript throws them.

use wasm_bindgen::JsValue;

use crate::document::DocumentError;

/// An `Error` of this name.
pub(super) fn thrown(name: &str, message: &str) -> JsValue {
    let error = js_sys::Error::new(message);
    error.set_name(name);
    error.into()
}

/// A `DocumentError`, with its place as properties.
pub(super) fn document(error: &DocumentError) -> JsValue {
    let value = thrown("DocumentError", &error.to_string());
    // Setting a property of a new object cannot fail.
    let set = |key: &str, property: JsValue| {
        let _ = js_sys::Reflect::set(&value, &key.into(), &property);
    };
    match error {
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
