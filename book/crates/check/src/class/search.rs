use crate::class::found_file::{Content, FoundFile, has_extension, picture_in_name};
use crate::png_file::{FILE_BYTES, too_large_clause};
use crate::read_file::{escape_for_terminal, read_file_of_at_most};
use flate2::read::DeflateDecoder;
use rawzip::{CompressionMethod, ZipArchive, ZipFileHeaderRecord, ZipSliceArchive};
use std::fs;
use std::io::Read;
use std::path::Path;

/// The most folders, one in the other, around a file of a class.
pub(crate) const MOST_FOLDERS: usize = 8;

/// The most files, and the most bytes that are unpacked.
const MOST_FILES: usize = 20_000;
const MOST_BYTES: u64 = 1 << 28;

/// All files in a folder or an archive, in so many folders and archives in each other, by their
/// names; or why it can't be read. Left out are hidden files, what Cargo builds, the locked
/// pictures, and what a Mac adds; links aren't followed.
pub(crate) fn find_files(folder: &Path, most_folders: usize) -> Result<Vec<FoundFile>, String> {
    let mut search = Search { most_folders, files: vec![], bytes_left: MOST_BYTES };
    let is_file = has_extension(&folder.to_string_lossy(), &["zip"]) && folder.is_file();
    let result = match is_file.then(|| read_file_of_at_most(folder, MOST_BYTES)) {
        Some(bytes) => search.add_archive(&bytes?, ""),
        None => search.add_folder(folder, ""),
    };
    let path = escape_for_terminal(&folder.display().to_string());
    result.map_err(|why| format!("{path} {why}"))?;
    Ok(search.files)
}

struct Search {
    most_folders: usize,
    files: Vec<FoundFile>,
    bytes_left: u64,
}

impl Search {
    /// Adds a file; where there are too many, that is noted once.
    fn add(&mut self, path: String, content: Content) {
        let content = match self.files.len() {
            MOST_FILES => Content::Unreadable("and the rest: too many files".to_owned()),
            _ => content,
        };
        let picture = picture_in_name(&path);
        self.files.push(FoundFile { path, picture, content });
        self.files.truncate(MOST_FILES + 1);
    }

    /// Adds what a function finds in a folder or an archive, and why there is no more.
    fn enter(&mut self, folder: &str, find: impl FnOnce(&mut Self) -> Result<(), String>) {
        let result = match self.most_folders < folder.matches('/').count() {
            true => Err("is too deep, so it isn't looked at".to_owned()),
            false => find(self),
        };
        if let Err(why) = result {
            self.add(folder.to_owned(), Content::Unreadable(why));
        }
    }

    /// Adds what is in a folder, whose own path ends with a `/` or is empty.
    fn add_folder(&mut self, on_disk: &Path, folder: &str) -> Result<(), String> {
        let entries = fs::read_dir(on_disk).map_err(|_| "is no folder that can be read")?;
        let mut paths: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
        paths.sort();
        let count = self.files.len();
        for on_disk in paths {
            let name = on_disk.file_name().unwrap_or_default().to_string_lossy();
            let (path, inside) = (format!("{folder}{name}"), format!("{folder}{name}/"));
            if is_left_out(&name) {
                continue;
            } else if on_disk.is_symlink() {
                self.add(path, Content::Unreadable("is a link, which isn't followed".into()));
            } else if on_disk.is_dir() {
                self.enter(&inside, |search| search.add_folder(&on_disk, &inside));
            } else if has_extension(&path, &["zip"]) {
                self.enter(&inside, |search| {
                    search.add_archive(&read_file_of_at_most(&on_disk, MOST_BYTES)?, &inside)
                });
            } else {
                self.add(path, Content::OnDisk(on_disk));
            }
        }
        if self.files.len() == count {
            self.add(folder.to_owned(), Content::Unpacked(vec![]));
        }
        Ok(())
    }

    /// Adds what is in an archive, whose own path ends with a `/` or is empty.
    fn add_archive(&mut self, bytes: &[u8], folder: &str) -> Result<(), String> {
        let damaged = "is no ZIP archive, or a damaged one";
        let archive = ZipArchive::from_slice(bytes).map_err(|_| damaged)?;
        for entry in archive.entries() {
            let entry = entry.map_err(|_| damaged)?;
            let path = String::from_utf8_lossy(entry.file_path().as_bytes()).into_owned();
            let names: Vec<_> = path.split(['/', '\\']).filter(|name| !name.is_empty()).collect();
            if entry.is_dir() || names.iter().any(|name| is_left_out(name)) {
                continue;
            }
            let path = format!("{folder}{}", names.join("/"));
            let is_source_or_picture =
                has_extension(&path, &["rs"]) || picture_in_name(&path).is_some();
            if has_extension(&path, &["zip"]) {
                let bytes = unpack(&archive, &entry, &mut self.bytes_left);
                let inside = path + "/";
                self.enter(&inside, |search| search.add_archive(&bytes?, &inside));
            } else if is_source_or_picture {
                let bytes = unpack(&archive, &entry, &mut self.bytes_left);
                self.add(path, bytes.map_or_else(Content::Unreadable, Content::Unpacked));
            } else {
                self.add(path, Content::Unpacked(vec![]));
            }
        }
        Ok(())
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
        return Err(match most_bytes {
            FILE_BYTES => too_large_clause(FILE_BYTES),
            _ => format!("isn't unpacked: the limit for all files is {} MB", MOST_BYTES >> 20),
        });
    }
    Ok(bytes)
}

fn is_left_out(name: &str) -> bool {
    name.starts_with('.')
        || ["__MACOSX", "target", "snapshots"].contains(&name)
        || name.ends_with(".snap.png")
}
