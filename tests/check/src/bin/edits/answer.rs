use crate::edit::{Change, Fault};

/// One line of the table of stages, and the numbers below it.
pub struct Told<'a> {
    /// The name of the stage.
    pub stage: &'a str,
    /// `right`, `WRONG`, or why it can't be told.
    pub verdict: &'a str,
    /// What is said of it.
    pub numbers: Vec<&'a str>,
}

impl Told<'_> {
    /// Whether it is one of the stages that a fault is in.
    pub fn is_of(&self, fault: &Fault) -> bool {
        fault.stages.iter().any(|stage| self.stage.contains(stage.as_str()))
    }

    /// Whether it tells a fault: as its stage, or as one of two that may be it.
    pub fn is_about(&self, fault: &Fault, changes: &[Change]) -> bool {
        let is_either =
            self.numbers.iter().any(|number| number.contains("or else"));
        self.is_of(fault) || is_either && self.points_at(fault, changes)
    }

    /// Whether its numbers hold one of the words of a fault, or the formula of the file
    /// that explains every pixel.
    pub fn points_at(&self, fault: &Fault, changes: &[Change]) -> bool {
        let is_line = |number: &&str| {
            let is_in =
                |change: &Change| number.contains(&format!("({})", change.path()));
            let is_told =
                number.contains("in every pixel") || number.contains("or else");
            is_told && changes.iter().any(is_in)
        };
        if self.numbers.iter().any(is_line) {
            return true;
        }
        let is_told = |word: &String| self.numbers.iter().any(|n| n.contains(word));
        fault.words.iter().any(is_told)
    }
}

/// The table of stages in an answer of `check`: a stage has two blanks before it, its
/// numbers have more.
pub fn stages(text: &str) -> Vec<Told<'_>> {
    let mut table: Vec<Told> = vec![];
    let lines = text.lines().skip_while(|line| !line.starts_with("Stage by stage"));
    for line in lines.skip(1).take_while(|line| line.starts_with("  ")) {
        match (line[2..].split_once("  "), table.last_mut()) {
            (Some(("", number)), Some(told)) => told.numbers.push(number.trim()),
            (Some((stage, verdict)), _) => {
                let verdict = verdict.trim();
                table.push(Told { stage, verdict, numbers: vec![] });
            }
            _ => {}
        }
    }
    table
}
