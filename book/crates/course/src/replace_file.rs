//! Replaces files atomically.

use std::path::Path;
use std::sync::atomic::{AtomicU32, Ordering};
use std::{fs, io, process};

/// The number of files that this program has replaced so far. It makes each draft's name unique.
static COUNT: AtomicU32 = AtomicU32::new(0);

/// Replaces a file atomically, by writing a draft beside it and renaming the draft. If this fails,
/// the old file is untouched, and no one ever sees a half-written one. A symbolic link is replaced,
/// not followed.
pub fn replace_file(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    // A short name, because the name of the file itself may be as long as the system allows.
    let draft = path.with_file_name(format!(".draft-{}-{number}", process::id()));
    let result = fs::write(&draft, bytes).and_then(|()| fs::rename(&draft, path));
    if result.is_err() {
        let _ = fs::remove_file(&draft);
    }
    result
}
