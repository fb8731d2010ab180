//! Replaces files atomically.

use std::path::Path;
use std::sync::atomic::{AtomicU32, Ordering};
use std::{fs, io, process};

/// The number of calls of `replace_file` so far, which makes each draft's name unique.
static COUNT: AtomicU32 = AtomicU32::new(0);

/// Replaces a file atomically: writes a draft beside the file, then renames the draft. If writing
/// or renaming fails, the old file stays as it was. No other program ever sees a half-written file.
/// If `path` is a symbolic link, replaces the link itself, not the file that the link points to.
pub fn replace_file(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    // The draft's name doesn't contain the file's name, which may already be as long as the system
    // allows.
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
    fn file_is_replaced_and_an_error_leaves_no_draft_behind() {
        let folder = env::temp_dir().join(format!("replace_file-{}", process::id()));
        let _ = fs::remove_dir_all(&folder);
        let inner = folder.join("inner");
        fs::create_dir_all(inner.join("more")).expect("the folders can be created");
        let file = folder.join(format!("{}.md", "a".repeat(200)));
        for text in ["old", "new"] {
            replace_file(&file, text.as_bytes()).expect("the file can be replaced");
            assert_eq!(fs::read_to_string(&file).expect("the file can be read"), text);
        }
        // A folder that isn't empty can't be replaced by a file.
        assert!(replace_file(&inner, b"text").is_err());
        assert_eq!(fs::read_dir(&folder).expect("the folder can be read").count(), 2);
        fs::remove_dir_all(folder).expect("the folder can be removed");
    }
}
