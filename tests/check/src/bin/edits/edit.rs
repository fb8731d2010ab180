use gallery::{Step, workspace};
use std::{error::Error, fs};

/// One place of a file, and what stands there instead.
#[derive(Clone, Debug)]
pub struct Change {
    /// The step whose file it is.
    pub step: Step,
    /// The file, in the folder `src` of the step.
    pub file: String,
    /// What stands there: whole lines, or a part of one.
    pub old: String,
    /// What a reader may write.
    pub new: String,
}

/// What `check` has to tell.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// The stage that is wrong, and others that may be called so, too.
    pub stages: Vec<String>,
    /// One of these words has to be told.
    pub words: Vec<String>,
}

impl Fault {
    /// Whether it may be told in this stage.
    pub fn is_in(&self, stage: &str) -> bool {
        self.stages.iter().any(|one| one == stage)
    }
}

/// An edit of the steps such as a reader may make, or several of them.
#[derive(Clone, Debug, Default)]
pub struct Edit {
    /// What is wrong; no other edit has this title.
    pub title: String,
    /// The places; one, where it is not made of several edits.
    pub changes: Vec<Change>,
    /// The options of the programs.
    pub options: Vec<String>,
    /// What `check` has to tell, for each change.
    pub faults: Vec<Fault>,
}

impl Edit {
    /// The steps whose pictures may show it, in order.
    pub fn steps(&self) -> &'static [Step] {
        let first = self.changes.iter().map(|change| change.step.number()).min();
        static ALL: [Step; 5] = Step::ALL;
        &ALL[first.map_or(0, |number| number - 1)..]
    }

    /// What there is of it in the picture of a step.
    pub fn until(&self, step: Step) -> Self {
        let pairs = self.changes.iter().zip(&self.faults);
        let pairs = pairs.filter(|(change, _)| change.step <= step);
        let (changes, faults) = pairs.map(|(c, f)| (c.clone(), f.clone())).unzip();
        Self { changes, faults, ..self.clone() }
    }

    /// What kind of edit it is, of which this is the first picture, or a later one.
    pub fn group(&self, is_first: bool) -> &'static str {
        match (&self.changes[..], &self.options[..]) {
            ([_], []) if is_first => "one edit, in the first step that shows it",
            ([_], []) => "one edit, in step 5",
            ([_], _) => "one edit, with other options",
            _ => "two edits",
        }
    }

    /// Its name in file names.
    pub fn name(&self) -> String {
        let kept =
            self.title.chars().map(|c| if c.is_alphanumeric() { c } else { '-' });
        kept.collect()
    }
}

/// All edits in the folder `edits`: those of each step, then those made of them.
///
/// A file is blocks of lines. `@` names the file of those below, the first line is the
/// title, `-` is what stands there, `+` what stands there instead, `=` the stages and
/// the words, `$` options, and `&` the title of an edit that this one is made of.
pub fn edits() -> Result<Vec<Edit>, Box<dyn Error>> {
    let mut edits = vec![];
    for step in Step::ALL {
        let mut file = String::new();
        for block in blocks(step.name())? {
            match block.strip_prefix("@ ") {
                Some(name) => file = name.to_owned(),
                None => edits.push(edit(&block, step, &file)?),
            }
        }
    }
    for block in blocks("several")? {
        edits.push(several(&block, &edits)?);
    }
    Ok(edits)
}

/// What stands between blank lines in a file of the folder, without its comments.
fn blocks(name: &str) -> Result<Vec<String>, Box<dyn Error>> {
    let path = workspace().join("tests/check/edits").join(format!("{name}.txt"));
    let text = fs::read_to_string(path)?;
    let is_told = |block: &&str| !block.is_empty() && !block.starts_with('#');
    Ok(text
        .split("\n\n")
        .map(str::trim_end)
        .filter(is_told)
        .map(Into::into)
        .collect())
}

/// The lines of a block that begin with this mark.
fn marked<'a>(block: &'a str, mark: &str) -> Vec<&'a str> {
    let lines = block.lines().filter_map(|line| line.strip_prefix(mark));
    lines.map(|line| line.strip_prefix(' ').unwrap_or(line)).collect()
}

fn edit(block: &str, step: Step, file: &str) -> Result<Edit, String> {
    let title = block.lines().next().unwrap_or_default().to_owned();
    let joined = |mark| unindented(&marked(block, mark).join("\n"));
    let change =
        Change { step, file: file.to_owned(), old: joined("-"), new: joined("+") };
    let [told] = marked(block, "=")[..] else {
        return Err(format!("no = in {block}"));
    };
    let (stages, words) = told.split_once(':').ok_or(format!("no : in {block}"))?;
    let list = |text: &str, mark| {
        let all = text.split(mark).map(|one: &str| one.trim().to_owned());
        all.filter(|one| !one.is_empty()).collect()
    };
    let fault = Fault { stages: list(stages, '/'), words: list(words, '|') };
    let options = marked(block, "$").join(" ");
    let options = options.split_whitespace().map(Into::into).collect();
    Ok(Edit { title, changes: vec![change], options, faults: vec![fault] })
}

/// An edit that is made of others, or another view of one.
fn several(block: &str, edits: &[Edit]) -> Result<Edit, String> {
    let options = marked(block, "$").join(" ");
    let options: Vec<_> = options.split_whitespace().map(Into::into).collect();
    let titles = marked(block, "&");
    let title = [titles.join(" + "), options.join(" ")].join(" ").trim().to_owned();
    let mut all = Edit { title, options, ..Edit::default() };
    for title in titles {
        let edit = edits.iter().find(|edit| edit.title == title);
        let edit = edit.ok_or(format!("there is no edit {title}"))?;
        all.changes.extend(edit.changes.iter().cloned());
        all.faults.extend(edit.faults.iter().cloned());
    }
    Ok(all)
}

/// Without the blanks at the beginnings of lines, which no compiler needs.
pub fn unindented(text: &str) -> String {
    let lines = text.split('\n').enumerate();
    let lines =
        lines.map(|(k, line)| if k == 0 { line } else { line.trim_start() });
    lines.collect::<Vec<_>>().join("\n")
}

impl Change {
    /// The file, seen from the root of the workspace.
    pub fn path(&self) -> String {
        format!("steps/{}/src/{}", self.step.name(), self.file)
    }

    /// The file's text with this change in it.
    pub fn applied(&self, text: &str) -> Result<String, String> {
        let text = unindented(text);
        match text.matches(&self.old).count() {
            1 => Ok(text.replace(&self.old, &self.new)),
            count => Err(format!("{count} times in {}: {}", self.file, self.old)),
        }
    }
}
