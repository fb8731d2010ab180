use crate::{Parts, Section, mistakes};

/// A part of the program that may be another than ours.
#[derive(Clone, Copy, Debug)]
pub(super) struct Alternative {
    /// Where it belongs.
    pub section: Section,
    /// What is wrong, to be read after "it is what you get when".
    pub when: &'static str,
    /// Replaces the part.
    pub change: fn(&mut Parts),
}

/// All that are tried: those of the gallery, and others.
pub(super) fn alternatives() -> impl Iterator<Item = Alternative> {
    mistakes().map(|m| Alternative {
        section: m.section,
        when: m.when,
        change: m.change,
    })
}
