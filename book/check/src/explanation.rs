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
    /// Whether it says nothing of pixels that are right: there it is ours.
    pub only_wrong: bool,
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

    /// One with fitted numbers: a byte may be off by one.
    pub fn within_one(
        sentence: impl Into<String>,
        files: &[&'static str],
        colour: impl Fn(&Pixel) -> [u8; 3] + 'a,
    ) -> Self {
        Self::within_range(sentence, files, move |pixel| {
            let colour = colour(pixel);
            [
                colour.map(|c| c.saturating_sub(1)),
                colour.map(|c| c.saturating_add(1)),
            ]
        })
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
            only_wrong: false,
            exceptions: 0,
        }
    }

    /// Whether it gives the reader's colour in every pixel of a region.
    pub fn holds_in_region(
        &self,
        evidence: &Evidence,
        is_in_region: impl Fn(&Pixel) -> bool,
        budget: &RayBudget,
    ) -> bool {
        self.count_exceptions(evidence, is_in_region, budget) == Some(0)
    }

    /// Whether it gives the reader's colour in the first pixels of those that are compared.
    pub fn holds_in_first_pixels(
        &self,
        evidence: &Evidence,
        count: usize,
        budget: &RayBudget,
    ) -> bool {
        evidence.pixels[..count].iter().all(|pixel| {
            let [low, high] = (self.colours)(pixel);
            budget.spend(self.rays) && is_colour_between(low, pixel.yours, high)
        })
    }

    /// Number of pixels of a region in which it does not; None where these are too many.
    pub fn count_exceptions(
        &self,
        evidence: &Evidence,
        is_in_region: impl Fn(&Pixel) -> bool,
        budget: &RayBudget,
    ) -> Option<usize> {
        let most_exceptions =
            evidence.pixels.len().checked_div(self.exceptions).unwrap_or(0);
        let most_exceptions =
            most_exceptions.min(evidence.wrong_pixels().len() / 100);
        let mut count = 0;
        let pixels = if self.only_wrong {
            evidence.wrong_pixels()
        } else {
            &evidence.pixels
        };
        for pixel in pixels.iter().filter(|pixel| is_in_region(pixel)) {
            if !budget.spend(self.rays) {
                return None;
            }
            let [low, high] = (self.colours)(pixel);
            count += usize::from(!is_colour_between(low, pixel.yours, high));
            if most_exceptions < count {
                return None;
            }
        }
        Some(count)
    }
}

fn is_colour_between(low: [u8; 3], colour: [u8; 3], high: [u8; 3]) -> bool {
    (0..3).all(|k| low[k] <= colour[k] && colour[k] <= high[k])
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
    explanations: impl Iterator<Item = Explanation<'a>>,
    budget: &RayBudget,
) -> Option<Explanation<'a>> {
    explanations.into_iter().find_map(|mut explanation| {
        let exceptions =
            explanation.count_exceptions(evidence, |_| true, budget)?;
        if 0 < exceptions {
            explanation.sentence +=
                &format!(" All but {exceptions} pixels are so.");
        }
        Some(explanation)
    })
}
