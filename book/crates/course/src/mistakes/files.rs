//! The text files of the mistakes: a list for each step, and a table. A native program contains the
//! texts of these files. A WebAssembly module doesn't contain the texts, so the module needn't be
//! compiled again after every edit of a list. A page loads the texts and provides them to its
//! module.

use crate::Step;
use std::iter;
use std::sync::OnceLock;

/// The separator between the texts, which a page loads as one joined text.
const SEPARATOR: char = '\0';

const STEP_COUNT: usize = Step::ALL.len();

const INCLUDED: MistakeFiles = MistakeFiles {
    lists: [
        include_str!("../../mistakes/step01_rays.txt"),
        include_str!("../../mistakes/step02_sphere.txt"),
        include_str!("../../mistakes/step03_nearest.txt"),
        include_str!("../../mistakes/step04_diffuse.txt"),
        include_str!("../../mistakes/step05_phong.txt"),
    ],
    table: include_str!("../../mistakes/table.txt"),
};

static PROVIDED: OnceLock<MistakeFiles> = OnceLock::new();

/// The texts of the mistakes' files.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MistakeFiles {
    /// The list of mistakes for each step.
    pub lists: [&'static str; STEP_COUNT],
    /// The table with the hashes of the pictures that the mistakes produce.
    pub table: &'static str,
}

impl MistakeFiles {
    /// Joins all texts into one that a page can load.
    pub fn join(&self) -> String {
        let texts: Vec<_> = self.lists.into_iter().chain([self.table]).collect();
        texts.join(&SEPARATOR.to_string())
    }

    /// Splits what [`Self::join`] has joined. If there are too few texts, the missing texts are
    /// empty.
    fn split(joined: &'static str) -> Self {
        let mut texts = joined.split(SEPARATOR).chain(iter::repeat(""));
        let mut next_text = || texts.next().unwrap_or_default();
        Self { lists: [(); STEP_COUNT].map(|()| next_text()), table: next_text() }
    }
}

/// Returns the texts. In the module that a page loads, returns None until the page has provided the
/// texts.
pub fn mistake_files() -> Option<&'static MistakeFiles> {
    if cfg!(target_arch = "wasm32") { PROVIDED.get() } else { Some(&INCLUDED) }
}

/// Gives the joined texts to the module that a page loads. Only the first call has an effect.
pub fn provide_mistake_files(joined: &str) {
    PROVIDED.get_or_init(|| MistakeFiles::split(String::from(joined).leak()));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joined_texts_are_split_again() {
        assert_eq!(MistakeFiles::split(INCLUDED.join().leak()), INCLUDED);
        let files = MistakeFiles::split("a\0b");
        assert_eq!(files, MistakeFiles { lists: ["a", "b", "", "", ""], table: "" });
    }
}
