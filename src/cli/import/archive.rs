//! Files out of archives, unpacked in memory and within limits.

use std::io::{Cursor, Read};

use mo_copp::domain::pddl::import::{FILES, ImportFile};

/// The most files and folders in an archive.
const MAX_ENTRIES: usize = 10_000;

/// The most bytes that an archive may unpack to, what is passed over included.
const MAX_UNPACKED: u64 = 256 << 20;

/// The most bytes of one file that is read.
const MAX_FILE: u64 = 32 << 20;

/// The first bytes of each kind of archive.
const GZIP: &[u8] = &[0x1f, 0x8b];
const BZIP2: &[u8] = b"BZh";
const ZIP: &[u8] = b"PK";

/// The files of a problem in an archive: `.tar`, `.tar.gz`, `.tar.bz2` or `.zip`, told apart by what they begin with.
/// Why not, where it cannot be read.
pub fn files(bytes: &[u8]) -> Result<Vec<ImportFile>, String> {
    if bytes.starts_with(ZIP) {
        zipped(bytes)
    } else if bytes.starts_with(GZIP) {
        tarred(flate2::read::MultiGzDecoder::new(bytes))
    } else if bytes.starts_with(BZIP2) {
        tarred(bzip2::read::MultiBzDecoder::new(bytes))
    } else {
        tarred(bytes)
    }
}

/// What has been taken out so far.
#[derive(Default)]
struct Taken {
    files: Vec<ImportFile>,
    entries: usize,
}

impl Taken {
    /// Counts an entry; its name is checked.
    fn count(&mut self, name: &str) -> Result<(), String> {
        self.entries += 1;
        if self.entries > MAX_ENTRIES {
            return Err(format!("found more than {MAX_ENTRIES} files, expected at most that"));
        }
        let out = |part: &str| part == "..";
        if name.starts_with(['/', '\\']) || name.split(['/', '\\']).any(out) {
            return Err(format!("found the file {name:?}, expected names inside of the archive"));
        }
        Ok(())
    }

    /// Reads a file of a problem.
    fn read(&mut self, name: String, from: impl Read) -> Result<(), String> {
        let mut bytes = Vec::new();
        from.take(MAX_FILE + 1).read_to_end(&mut bytes).map_err(|error| failed(&error))?;
        if bytes.len() as u64 > MAX_FILE {
            let most = MAX_FILE >> 20;
            return Err(format!("{name}: found more than {most} MiB, expected at most that"));
        }
        let text = String::from_utf8(bytes)
            .map_err(|_| format!("{name}: found bytes that are no text, expected UTF-8 text"))?;
        self.files.push(ImportFile { name, text });
        Ok(())
    }
}

fn failed(error: &std::io::Error) -> String {
    format!("found no archive that can be read ({error}), expected .tar, .tar.gz, .tar.bz2 or .zip")
}

/// Whether a file is one of a problem.
fn is_wanted(name: &str) -> bool {
    let base = name.rsplit(['/', '\\']).next().unwrap_or_default();
    FILES.iter().any(|file| base.eq_ignore_ascii_case(file))
}

/// Stops with an error where more comes than is allowed.
struct Bounded<R> {
    inner: R,
    left: u64,
}

impl<R: Read> Read for Bounded<R> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let count = self.inner.read(buffer)?;
        self.left = self.left.checked_sub(count as u64).ok_or_else(|| {
            std::io::Error::other(format!("it unpacks to more than {} MiB", MAX_UNPACKED >> 20))
        })?;
        Ok(count)
    }
}

fn tarred(from: impl Read) -> Result<Vec<ImportFile>, String> {
    let mut archive = tar::Archive::new(Bounded { inner: from, left: MAX_UNPACKED });
    let mut taken = Taken::default();
    for entry in archive.entries().map_err(|error| failed(&error))? {
        let entry = entry.map_err(|error| failed(&error))?;
        let name = String::from_utf8_lossy(&entry.path_bytes()).into_owned();
        taken.count(&name)?;
        // Links lead nowhere here.
        if entry.header().entry_type().is_file() && is_wanted(&name) {
            taken.read(name, entry)?;
        }
    }
    Ok(taken.files)
}

fn zipped(bytes: &[u8]) -> Result<Vec<ImportFile>, String> {
    let wrong = |error: zip::result::ZipError| failed(&std::io::Error::other(error));
    let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).map_err(wrong)?;
    let mut taken = Taken::default();
    for number in 0..archive.len() {
        let entry = archive.by_index(number).map_err(wrong)?;
        let name = entry.name().to_owned();
        taken.count(&name)?;
        if entry.is_file() && is_wanted(&name) {
            taken.read(name, entry)?;
        }
    }
    Ok(taken.files)
}
