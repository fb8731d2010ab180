use crate::class::found_file::{Content, FoundFile, has_extension, picture_in_name};
use crate::png_file::{FILE_BYTES, too_large_clause};
use crate::read_file::{escape_for_terminal, read_file_of_at_most};
use flate2::read::DeflateDecoder;
use rawzip::{CompressionMethod, ZipArchive, ZipFileHeaderRecord, ZipSliceArchive};
use std::fs;
use std::io::Read;
use std::path::Path;

/// The most files and folders, and the most bytes that are unpacked.
const MOST_ENTRIES: u32 = 20_000;
const MOST_BYTES: u64 = 1 << 28;

/// All files in a folder or an archive, in so many folders and archives in each other, by their
/// names; or why it can't be read. Left out are hidden files, what Cargo builds, the locked
/// pictures, and what a Mac adds.
pub(crate) fn find_files(folder: &Path, most_folders: usize) -> Result<Vec<FoundFile>, String> {
    let (entries_left, bytes_left) = (MOST_ENTRIES, MOST_BYTES);
    let mut search = Search { most_folders, files: vec![], entries_left, bytes_left };
    if is_archive(&folder.to_string_lossy()) && folder.is_file() {
        search.add_archive(&read_file_of_at_most(folder, MOST_BYTES)?, &[]);
    } else if fs::read_dir(folder).is_ok() {
        search.add_folder(folder, &[]);
    } else {
        let path = escape_for_terminal(&folder.display().to_string());
        return Err(format!("{path} is no folder or ZIP archive that can be read"));
    }
    Ok(search.files)
}

struct Search {
    most_folders: usize,
    files: Vec<FoundFile>,
    entries_left: u32,
    bytes_left: u64,
}

impl Search {
    fn add(&mut self, folders: &[String], name: &str, content: Content) {
        let (path, picture) = (join(folders, name), picture_in_name(name));
        self.files.push(FoundFile { path, picture, content });
    }

    fn add_unreadable(&mut self, folders: &[String], why: &str) {
        self.add(folders, "", Content::Unreadable(why.to_owned()));
    }

    /// Whether one more file or folder in these may be looked at; if not, that is noted.
    fn take_entry(&mut self, folders: &[String]) -> bool {
        if self.entries_left == 0 {
            self.add_unreadable(folders, "has more files than are looked at");
            return false;
        }
        self.entries_left -= 1;
        if self.most_folders < folders.len() {
            self.add_unreadable(folders, "is too deep, so the rest there isn't looked at");
            return false;
        }
        true
    }

    fn add_folder(&mut self, folder: &Path, folders: &[String]) {
        let Ok(entries) = fs::read_dir(folder) else {
            return self.add_unreadable(folders, "can't be read");
        };
        let mut paths: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
        paths.sort();
        let count = self.files.len();
        for path in paths {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if is_left_out(&name) {
                continue;
            }
            if !self.take_entry(folders) {
                return;
            }
            if path.is_dir() {
                self.add_folder(&path, &join(folders, &name));
            } else if is_archive(&name) {
                let bytes = read_file_of_at_most(&path, MOST_BYTES);
                self.add_archive_or_error(bytes, folders, &name);
            } else {
                self.add(folders, &name, Content::OnDisk(path.clone()));
            }
        }
        if self.files.len() == count {
            self.add(folders, "", Content::Unneeded);
        }
    }

    fn add_archive_or_error(
        &mut self,
        bytes: Result<Vec<u8>, String>,
        folders: &[String],
        name: &str,
    ) {
        match bytes {
            Ok(bytes) => self.add_archive(&bytes, &join(folders, name)),
            Err(why) => self.add(folders, name, Content::Unreadable(why)),
        }
    }

    fn add_archive(&mut self, bytes: &[u8], folders: &[String]) {
        let Ok(archive) = ZipArchive::from_slice(bytes) else {
            return self.add_unreadable(folders, "is a damaged ZIP archive");
        };
        let mut entries = archive.entries();
        loop {
            let entry = match entries.next_entry() {
                Ok(Some(entry)) => entry,
                Ok(None) => return,
                Err(_) => return self.add_unreadable(folders, "is a damaged ZIP archive"),
            };
            let path = String::from_utf8_lossy(entry.file_path().as_bytes()).into_owned();
            let mut path: Vec<_> = path.split(['/', '\\']).map(str::to_owned).collect();
            path.retain(|name| !name.is_empty());
            let is_skipped = entry.is_dir() || path.iter().any(|name| is_left_out(name));
            let Some(name) = path.pop().filter(|_| !is_skipped) else { continue };
            let around = [folders, &path].concat();
            if !self.take_entry(&around) {
                return;
            }
            if is_archive(&name) {
                let bytes = unpack(&archive, &entry, &mut self.bytes_left);
                self.add_archive_or_error(bytes, &around, &name);
            } else if picture_in_name(&name).is_some() {
                let bytes = unpack(&archive, &entry, &mut self.bytes_left);
                let content = bytes.map_or_else(Content::Unreadable, Content::Unpacked);
                self.add(&around, &name, content);
            } else {
                self.add(&around, &name, Content::Unneeded);
            }
        }
    }
}

/// The bytes of a file in an archive, which are taken from those that are left, or why they
/// can't be unpacked.
fn unpack(
    archive: &ZipSliceArchive<&[u8]>,
    record: &ZipFileHeaderRecord,
    bytes_left: &mut u64,
) -> Result<Vec<u8>, String> {
    let damaged = "is damaged in its archive";
    let entry = archive.get_entry(record.wayfinder()).map_err(|_| damaged)?;
    let reader: Box<dyn Read> = match record.compression_method() {
        CompressionMethod::STORE => Box::new(entry.data()),
        CompressionMethod::DEFLATE => Box::new(DeflateDecoder::new(entry.data())),
        _ => return Err("is packed or locked in a way that isn't read here".into()),
    };
    let (mut bytes, most_bytes) = (vec![], FILE_BYTES.min(*bytes_left));
    let reader = entry.verifying_reader(reader);
    let result = reader.take(most_bytes + 1).read_to_end(&mut bytes);
    *bytes_left = bytes_left.saturating_sub(bytes.len() as u64);
    result.map_err(|_| damaged)?;
    if most_bytes < bytes.len() as u64 {
        return Err(too_large_clause(most_bytes));
    }
    Ok(bytes)
}

/// The names of folders, and one more.
fn join(folders: &[String], name: &str) -> Vec<String> {
    [folders, &[name.to_owned()]].concat()
}

fn is_archive(name: &str) -> bool {
    has_extension(name, &["zip"])
}

fn is_left_out(name: &str) -> bool {
    name.starts_with('.')
        || ["__MACOSX", "target", "snapshots"].contains(&name)
        || name.ends_with(".snap.png")
}
