//! Tests that run natively.
#![cfg(not(target_arch = "wasm32"))]
#![allow(missing_docs)]
