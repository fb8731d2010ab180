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
        search.add_archive(Ok(read_file_of_at_most(folder, MOST_BYTES)?), "");
    } else if fs::read_dir(folder).is_ok() {
        search.add_folder(folder, "");
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
    fn add(&mut self, path: String, content: Content) {
        let picture = picture_in_name(&path);
        self.files.push(FoundFile { path, picture, content });
    }

    fn add_unreadable(&mut self, path: &str, why: impl Into<String>) {
        self.add(path.to_owned(), Content::Unreadable(why.into()));
    }

    /// Whether one more file or folder may be looked at; if not, that is noted of the folder.
    fn take_entry(&mut self, path: &str, folder: &str) -> bool {
        if self.entries_left == 0 {
            self.add_unreadable(folder, "has more files than are looked at");
            return false;
        }
        self.entries_left -= 1;
        if self.most_folders < path.matches('/').count() {
            self.add_unreadable(path, "is too deep, so the rest there isn't looked at");
            return false;
        }
        true
    }

    /// Adds what is in a folder, whose own path ends with a `/` or is empty.
    fn add_folder(&mut self, on_disk: &Path, folder: &str) {
        let Ok(entries) = fs::read_dir(on_disk) else {
            return self.add_unreadable(folder, "can't be read");
        };
        let mut paths: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
        paths.sort();
        let count = self.files.len();
        for on_disk in paths {
            let name = on_disk.file_name().unwrap_or_default().to_string_lossy();
            if is_left_out(&name) {
                continue;
            }
            let path = format!("{folder}{name}");
            if !self.take_entry(&path, folder) {
                return;
            }
            if on_disk.is_dir() {
                self.add_folder(&on_disk, &(path + "/"));
            } else if is_archive(&path) {
                self.add_archive(read_file_of_at_most(&on_disk, MOST_BYTES), &(path + "/"));
            } else {
                self.add(path, Content::OnDisk(on_disk));
            }
        }
        if self.files.len() == count {
            self.add(folder.to_owned(), Content::Unpacked(vec![]));
        }
    }

    /// Adds what is in an archive, whose own path ends with a `/` or is empty.
    fn add_archive(&mut self, bytes: Result<Vec<u8>, String>, folder: &str) {
        let damaged = "is a damaged ZIP archive";
        let bytes = match bytes {
            Ok(bytes) => bytes,
            Err(why) => return self.add_unreadable(folder, why),
        };
        let Ok(archive) = ZipArchive::from_slice(&*bytes) else {
            return self.add_unreadable(folder, damaged);
        };
        let mut entries = archive.entries();
        loop {
            let entry = match entries.next_entry() {
                Ok(Some(entry)) => entry,
                Ok(None) => return,
                Err(_) => return self.add_unreadable(folder, damaged),
            };
            let path = String::from_utf8_lossy(entry.file_path().as_bytes()).into_owned();
            let names: Vec<_> = path.split(['/', '\\']).filter(|name| !name.is_empty()).collect();
            if entry.is_dir() || names.iter().any(|name| is_left_out(name)) {
                continue;
            }
            let path = format!("{folder}{}", names.join("/"));
            if !self.take_entry(&path, folder) {
                return;
            }
            let is_needed = is_archive(&path) || picture_in_name(&path).is_some();
            let bytes = match is_needed {
                true => unpack(&archive, &entry, &mut self.bytes_left),
                false => Ok(vec![]),
            };
            match is_archive(&path) {
                true => self.add_archive(bytes, &(path + "/")),
                false => self.add(path, bytes.map_or_else(Content::Unreadable, Content::Unpacked)),
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
    let damaged = "is damaged, or locked, in its archive";
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

fn is_archive(name: &str) -> bool {
    has_extension(name, &["zip"])
}

fn is_left_out(name: &str) -> bool {
    name.starts_with('.')
        || ["__MACOSX", "target", "snapshots"].contains(&name)
        || name.ends_with(".snap.png")
}
