use crate::class::found_file::{Content, FoundFile, has_extension, has_picture_extension};
use crate::png_file::{FILE_BYTES, too_large_clause};
use crate::read_file::read_file_of_at_most;
use crate::{escape_for_terminal, find_name_in_file_name};
use course::{NAMED_SCENE_EXAMPLE, locked_names};
use flate2::read::DeflateDecoder;
use rawzip::{CompressionMethod, ZipArchive, ZipFileHeaderRecord, ZipSliceArchive};
use std::fs;
use std::io::{ErrorKind, Read};
use std::path::Path;

/// The most files and folders, and the most bytes that are unpacked.
const MOST_ENTRIES: u32 = 20_000;
const MOST_BYTES: u64 = 1 << 28;

/// All files in a folder or an archive, in so many folders and archives in each other, by their
/// names; or why it can't be read. Left out are hidden files, what Cargo builds, the locked
/// pictures, and what a Mac adds.
pub(crate) fn find_files(folder: &Path, most_folders: usize) -> Result<Vec<FoundFile>, String> {
    let mut search = Search {
        most_folders,
        names: locked_names().into_iter().chain([NAMED_SCENE_EXAMPLE]).collect(),
        files: vec![],
        entries_left: MOST_ENTRIES,
        bytes_left: MOST_BYTES,
    };
    if has_extension(&folder.to_string_lossy(), &["zip"]) && folder.is_file() {
        search.add_archive(&read_file_of_at_most(folder, MOST_BYTES)?, &[]);
        return Ok(search.files);
    }
    let path = escape_for_terminal(&folder.display().to_string());
    fs::read_dir(folder).map_err(|error| match error.kind() {
        ErrorKind::PermissionDenied => format!("{path} can't be read: no permission"),
        _ => format!("{path} is neither a folder nor a ZIP archive"),
    })?;
    search.add_folder(folder, &[]);
    Ok(search.files)
}

struct Search {
    most_folders: usize,
    /// The pictures of the course.
    names: Vec<&'static str>,
    files: Vec<FoundFile>,
    entries_left: u32,
    bytes_left: u64,
}

impl Search {
    fn add(&mut self, folders: &[String], name: &str, content: Content) {
        let picture = self.picture_of(name);
        self.files.push(FoundFile { path: join(folders, name), picture, content });
    }

    /// The picture of the course that the name of a file tells.
    fn picture_of(&self, name: &str) -> Option<&'static str> {
        let names = self.names.iter().copied();
        find_name_in_file_name(name, names).filter(|_| has_picture_extension(name))
    }

    fn add_unreadable(&mut self, folders: &[String], why: &str) {
        self.add(folders, "", Content::Unreadable(why.to_owned()));
    }

    /// Whether one more file or folder may be looked at.
    fn take_entry(&mut self) -> bool {
        let entries_left = self.entries_left.checked_sub(1);
        self.entries_left = entries_left.unwrap_or(0);
        entries_left.is_some()
    }

    fn add_folder(&mut self, folder: &Path, folders: &[String]) {
        let entries = match fs::read_dir(folder) {
            Err(_) => return self.add_unreadable(folders, "can't be read: no permission"),
            Ok(_) if self.most_folders < folders.len() => {
                return self.add_unreadable(folders, "is too deep");
            }
            Ok(entries) => entries,
        };
        let mut paths: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
        paths.sort();
        let count = self.files.len();
        for path in paths {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if is_left_out(&name) {
                continue;
            }
            if !self.take_entry() {
                return self.add_unreadable(folders, "has more files than are looked at");
            }
            match path.is_dir() {
                true => self.add_folder(&path, &join(folders, &name)),
                false => self.add_file(folders, &name, |_| Content::OnDisk(path.clone())),
            }
        }
        if self.files.len() == count {
            self.add(folders, "", Content::Unread);
        }
    }

    /// Adds a file, or what is in it if it is an archive; its content is asked for where it is
    /// needed, with the number of bytes that may still be unpacked.
    fn add_file(
        &mut self,
        folders: &[String],
        name: &str,
        content: impl FnOnce(&mut u64) -> Content,
    ) {
        let is_archive = has_extension(name, &["zip"]);
        if !is_archive && self.picture_of(name).is_none() {
            return self.add(folders, name, Content::Unread);
        }
        let bytes = match content(&mut self.bytes_left) {
            content if !is_archive => return self.add(folders, name, content),
            Content::OnDisk(path) => read_file_of_at_most(&path, MOST_BYTES),
            Content::Unpacked(bytes) => Ok(bytes),
            _ => Err("can't be unpacked".to_owned()),
        };
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
            if !self.take_entry() {
                return self.add_unreadable(folders, "has more files than are looked at");
            }
            if self.most_folders < around.len() {
                self.add(&around, &name, Content::Unreadable("is too deep".to_owned()));
                continue;
            }
            self.add_file(&around, &name, |bytes_left| {
                let bytes = unpack(&archive, &entry, bytes_left);
                bytes.map_or_else(Content::Unreadable, Content::Unpacked)
            });
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

fn is_left_out(name: &str) -> bool {
    name.starts_with('.')
        || ["__MACOSX", "target", "snapshots"].contains(&name)
        || name.ends_with(".snap.png")
}
