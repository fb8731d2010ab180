//! The numbers of the chapters, computed when the book is built.

mod lecture_errata;
mod measure;
mod next;
mod step01;
mod step02;
mod step03;
mod step04;
mod step05;

use std::collections::BTreeMap;
use std::sync::LazyLock;

/// A number of a worked example, by name.
type Value = (&'static str, fn() -> String);

/// All values by their names. Each is computed once, when a page first asks for it.
static KNOWN: LazyLock<BTreeMap<&str, LazyLock<String>>> = LazyLock::new(|| {
    let lists = [
        step01::VALUES,
        step02::VALUES,
        step03::VALUES,
        step04::VALUES,
        step05::VALUES,
        lecture_errata::VALUES,
        next::VALUES,
    ];
    let values = lists.into_iter().flatten();
    values.map(|&(name, value)| (name, LazyLock::new(value))).collect()
});

/// The name of every value.
#[cfg(test)]
pub fn names() -> impl Iterator<Item = &'static str> {
    KNOWN.keys().copied()
}

/// The value of this name, with a hyphen for a minus.
pub fn get(name: &str) -> Result<String, String> {
    let value = KNOWN.get(name).map(|value| value.replace('−', "-"));
    value.ok_or(format!("there is no value {name}"))
}
