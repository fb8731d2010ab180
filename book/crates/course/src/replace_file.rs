//! Files that are replaced as a whole.

use std::path::Path;
use std::sync::atomic::{AtomicU32, Ordering};
use std::{fs, io, process};

/// The number of files that this program has written. Each draft gets a name of its own.
static COUNT: AtomicU32 = AtomicU32::new(0);

/// Replaces a file by writing a draft beside it and renaming that. An error leaves the old file as
/// it was, and nobody ever sees half of the new one. A link is replaced, not followed.
pub fn replace_file(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    // A short name, because that of the file may be as long as the system allows.
    let draft = path.with_file_name(format!(".draft-{}-{number}", process::id()));
    let result = fs::write(&draft, bytes).and_then(|()| fs::rename(&draft, path));
    if result.is_err() {
        let _ = fs::remove_file(&draft);
    }
    result
}
