use crate::evidence::{Evidence, Pixel};
use std::cell::Cell;

/// The lowest and the highest bytes of a pixel.
pub(crate) type Range = [[u8; 3]; 2];

/// Something that may have happened to a picture: a sentence, where in the code, and a
/// function from pixels to colours.
pub(crate) struct Explanation<'a> {
    /// Sentences for the reader, if it holds.
    pub sentence: String,
    /// Files to go back to, such as `step01_rays/rgb8.rs`.
    pub files: Vec<&'static str>,
    /// The lowest and the highest bytes that it gives a pixel.
    pub colours: Box<dyn Fn(&Pixel) -> Range + 'a>,
    /// How many rays its colours take.
    pub rays: u32,
    /// One pixel of so many may be another, which is counted and told; 0 where none may.
    pub exceptions: usize,
}

impl<'a> Explanation<'a> {
    /// One that gives each pixel exactly one colour.
    pub fn exact(
        sentence: impl Into<String>,
        files: &[&'static str],
        colour: impl Fn(&Pixel) -> [u8; 3] + 'a,
    ) -> Self {
        Self::within_range(sentence, files, move |pixel| [colour(pixel); 2])
    }

    /// One that gives each pixel a range of colours.
    pub fn within_range(
        sentence: impl Into<String>,
        files: &[&'static str],
        colours: impl Fn(&Pixel) -> Range + 'a,
    ) -> Self {
        Self {
            sentence: sentence.into(),
            files: files.to_vec(),
            colours: Box::new(colours),
            rays: 1,
            exceptions: 0,
        }
    }

    /// Number of pixels that have another colour than it gives them; None where these are
    /// too many.
    fn count_exceptions(&self, evidence: &Evidence, budget: &RayBudget) -> Option<usize> {
        let most_exceptions = evidence.pixels.len().checked_div(self.exceptions).unwrap_or(0);
        let most_exceptions = most_exceptions.min(evidence.wrong_pixels().len() / 100);
        let mut count = 0;
        for pixel in &evidence.pixels {
            if !budget.spend(self.rays) {
                return None;
            }
            let [low, high] = (self.colours)(pixel);
            let is_between = (0..3).all(|k| (low[k]..=high[k]).contains(&pixel.yours[k]));
            count += usize::from(!is_between);
            if most_exceptions < count {
                return None;
            }
        }
        Some(count)
    }
}

/// The range of some colours, and so much beyond it.
pub(crate) fn range_with_margin(colours: &[[u8; 3]], margin: u8) -> Range {
    let mut range = [[255; 3], [0; 3]];
    for colour in colours {
        for k in 0..3 {
            range[0][k] = range[0][k].min(colour[k].saturating_sub(margin));
            range[1][k] = range[1][k].max(colour[k].saturating_add(margin));
        }
    }
    range
}

/// Rays that may still be computed for an answer: the bound of its time, the same on
/// every machine.
pub(crate) struct RayBudget {
    rays: Cell<u32>,
}

impl RayBudget {
    /// Work for one answer.
    pub fn new(rays: u32) -> Self {
        Self { rays: Cell::new(rays) }
    }

    /// Takes so many from it; false where fewer are left.
    pub fn spend(&self, rays: u32) -> bool {
        let rays_left = self.rays.get().checked_sub(rays);
        self.rays.set(rays_left.unwrap_or(0));
        rays_left.is_some()
    }
}

/// The first explanation that gives the whole picture: the loop of `check`. What it tells
/// says in how many pixels it does not, where it may.
pub(crate) fn find_first_that_holds<'a>(
    evidence: &Evidence,
    mut explanations: impl Iterator<Item = Explanation<'a>>,
    budget: &RayBudget,
) -> Option<Explanation<'a>> {
    explanations.find_map(|mut explanation| {
        let exceptions = explanation.count_exceptions(evidence, budget)?;
        if 0 < exceptions {
            explanation.sentence += &format!(" All but {exceptions} pixels are so.");
        }
        Some(explanation)
    })
}
