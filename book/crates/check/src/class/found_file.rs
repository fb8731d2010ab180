use crate::png_file::{FILE_BYTES, too_large_clause};
use crate::read_file::read_bounded_file;
use flate2::read::DeflateDecoder;
use rawzip::{CompressionMethod, ZipArchive, ZipFileHeaderRecord, ZipSliceArchive};
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

/// The most folders around a file, the most files and folders, and the most bytes that are
/// unpacked.
const MOST_FOLDERS: usize = 8;
const MOST_ENTRIES: u32 = 100_000;
const MOST_BYTES: u64 = 1 << 29;

/// The extensions of files that may have been meant as a picture.
const PICTURE_EXTENSIONS: [&str; 14] = [
    "png", "jpg", "jpeg", "jfif", "webp", "gif", "bmp", "ppm", "tif", "tiff", "heic", "avif",
    "svg", "pdf",
];

/// A file in a folder or in an archive.
pub(crate) struct FoundFile {
    /// The names of the folders and archives around it, then its own, which is empty for what
    /// has no files.
    pub path: Vec<String>,
    pub content: Content,
}

/// What is in a file that may have been meant as a picture.
pub(crate) enum Content {
    OnDisk(PathBuf),
    Unpacked(Vec<u8>),
    /// Why it can't be read.
    Unreadable(String),
    /// Something else.
    NoPicture,
}

impl FoundFile {
    /// Its name, as far as it has one.
    pub fn name(&self) -> &str {
        self.path.last().map_or("", String::as_str)
    }

    /// Its bytes, or why they can't be read.
    pub fn read(&self) -> Result<Vec<u8>, String> {
        match &self.content {
            Content::OnDisk(path) => read_bounded_file(path),
            Content::Unpacked(bytes) => Ok(bytes.clone()),
            Content::Unreadable(_) | Content::NoPicture => Err(self.describe()),
        }
    }

    /// Its path and, if it can't be read, why not.
    pub fn describe(&self) -> String {
        let names: Vec<_> = self.path.iter().filter(|name| !name.is_empty()).collect();
        let path = names.iter().map(|name| name.as_str()).collect::<Vec<_>>().join("/");
        match &self.content {
            Content::Unreadable(why) => format!("{path} {why}").trim_start().to_owned(),
            _ => path,
        }
    }

    pub fn is_no_picture(&self) -> bool {
        matches!(self.content, Content::NoPicture)
    }
}

/// All files in a folder, in the folders in it, and in their archives, by their names. Left out
/// are hidden files, what Cargo builds, the locked pictures, and what a Mac adds.
pub(crate) fn find_files(folder: &Path) -> Vec<FoundFile> {
    let mut search = Search { files: vec![], entries_left: MOST_ENTRIES, bytes_left: MOST_BYTES };
    search.add_folder(folder, &[]);
    search.files
}

struct Search {
    files: Vec<FoundFile>,
    entries_left: u32,
    bytes_left: u64,
}

impl Search {
    fn add(&mut self, folders: &[String], name: &str, content: Content) {
        self.files.push(FoundFile { path: [folders, &[name.to_owned()]].concat(), content });
    }

    fn add_unreadable(&mut self, folders: &[String], why: impl Into<String>) {
        self.add(folders, "", Content::Unreadable(why.into()));
    }

    fn add_folder(&mut self, folder: &Path, folders: &[String]) {
        let entries = match fs::read_dir(folder) {
            Ok(_) if MOST_FOLDERS < folders.len() => {
                return self.add_unreadable(folders, "is too deep");
            }
            Ok(entries) => entries,
            Err(_) => return self.add_unreadable(folders, "may not be read by you"),
        };
        let mut paths: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
        paths.sort();
        let count = self.files.len();
        for path in paths {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if is_left_out(&name) {
                continue;
            }
            let Some(entries_left) = self.entries_left.checked_sub(1) else {
                return self.add_unreadable(folders, "has more files than are looked at");
            };
            self.entries_left = entries_left;
            if path.is_dir() {
                self.add_folder(&path, &[folders, &[name.into_owned()]].concat());
            } else if has_extension(&name, &["zip"]) {
                let around = [folders, &[without_extension(&name)]].concat();
                match read_archive(&path) {
                    Ok(bytes) => self.add_archive(&bytes, &around),
                    Err(why) => self.add_unreadable(&around, why),
                }
            } else {
                let is_picture = has_extension(&name, &PICTURE_EXTENSIONS);
                let content = Some(Content::OnDisk(path.clone())).filter(|_| is_picture);
                self.add(folders, &name, content.unwrap_or(Content::NoPicture));
            }
        }
        if self.files.len() == count {
            self.add(folders, "", Content::NoPicture);
        }
    }

    fn add_archive(&mut self, bytes: &[u8], folders: &[String]) {
        let Ok(archive) = ZipArchive::from_slice(bytes) else {
            return self.add_unreadable(folders, "is a damaged ZIP archive");
        };
        let mut entries = archive.entries();
        while let Ok(Some(entry)) = entries.next_entry() {
            let path = String::from_utf8_lossy(entry.file_path().as_bytes()).into_owned();
            let mut path: Vec<_> = path.split(['/', '\\']).map(str::to_owned).collect();
            path.retain(|name| !name.is_empty());
            let is_skipped = entry.is_dir() || path.iter().any(|name| is_left_out(name));
            let Some(name) = path.pop().filter(|_| !is_skipped) else { continue };
            let Some(entries_left) = self.entries_left.checked_sub(1) else {
                return self.add_unreadable(folders, "has more files than are looked at");
            };
            self.entries_left = entries_left;
            let around = [folders, &path].concat();
            let is_archive = has_extension(&name, &["zip"]) && around.len() < MOST_FOLDERS;
            if !is_archive && !has_extension(&name, &PICTURE_EXTENSIONS) {
                self.add(&around, &name, Content::NoPicture);
                continue;
            }
            match unpack(&archive, &entry, FILE_BYTES.min(self.bytes_left)) {
                Err(why) => self.add(&around, &name, Content::Unreadable(why)),
                Ok(bytes) => {
                    self.bytes_left -= bytes.len() as u64;
                    match is_archive {
                        true => self.add_archive(
                            &bytes,
                            &[&around[..], &[without_extension(&name)]].concat(),
                        ),
                        false => self.add(&around, &name, Content::Unpacked(bytes)),
                    }
                }
            }
        }
    }
}

/// The bytes of an archive, or why they can't be read.
fn read_archive(path: &Path) -> Result<Vec<u8>, String> {
    let size = fs::metadata(path).map_or(0, |metadata| metadata.len());
    match fs::read(path) {
        _ if MOST_BYTES < size => Err("is too large: unpack it first".into()),
        Ok(bytes) => Ok(bytes),
        Err(_) => Err("may not be read by you".into()),
    }
}

/// The bytes of a file in an archive, at most so many, or why they can't be unpacked.
fn unpack(
    archive: &ZipSliceArchive<&[u8]>,
    record: &ZipFileHeaderRecord,
    most_bytes: u64,
) -> Result<Vec<u8>, String> {
    let damaged = |_| "is damaged in its archive".to_owned();
    let entry = archive.get_entry(record.wayfinder()).map_err(|_| damaged(()))?;
    let data = entry.data();
    let reader: Box<dyn Read> = match record.compression_method() {
        CompressionMethod::STORE => Box::new(data),
        CompressionMethod::DEFLATE => Box::new(DeflateDecoder::new(data)),
        _ => return Err("is packed or locked in a way that isn't read here".into()),
    };
    let mut bytes = vec![];
    let reader = entry.verifying_reader(reader);
    reader.take(most_bytes + 1).read_to_end(&mut bytes).map_err(|_| damaged(()))?;
    if most_bytes < bytes.len() as u64 {
        return Err(too_large_clause());
    }
    Ok(bytes)
}

fn is_left_out(name: &str) -> bool {
    name.starts_with('.')
        || ["__MACOSX", "target", "snapshots"].contains(&name)
        || name.ends_with(".snap.png")
}

pub(crate) fn has_extension(name: &str, extensions: &[&str]) -> bool {
    let extension = name.rsplit_once('.').map(|(_, extension)| extension.to_lowercase());
    extension.is_some_and(|extension| extensions.contains(&&*extension))
}

fn without_extension(name: &str) -> String {
    name.rsplit_once('.').map_or(name, |(stem, _)| stem).to_owned()
}
