use course::Step;

/// A file of a step, with its section in the book and its tests.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SourceRef {
    /// The step.
    pub step: Step,
    /// The file, in the folder `src` of the step.
    pub file: &'static str,
    /// The heading of its section, in a chapter of the step.
    pub section: &'static str,
    /// The tests in the step's `tests/by_hand.rs` whose numbers go through it, with a
    /// comma between them.
    pub tests: &'static str,
}

/// The files to which an answer may lead, with their sections and tests.
pub fn source_refs() -> impl Iterator<Item = SourceRef> {
    let lines = include_str!("../sections_and_tests.txt").lines();
    lines.filter_map(|line| {
        let mut parts = line.split('|').map(str::trim);
        let (step, file) = parts.next()?.split_once('/')?;
        let (section, tests) = (parts.next()?, parts.next()?);
        Some(SourceRef { step: Step::from_name(step)?, file, section, tests })
    })
}

/// The place `name`, such as `step01_rays/camera.rs`.
pub(crate) fn find_source_ref(name: &str) -> Option<SourceRef> {
    source_refs().find(|place| format!("{}/{}", place.step.name(), place.file) == name)
}

impl SourceRef {
    /// The file, seen from the root of the workspace.
    pub fn workspace_path(&self) -> String {
        format!("steps/{}/src/{}", self.step.name(), self.file)
    }

    /// The place of a file, seen from the root of the workspace.
    pub fn from_path(path: &str) -> Option<Self> {
        source_refs().find(|place| place.workspace_path() == path)
    }
}

/// Tells where to go back to, and which tests by hand of the first step go through it.
pub(crate) fn go_back_sentences(refs: &[SourceRef]) -> String {
    let Some(SourceRef { step, section, .. }) = refs.first() else {
        return String::new();
    };
    let files: Vec<_> = refs.iter().map(SourceRef::workspace_path).collect();
    let refs_of_first_step = refs.iter().filter(|place| place.step == *step);
    let mut tests = vec![];
    for test in refs_of_first_step.flat_map(|place| place.tests.split(", ")) {
        if !tests.contains(&test) {
            tests.push(test);
        }
    }
    let name = step.name();
    format!(
        "Go back to step {}, \"{section}\", and compare with {}.\n\
         The tests by hand that you type at the end of the step name the function: cargo \
         test -p {name} --test by_hand, of which {} {} through it.\n",
        step.number(),
        files.join(", "),
        tests.join(" and "),
        if tests.len() == 1 { "goes" } else { "go" },
    )
}

/// Tells which tests by hand to run: those of some steps.
pub(crate) fn test_command_sentence(steps: &[Step]) -> String {
    let mut steps = steps.to_vec();
    steps.sort();
    steps.dedup();
    let packages: Vec<_> = steps.iter().map(|step| format!("-p {}", step.name())).collect();
    let ends = if steps.len() == 1 { "the step" } else { "each step" };
    format!(
        "The tests by hand that you type at the end of {ends} name the function: cargo \
         test {} --no-fail-fast --test by_hand\n",
        packages.join(" ")
    )
}
