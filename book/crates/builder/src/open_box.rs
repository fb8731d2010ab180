//! Keeps track of which box in a chapter is open, and returns the HTML that opens and closes boxes.
//!
//! There are three kinds of boxes: folded boxes, the panels of pictures, and problems. Boxes don't
//! nest, except that a problem contains its answer. The same `{{#end}}` closes any box, and closes
//! an answer together with its problem. So there are four states:
//!
//! | State | Directive | Next state |
//! |---|---|---|
//! | no box | `predict`, `hints`, `aside`, `answer` | standalone box |
//! | no box | `pixel-panel` | standalone box |
//! | no box | `problem` | problem |
//! | problem | `answer` | answer |
//! | standalone box, answer | `end` | no box |
//!
//! In each state, all other directives for boxes are errors. If the state allows a box but the
//! box's first line contains an error, the box still counts as open. Otherwise the `{{#end}}` of
//! that box would be a second error. If a standalone box begins in a problem, before the answer,
//! the box replaces the problem as the open box. The next `{{#end}}` then closes the box, and isn't
//! a second error.
//!
//! A panel belongs to the last picture above it that has a probe. One wrapper contains the picture
//! and the panel, so that the panel can be in the margin. [`Boxes::await_panel`] opens the wrapper
//! before the picture, and stores the HTML that closes the wrapper after the panel. If the picture
//! has notes, `await_panel` opens no wrapper, because the picture and its notes already have a
//! wrapper.

use crate::fault::{ChapterError, ChapterResult};
use crate::folded_box::BoxKind;
use crate::problem::{NumberAndAnswer, OpenAnswer, OpenProblem, PositionPair};
use crate::{note, pixel_panel};

const DETAILS_END: &str = "</details>\n";

/// The state of the boxes while a chapter is read from top to bottom.
#[derive(Debug, Default)]
pub struct Boxes {
    open: Option<OpenBox>,
    /// The pictures so far whose panels are still missing.
    awaiting_panel: Vec<ProbedPicture>,
}

/// A box whose `{{#end}}` hasn't been reached yet.
#[derive(Debug)]
enum OpenBox {
    /// A folded box outside of a problem, or the panel of a picture. The box begins at `start` in
    /// the chapter, and `end_html` closes the box.
    Standalone { start: usize, end_html: String },
    /// A problem, up to its `{{#answer}}`.
    Problem(OpenProblem),
    /// The answer to a problem. One `{{#end}}` closes both the answer and the problem.
    Answer(OpenAnswer),
}

/// An interactive picture with a probe.
#[derive(Debug)]
struct ProbedPicture {
    name: &'static str,
    /// The start of the picture's paragraph in the chapter.
    start: usize,
    /// The HTML that closes the wrapper around the picture and the panel. This HTML is empty if the
    /// picture has notes, because the wrapper then ends after the last note.
    wrapper_end_html: String,
}

impl Boxes {
    /// Records a picture that has a probe. Such a picture needs a panel below it. The paragraph of
    /// the picture begins at `start`. Returns the HTML that goes before the picture.
    pub fn await_panel(&mut self, picture: &'static str, start: usize, has_notes: bool) -> String {
        let (wrapper_html, wrapper_end_html) = if has_notes {
            Default::default()
        } else {
            (note::wrapper_opening_html(), note::wrapper_closing_html())
        };
        self.awaiting_panel.push(ProbedPicture { name: picture, start, wrapper_end_html });
        wrapper_html
    }

    /// Opens the pixel panel of the picture `picture_name`. This picture must be the last one that
    /// still lacks its panel, and no box may be open. Otherwise, returns an error.
    pub fn begin_pixel_panel(&mut self, picture_name: &str, start: usize) -> ChapterResult<String> {
        let (html, wrapper_end_html) =
            match self.awaiting_panel.pop_if(|picture| picture.name == picture_name) {
                Some(picture) => {
                    (Ok(pixel_panel::opening_html(picture.name)), picture.wrapper_end_html)
                }
                None => {
                    (Err(ChapterError::PanelWithoutPicture(picture_name.to_owned())), String::new())
                }
            };
        self.begin_standalone_box(start, DETAILS_END.to_owned() + &wrapper_end_html)?;
        html
    }

    /// Opens a folded box, or the answer to the open problem. `html` is the expansion of the box's
    /// first line. Returns `html`, or an error if no box can begin here. If the box is the answer
    /// to a problem, the returned HTML begins with the form in which the reader enters a number.
    pub fn begin_folded_box(
        &mut self,
        kind: BoxKind,
        position: PositionPair,
        html: ChapterResult<String>,
    ) -> ChapterResult<String> {
        if kind == BoxKind::Answer
            && let Some(OpenBox::Problem(problem)) =
                self.open.take_if(|open| matches!(open, OpenBox::Problem(_)))
        {
            let form = problem.number_and_answer.as_ref().map(NumberAndAnswer::form_html);
            self.open = Some(OpenBox::Answer(problem.begin_answer(position)));
            html.map(|html| form.unwrap_or_default() + &html)
        } else {
            self.begin_standalone_box(position.in_text, DETAILS_END.to_owned())?;
            html
        }
    }

    /// Opens a folded box or a panel, which `end_html` closes. Returns an error if a box is open.
    fn begin_standalone_box(&mut self, start: usize, end_html: String) -> ChapterResult<()> {
        match &self.open {
            None => {
                self.open = Some(OpenBox::Standalone { start, end_html });
                Ok(())
            }
            // Replace the problem with this box, because the next `{{#end}}` is meant for the box.
            Some(OpenBox::Problem(problem)) => {
                self.open = Some(OpenBox::Standalone { start: problem.start, end_html });
                Err(ChapterError::MissingAnswer)
            }
            Some(_) => Err(ChapterError::BoxInBox),
        }
    }

    /// Returns an error if a box is open, because no problem can begin inside a box.
    pub fn ensure_problem_can_begin(&self) -> ChapterResult<()> {
        if self.open.is_none() { Ok(()) } else { Err(ChapterError::ProblemInBox) }
    }

    /// Opens a problem. Its first line begins at `start`, and its text begins at `text_start`.
    /// `number_and_answer` is None if the first line contains an error.
    pub fn begin_problem(
        &mut self,
        number_and_answer: Option<NumberAndAnswer>,
        start: usize,
        text_start: PositionPair,
    ) {
        self.open = Some(OpenBox::Problem(OpenProblem { number_and_answer, start, text_start }));
    }

    /// Returns the open answer to a problem. Returns None if no answer to a problem is open.
    pub fn open_answer_mut(&mut self) -> Option<&mut OpenAnswer> {
        match &mut self.open {
            Some(OpenBox::Answer(answer)) => Some(answer),
            _ => None,
        }
    }

    /// Closes the open box. Returns the HTML that closes the box on the page. If the box is the
    /// answer to a problem, returns the answer as well.
    pub fn end_box(&mut self) -> ChapterResult<(String, Option<OpenAnswer>)> {
        match self.open.take() {
            Some(OpenBox::Standalone { end_html, .. }) => Ok((end_html, None)),
            Some(OpenBox::Answer(answer)) => {
                Ok((DETAILS_END.to_owned() + "</section>\n", Some(answer)))
            }
            Some(OpenBox::Problem(_)) => Err(ChapterError::MissingAnswer),
            None => Err(ChapterError::EndWithoutBox),
        }
    }

    /// Finds what is still missing when the chapter ends: panels of pictures, and the `{{#end}}` of
    /// a box. Each error comes with the position of that picture or box.
    pub fn find_missing_ends_and_panels(&self) -> Vec<(usize, ChapterError)> {
        let open = self.open.iter().map(|open| {
            let start = match open {
                OpenBox::Standalone { start, .. } => *start,
                OpenBox::Problem(problem) => problem.start,
                OpenBox::Answer(answer) => answer.problem.start,
            };
            (start, ChapterError::MissingEndOfBox)
        });
        let pictures = self.awaiting_panel.iter();
        open.chain(
            pictures.map(|picture| (picture.start, ChapterError::MissingPanel(picture.name))),
        )
        .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn position(in_text: usize) -> PositionPair {
        PositionPair { in_text, in_expanded: in_text }
    }

    fn begin_folded_box(boxes: &mut Boxes, kind: BoxKind) -> Result<String, String> {
        let html = boxes.begin_folded_box(kind, position(8), Ok("html".to_owned()));
        html.map_err(|error| error.to_string())
    }

    fn end_box(boxes: &mut Boxes) -> Result<String, String> {
        boxes.end_box().map(|(html, _)| html).map_err(|error| error.to_string())
    }

    fn missing_ends_and_panels(boxes: &Boxes) -> Vec<String> {
        let parts = boxes.find_missing_ends_and_panels().into_iter();
        parts.map(|(position, error)| format!("{position}: {error}")).collect()
    }

    #[test]
    fn wrapper_of_a_picture_and_its_panel_is_closed_if_it_was_opened() {
        for (has_notes, wrappers) in [(true, 0), (false, 1)] {
            let mut boxes = Boxes::default();
            let opening = boxes.await_panel("step02_sphere", 0, has_notes);
            boxes.begin_pixel_panel("step02_sphere", 9).expect("the panel can begin");
            let ending = end_box(&mut boxes).expect("the panel can end");
            assert_eq!(opening.matches("<div").count(), wrappers, "{opening}");
            assert_eq!(ending.matches("</div>").count(), wrappers, "{ending}");
            assert_eq!(missing_ends_and_panels(&boxes), [""; 0]);
        }
    }

    #[test]
    fn each_picture_needs_its_own_panel() {
        let mut boxes = Boxes::default();
        boxes.await_panel("step02_sphere", 3, false);
        boxes.await_panel("step03_nearest", 5, false);
        let missing = |start, name| format!("{start}: {}", ChapterError::MissingPanel(name));
        let [first, second] = [missing(3, "step02_sphere"), missing(5, "step03_nearest")];
        assert_eq!(missing_ends_and_panels(&boxes), [first.clone(), second.clone()]);
        assert!(
            boxes.begin_pixel_panel("step02_sphere", 7).is_err(),
            "a panel has to be for the last picture"
        );
        end_box(&mut boxes).expect("the box can end");
        boxes.begin_pixel_panel("step03_nearest", 9).expect("the panel can begin");
        end_box(&mut boxes).expect("the box can end");
        assert_eq!(missing_ends_and_panels(&boxes), [first]);
    }

    #[test]
    fn one_end_closes_an_answer_and_its_problem() {
        let mut boxes = Boxes::default();
        boxes.begin_problem(None, 2, position(4));
        boxes.ensure_problem_can_begin().expect_err("a problem is open");
        begin_folded_box(&mut boxes, BoxKind::Answer).expect("the answer can begin");
        assert!(boxes.open_answer_mut().is_some());
        assert_eq!(
            missing_ends_and_panels(&boxes),
            [format!("2: {}", ChapterError::MissingEndOfBox)]
        );
        assert_eq!(end_box(&mut boxes).as_deref(), Ok("</details>\n</section>\n"));
        boxes.ensure_problem_can_begin().expect("no box is open");
    }

    #[test]
    fn error_is_reported_once_although_an_end_follows() {
        let error = |error: ChapterError| Err(error.to_string());
        let mut boxes = Boxes::default();
        assert_eq!(end_box(&mut boxes), error(ChapterError::EndWithoutBox));
        begin_folded_box(&mut boxes, BoxKind::Hints).expect("the box can begin");
        let inner = begin_folded_box(&mut boxes, BoxKind::Hints);
        assert_eq!(inner, error(ChapterError::BoxInBox));
        assert_eq!(end_box(&mut boxes).as_deref(), Ok(DETAILS_END));

        boxes.begin_problem(None, 2, position(4));
        let inner = begin_folded_box(&mut boxes, BoxKind::Hints);
        assert_eq!(inner, error(ChapterError::MissingAnswer));
        assert_eq!(end_box(&mut boxes).as_deref(), Ok(DETAILS_END));

        boxes.begin_pixel_panel("step02_sphere", 6).expect_err("there is no picture for the panel");
        assert_eq!(end_box(&mut boxes).as_deref(), Ok(DETAILS_END));
    }
}
