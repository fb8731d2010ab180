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

#[cfg(test)]
mod tests {
    use super::*;
    use std::env;

    #[test]
    fn file_is_replaced_and_an_error_leaves_nothing_behind() {
        let folder = env::temp_dir().join(format!("replace_file-{}", process::id()));
        let _ = fs::remove_dir_all(&folder);
        let inner = folder.join("inner");
        fs::create_dir_all(inner.join("more")).expect("a folder");
        let file = folder.join(format!("{}.md", "a".repeat(200)));
        for text in ["old", "new"] {
            replace_file(&file, text.as_bytes()).expect("a file");
            assert_eq!(fs::read_to_string(&file).expect("a file"), text);
        }
        // A folder that isn't empty can't be replaced by a file.
        assert!(replace_file(&inner, b"text").is_err());
        assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 2);
        fs::remove_dir_all(folder).expect("removed");
    }
}
