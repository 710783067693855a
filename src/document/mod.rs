//! Reading problem documents: JSON with places.
//!
//! - `json` is a JSON value that remembers the order of keys and refuses a key given twice,
//! - `reader` walks it and knows where it is, so that every error names the place, what was found
//!   and what was expected,
//! - names are held to what an eye can tell apart,
//! - [`Place`] is where in the text an error stands, in lines and columns.
//!
//! What the documents of each format hold is the business of [`domain`](crate::domain).

mod error;
pub(crate) mod json;
mod name;
mod place;
pub(crate) mod reader;
mod scan;
mod syntax;

pub use error::DocumentError;
pub(crate) use name::Names;
pub use name::is_hidden;
#[cfg(feature = "full")]
pub(crate) use name::plain_name;
pub use place::Place;
