//! Hashes of source text. What draws nothing doesn't count: comments, documentation, blank
//! lines, indentation, line ends.

use course::{fnv_1a, step_of_example, workspace};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// The folders of what a module may be made from.
const FOLDERS: [&str; 5] =
    ["steps", "book/crates/check", "book/crates/course", "book/crates/figures", "book/crates/page"];

/// What those folders have besides: what is made from the sources, and tests.
const NO_SOURCES: [&str; 4] = ["modules.txt", "mistakes", "tests", "benches"];

/// The hash of texts, one after the other.
pub fn hash_texts(texts: impl IntoIterator<Item = impl AsRef<str>>) -> u64 {
    let texts: Vec<_> = texts.into_iter().collect();
    fnv_1a(texts.iter().flat_map(|text| text.as_ref().bytes().chain([0])))
}

/// The tokens of Rust code, with a blank between them; those of other code are its lines.
pub fn tokens(code: &str) -> String {
    let mut words = vec![];
    match code.parse() {
        Ok(tokens) => push_tokens(tokens, &mut words),
        Err(_) => words.extend(code.lines().map(|line| line.trim().to_owned())),
    }
    words.retain(|word| !word.is_empty());
    words.join(" ")
}

/// Pushes tokens, but not `#[doc = "…"]` and `#![doc = "…"]`, which documentation becomes.
fn push_tokens(tokens: TokenStream, words: &mut Vec<String>) {
    for token in tokens {
        let TokenTree::Group(group) = token else {
            words.push(token.to_string());
            continue;
        };
        let is_attribute = group.delimiter() == Delimiter::Bracket;
        if is_attribute && group.stream().to_string().starts_with("doc =") {
            while words.pop_if(|word| word == "#" || word == "!").is_some() {}
            continue;
        }
        words.push(format!("{:?}", group.delimiter()));
        push_tokens(group.stream(), words);
        words.push("end".to_owned());
    }
}

/// The tokens of all sources and manifests, but for those below the paths `elsewhere`; of the
/// examples only those that are in the library.
pub fn source_texts(elsewhere: &[&str]) -> io::Result<Vec<String>> {
    let mut files = vec![];
    for folder in FOLDERS {
        push_files(&workspace().join(folder), &mut files)?;
    }
    files.retain(|path| !elsewhere.iter().any(|other| path.starts_with(workspace().join(other))));
    files.sort();
    files.iter().map(|path| Ok(tokens(&fs::read_to_string(path)?))).collect()
}

fn push_files(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        let (stem, end) = name.split_once('.').unwrap_or((name, ""));
        let is_program = folder.ends_with("examples") && step_of_example(stem).is_none();
        if NO_SOURCES.contains(&name) || is_program {
            continue;
        }
        if path.is_dir() {
            push_files(&path, files)?;
        } else if ["rs", "toml", "txt"].contains(&end) {
            files.push(path);
        }
    }
    Ok(())
}

/// The blocks of Cargo.lock about a package and all that it needs.
pub fn needed_packages(lock: &str, package: &str) -> Vec<String> {
    let lock = lock.replace('\r', "");
    let blocks: Vec<_> = lock.split("[[package]]\n").skip(1).collect();
    let name = |block: &&str| block.split('"').nth(1).unwrap_or_default().to_owned();
    let mut needed = BTreeSet::from([package.to_owned()]);
    loop {
        let count = needed.len();
        for block in &blocks {
            if !needed.contains(&name(block)) {
                continue;
            }
            let lines = block.lines().filter_map(|line| line.strip_prefix(" \""));
            needed.extend(lines.filter_map(|line| Some(line.split([' ', '"']).next()?.to_owned())));
        }
        if needed.len() == count {
            let found = blocks.iter().filter(|block| needed.contains(&name(block)));
            return found.map(|block| (*block).to_owned()).collect();
        }
    }
}
