use crate::{Answer, Verdict};

/// A student, and what there is of the pictures.
pub(crate) struct Report {
    pub student: String,
    /// Pictures that were asked for or are there, in the course's order.
    pub pictures: Vec<Entry>,
    /// A clause about what there is in place of pictures; None where nothing is.
    pub in_place: Option<String>,
}

/// A picture of the course, and what a student has of it.
pub(crate) struct Entry {
    pub name: &'static str,
    /// Whether it was asked for; all are if none was.
    pub counts: bool,
    /// The path of the file that was looked at, if there is one.
    pub file: String,
    pub answer: Answer,
    /// The earlier picture that is wrong by the same cause, and this cause.
    pub follows: Option<(&'static str, String)>,
}

impl Entry {
    /// What a student has of a picture. The pictures that an answer compares aren't kept.
    pub fn new(name: &'static str, counts: bool, file: String, answer: Answer) -> Self {
        let answer = Answer { compared: None, ..answer };
        Self { name, counts, file, answer, follows: None }
    }

    pub fn is_right(&self) -> bool {
        self.answer.verdict == Verdict::Right
    }

    pub fn is_missing(&self) -> bool {
        self.answer.verdict == Verdict::Missing
    }
}

impl Report {
    /// The pictures that count.
    pub fn counted(&self) -> impl Iterator<Item = &Entry> {
        self.pictures.iter().filter(|entry| entry.counts)
    }

    /// Such as `1 of 2`: how many of the pictures that count are right.
    pub fn count_text(&self) -> String {
        let right_count = self.counted().filter(|entry| entry.is_right()).count();
        format!("{right_count} of {}", self.counted().count())
    }

    /// Tells of each wrong picture which earlier one is wrong by the same cause, the only one
    /// that we know for one of the two.
    pub fn tell_common_causes(&mut self) {
        for k in 1..self.pictures.len() {
            let (earlier, later) = self.pictures.split_at_mut(k);
            let causes = &later[0].answer.causes;
            later[0].follows = earlier.iter().find_map(|one| {
                let cause = one.answer.causes.iter().find(|cause| causes.contains(cause))?;
                let is_sure = one.answer.causes.len() == 1 || causes.len() == 1;
                is_sure.then(|| (one.name, cause.words_and_file()))
            });
        }
    }
}
