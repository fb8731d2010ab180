use crate::answer::join_first;
use crate::{escape_for_terminal, find_name_in_file_name, read_bounded_file};
use course::{NAMED_SCENE_EXAMPLE, locked_names};
use std::path::PathBuf;

/// The extensions of files that may have been meant as a picture.
const PICTURE_EXTENSIONS: [&str; 14] = [
    "png", "jpg", "jpeg", "jfif", "webp", "gif", "bmp", "ppm", "tif", "tiff", "heic", "avif",
    "svg", "pdf",
];

/// The most names of files that a line tells.
const MOST_NAMES: usize = 8;

/// A file in a folder or in an archive.
pub(crate) struct FoundFile {
    /// The names of the folders and archives around it, then its own, which is empty for what
    /// has no files, with a `/` between them.
    pub path: String,
    /// The picture of the course that its name tells.
    pub picture: Option<&'static str>,
    pub content: Content,
}

pub(crate) enum Content {
    OnDisk(PathBuf),
    /// Empty if by its name it is neither a picture of the course nor Rust.
    Unpacked(Vec<u8>),
    /// Why it can't be read.
    Unreadable(String),
}

impl FoundFile {
    /// The file's name, as far as it has one.
    pub fn name(&self) -> &str {
        self.path.rsplit('/').next().unwrap_or_default()
    }

    /// How many folders and archives are around it.
    pub fn depth(&self) -> usize {
        self.path.matches('/').count()
    }

    /// The file's bytes, or why they can't be read.
    pub fn read(&self) -> Result<Vec<u8>, String> {
        match &self.content {
            Content::OnDisk(path) => read_bounded_file(path),
            Content::Unpacked(bytes) => Ok(bytes.clone()),
            Content::Unreadable(_) => Err(self.describe()),
        }
    }

    /// The file's path and, if it can't be read, why not.
    pub fn describe(&self) -> String {
        let path = self.path.trim_end_matches('/');
        match &self.content {
            Content::Unreadable(why) => format!("{path} {why}").trim_start().to_owned(),
            _ => path.to_owned(),
        }
    }

    pub fn is_unreadable(&self) -> bool {
        matches!(self.content, Content::Unreadable(_))
    }

    /// Whether it may have been meant as a picture, by its ending, or can't be read.
    pub fn may_be_picture(&self) -> bool {
        self.is_unreadable() || has_extension(self.name(), &PICTURE_EXTENSIONS)
    }

    /// The number at the end of the name of a file that was handed in again: `-2`, `(1)`.
    pub fn version(&self) -> u8 {
        let stem = self.name().rsplit_once('.').map_or("", |(stem, _)| stem);
        let number = stem.rsplit(['-', '(']).next().unwrap_or_default();
        number.trim_end_matches(')').parse().unwrap_or(0)
    }
}

/// A clause with the first of some files, and how many more there are; None where none are. What
/// can't be read comes first, with the reason.
pub(crate) fn unchecked_clause(mut files: Vec<FoundFile>) -> Option<String> {
    files.sort_by_key(|file| !file.is_unreadable());
    let told = files.iter().map(|file| escape_for_terminal(&file.describe())).collect();
    (!files.is_empty()).then(|| format!("not looked at: {}", join_first(told, MOST_NAMES, ", ")))
}

/// The pictures of the course, and the scene of a student's name.
pub(crate) fn picture_names() -> impl Iterator<Item = &'static str> + Clone {
    locked_names().into_iter().chain([NAMED_SCENE_EXAMPLE])
}

pub(crate) fn picture_in_name(path: &str) -> Option<&'static str> {
    let is_picture = has_extension(path, &PICTURE_EXTENSIONS);
    find_name_in_file_name(path, picture_names()).filter(|_| is_picture)
}

pub(crate) fn has_extension(name: &str, extensions: &[&str]) -> bool {
    let extension = name.rsplit_once('.').map(|(_, extension)| extension.to_lowercase());
    extension.is_some_and(|extension| extensions.contains(&&*extension))
}
