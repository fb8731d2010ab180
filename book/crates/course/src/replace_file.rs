//! Files that are replaced as a whole.

use std::path::Path;
use std::sync::atomic::{AtomicU32, Ordering};
use std::{fs, io, process};

/// How many files this program has written. Each draft gets a name of its own.
static COUNT: AtomicU32 = AtomicU32::new(0);

/// Writes a draft beside the file and renames it, so that an error leaves what was there, and nobody
/// ever sees half of the file. A link is replaced, not followed.
pub fn replace_file(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    // Short, as the name of the file may be as long as the system allows.
    let draft = path.with_file_name(format!(".draft-{}-{number}", process::id()));
    let result = fs::write(&draft, bytes).and_then(|()| fs::rename(&draft, path));
    if result.is_err() {
        let _ = fs::remove_file(&draft);
    }
    result
}
