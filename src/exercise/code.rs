//! Answer codes: seed and answer in a short text that can be copied, and that shows when it was changed.
//!
//! The bytes of a code are a version, the digest of the exercise, the seed, attempts and hints, the choices of the answer,
//! and a checksum over all of these. In text they are Crockford's base 32 (no letter can be taken for a digit) in groups
//! of five. The code proves which answer was given to which question. It holds no secret, so it does not prove who gave
//! it, nor how many attempts that took.

use std::sync::LazyLock;

use data_encoding::{Encoding, Specification};
use serde_json::json;
use sha2::{Digest as _, Sha256};
use thiserror::Error;

use super::answer::{Answer, MAX_ANSWER};
use super::block::Block;
use crate::domain::Document;

/// The first byte. Another layout of the bytes gets another.
const VERSION: u8 = 1;

/// Bytes of an exercise's digest.
const DIGEST: usize = 5;

/// Bytes of the checksum: of a hundred million changed codes about one in ten thousand times one passes.
const CHECKSUM: usize = 5;

/// Signs between two dashes.
const GROUP: usize = 5;

/// The longest code that is read, in signs; the longest that is written is shorter.
const MAX_SIGNS: usize = 8 * MAX_ANSWER;

/// The fewest signs of a code, about: its digest and its checksum alone have 16.
const FEWEST_SIGNS: usize = 20;

/// The signs of a code.
const SIGNS: &str = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";

/// Base 32 with the signs that people mistake for others read as those.
static ENCODING: LazyLock<Option<Encoding>> = LazyLock::new(|| {
    let mut specification = Specification::new();
    specification.symbols.push_str(SIGNS);
    for sign in ('a'..='z').chain(['I', 'L', 'O']) {
        // A code has no U.
        if sign != 'u' {
            specification.translate.from.push(sign);
            specification.translate.to.push(read_as(sign));
        }
    }
    specification.encoding().ok()
});

/// What an exercise is told apart by: its problem and its question, not the words around it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Digest([u8; DIGEST]);

impl Digest {
    /// The digest of a document with its exercise. Titles, introductions and hints may change without a new one.
    pub(super) fn new(document: &Document, block: &Block) -> Self {
        // Keys in the order of the alphabet, whatever order the text had.
        let text = json!([document, block.kind, block.vary]).to_string();
        let bytes = Sha256::digest(text.as_bytes());
        Self(std::array::from_fn(|index| bytes[index]))
    }
}

/// How often an answer was tried, and how many hints were shown, as the page counts it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tally {
    /// Answers tried, this one among them.
    pub attempts: u32,
    /// Hints shown.
    pub hints: u32,
}

/// Why a code is not graded.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum CodeError {
    /// The text is no code.
    #[error("no answer code")]
    NoCode,
    /// The checksum does not fit.
    #[error("the code was edited or is not complete")]
    Edited,
    /// The code is of a version that this program does not know.
    #[error("the code is of version {version}, which this program does not read")]
    Version {
        /// The version.
        version: u8,
    },
    /// The code is of another exercise.
    #[error("the code is of another exercise")]
    OtherExercise,
    /// The code is of another seed.
    #[error("the code is of seed {found}, expected {expected}")]
    OtherSeed {
        /// The seed of the code.
        found: u64,
        /// The seed that it should have.
        expected: u64,
    },
    /// The seed of the code has no variant.
    #[error("the exercise has no variant of seed {seed}")]
    NoVariant {
        /// The seed of the code.
        seed: u64,
    },
    /// The answer in the code does not fit the question.
    #[error("the code holds no answer to the question")]
    Answer,
}

/// What a code holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Read {
    /// The seed.
    pub(super) seed: u64,
    /// Attempts and hints.
    pub(super) tally: Tally,
    /// The choices of the answer.
    pub(super) choices: Vec<u32>,
}

fn checksum(payload: &[u8]) -> [u8; CHECKSUM] {
    let bytes = Sha256::new_with_prefix(b"mo-copp answer").chain_update(payload).finalize();
    std::array::from_fn(|index| bytes[index])
}

/// Writes a number in bytes of seven bits, the lowest first.
fn push(bytes: &mut Vec<u8>, mut number: u64) {
    while number >= 0x80 {
        bytes.push(number as u8 | 0x80);
        number >>= 7;
    }
    bytes.push(number as u8);
}

/// Reads such a number, in the shortest form that it has.
fn pull(bytes: &mut &[u8]) -> Option<u64> {
    let mut number = 0_u64;
    for shift in (0..64).step_by(7) {
        let (&byte, rest) = bytes.split_first()?;
        *bytes = rest;
        let part = u64::from(byte & 0x7f);
        if (part << shift) >> shift != part || (byte == 0 && shift > 0) {
            return None;
        }
        number |= part << shift;
        if byte & 0x80 == 0 {
            return Some(number);
        }
    }
    None
}

/// The code of an answer.
pub(super) fn write(digest: &Digest, seed: u64, answer: &Answer, tally: Tally) -> String {
    let mut bytes = vec![VERSION];
    bytes.extend(digest.0);
    push(&mut bytes, seed);
    push(&mut bytes, tally.attempts.into());
    push(&mut bytes, tally.hints.into());
    for &choice in answer.choices() {
        push(&mut bytes, choice.into());
    }
    bytes.extend(checksum(&bytes));
    let signs = ENCODING.as_ref().map(|encoding| encoding.encode(&bytes)).unwrap_or_default();
    let mut text = String::with_capacity(signs.len() + signs.len() / GROUP);
    for (index, sign) in signs.chars().enumerate() {
        if index > 0 && index % GROUP == 0 {
            text.push('-');
        }
        text.push(sign);
    }
    text
}

/// A code as it is compared: without what stands between its signs, each sign as it is read.
pub fn canonical(code: &str) -> String {
    code.chars().filter(|&sign| !is_between(sign)).map(read_as).collect()
}

/// Whether a text has the signs and the length of a code, whatever is in it.
pub fn is_like_code(text: &str) -> bool {
    canonical(text).len() >= FEWEST_SIGNS && is_of_signs(text)
}

/// Whether a text has signs of a code alone, and what may stand between them.
pub fn is_of_signs(text: &str) -> bool {
    canonical(text).chars().all(|sign| SIGNS.contains(sign))
}

/// Whether a text is a code as it was written, of whatever exercise: its checksum fits.
pub fn is_whole(text: &str) -> bool {
    let signs = canonical(text);
    // The checksum is worked out only where the version is right, as it seldom is by accident.
    let decoded = || ENCODING.as_ref()?.decode(signs.as_bytes()).ok();
    if signs.len() < FEWEST_SIGNS || signs.len() > MAX_SIGNS || !signs.starts_with('0') {
        return false;
    }
    decoded().is_some_and(|bytes| {
        let (payload, sum) = bytes.split_at(bytes.len().saturating_sub(CHECKSUM));
        payload.first() == Some(&VERSION) && checksum(payload) == sum
    })
}

/// Whether a sign may stand anywhere in a code: blanks, and the dashes and invisible signs that text processors put there.
pub fn is_between(sign: char) -> bool {
    sign.is_whitespace()
        || matches!(
            sign,
            '-' | '\u{ad}' | '\u{2010}'
                ..='\u{2015}' | '\u{2212}' | '\u{fe58}' | '\u{fe63}' | '\u{ff0d}'
        )
        || matches!(sign, '\u{200b}'..='\u{200f}' | '\u{2060}' | '\u{feff}')
}

/// Small letters are large ones, and letters that look like digits are those.
fn read_as(sign: char) -> char {
    match sign.to_ascii_uppercase() {
        'O' => '0',
        'I' | 'L' => '1',
        sign => sign,
    }
}

/// Reads a code.
pub(super) fn read(digest: &Digest, code: &str, seed: Option<u64>) -> Result<Read, CodeError> {
    let signs: String =
        code.chars().filter(|&sign| !is_between(sign)).take(MAX_SIGNS + 1).collect();
    let bytes_of = |signs: usize| signs * 5 / 8;
    let fits = (1 + DIGEST + 3 + CHECKSUM..=bytes_of(MAX_SIGNS)).contains(&bytes_of(signs.len()));
    if !fits || !signs.chars().all(|sign| SIGNS.contains(read_as(sign))) {
        return Err(CodeError::NoCode);
    }
    let encoding = ENCODING.as_ref().ok_or(CodeError::NoCode)?;
    // A last sign too many, or one that no code ends in.
    let bytes = encoding.decode(signs.as_bytes()).map_err(|_| CodeError::Edited)?;
    let (payload, sum) = bytes.split_at(bytes.len() - CHECKSUM);
    if checksum(payload) != sum {
        return Err(CodeError::Edited);
    }
    let (head, mut rest) = payload.split_at(1 + DIGEST);
    if head[0] != VERSION {
        return Err(CodeError::Version { version: head[0] });
    }
    if head[1..] != digest.0 {
        return Err(CodeError::OtherExercise);
    }
    let mut number = || pull(&mut rest).ok_or(CodeError::Answer);
    let found = number()?;
    let small = |number: u64| u32::try_from(number).map_err(|_| CodeError::Answer);
    let tally = Tally { attempts: small(number()?)?, hints: small(number()?)? };
    let mut choices = Vec::new();
    while !rest.is_empty() {
        choices.push(small(pull(&mut rest).ok_or(CodeError::Answer)?)?);
    }
    match seed {
        Some(expected) if expected != found => Err(CodeError::OtherSeed { found, expected }),
        _ => Ok(Read { seed: found, tally, choices }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_back_and_have_one_form() {
        for number in [0, 1, 127, 128, 300, u64::from(u32::MAX), u64::MAX] {
            let mut bytes = Vec::new();
            push(&mut bytes, number);
            let mut rest = &bytes[..];
            assert_eq!((pull(&mut rest), rest.len()), (Some(number), 0));
        }
        assert_eq!(pull(&mut &[0x80, 0x00][..]), None);
        assert_eq!(pull(&mut &[0xff; 11][..]), None);
        assert_eq!(pull(&mut &[][..]), None);
    }

    #[test]
    fn the_signs_are_those_of_crockford() {
        let encoding = ENCODING.as_ref().unwrap();
        assert_eq!(encoding.encode(&[0xff, 0x00, 0xff, 0x00, 0xff]), "ZW0FY07Z");
        assert_eq!(encoding.decode(b"zw0fy07z").unwrap(), [0xff, 0x00, 0xff, 0x00, 0xff]);
        assert_eq!(encoding.decode(b"ZWOFYO7Z").unwrap(), [0xff, 0x00, 0xff, 0x00, 0xff]);
        assert!(encoding.decode(b"U").is_err());
    }
}
