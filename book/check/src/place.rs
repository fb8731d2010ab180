use crate::Step;

/// A file of a step, and where else a reader meets what is in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The step.
    pub step: Step,
    /// The file, in the folder `src` of the step.
    pub file: &'static str,
    /// The heading of its section, in the chapter of the step.
    pub section: &'static str,
    /// The test in the step's `tests/by_hand.rs` whose numbers go through it.
    pub test: &'static str,
}

/// The files to which an answer may lead, with their sections and tests.
pub fn places() -> impl Iterator<Item = Place> {
    let lines = include_str!("../mistakes/files.txt").lines();
    lines.filter_map(|line| {
        let mut parts = line.split('|').map(str::trim);
        let (step, file) = parts.next()?.split_once('/')?;
        let (section, test) = (parts.next()?, parts.next()?);
        Some(Place { step: Step::named(step)?, file, section, test })
    })
}

/// The place `name`, such as `step01_rays/camera.rs`.
pub(crate) fn place(name: &str) -> Option<Place> {
    places().find(|place| format!("{}/{}", place.step.name(), place.file) == name)
}

impl Place {
    /// The file, seen from the root of the workspace.
    pub fn path(&self) -> String {
        format!("steps/{}/src/{}", self.step.name(), self.file)
    }

    /// The place of a file, seen from the root of the workspace.
    pub fn of(path: &str) -> Option<Self> {
        places().find(|place| place.path() == path)
    }

    /// How to run the test.
    pub fn command(&self) -> String {
        format!("cargo test -p {} --test by_hand {}", self.step.name(), self.test)
    }
}

/// Where to go back to, and the tests by hand that tell more.
pub(crate) fn back(places: &[Place]) -> String {
    let Some(first) = places.first() else { return String::new() };
    let mut files: Vec<(Step, Vec<&str>, Vec<&str>)> = vec![];
    for place in places {
        let of = files.iter().position(|(step, ..)| *step == place.step);
        let at = of.unwrap_or(files.len());
        if of.is_none() {
            files.push((place.step, vec![], vec![]));
        }
        files[at].1.push(place.file);
        if !files[at].2.contains(&place.test) {
            files[at].2.push(place.test);
        }
    }
    let compare = files.iter().map(|(step, files, _)| {
        format!("{} in steps/{}/src", and(files), step.name())
    });
    let compare: Vec<_> = compare.collect();
    let (step, _, tests) = &files[0];
    let test = match tests[..] {
        [test] => format!(" {test}"),
        _ => format!(" (first: {})", tests.join(", ")),
    };
    format!(
        "Go back to step {}, \"{}\", and compare with {}.\n\
         Your tests by hand name the function: cargo test -p {} --test by_hand{test}\n",
        first.step.number(),
        first.section,
        compare.join(", and "),
        step.name(),
    )
}

fn and(names: &[&str]) -> String {
    match names {
        [all @ .., last] if !all.is_empty() => {
            format!("{} and {last}", all.join(", "))
        }
        _ => names.join(""),
    }
}
