//! The figures: each is drawn by the step's own functions.

mod aspect_ratios;
mod attenuation;
mod ball;
mod eggs;
mod from_above;
mod frustum;
mod hits;
mod lambert;
mod lobes;
mod phong_vectors;
mod pinhole;
mod pyramid;
mod ray;
mod right_hand;
mod row;
mod three_cases;

pub use attenuation::ATTENUATION;
pub use eggs::EGGS;
pub use from_above::draw as from_above;
pub use frustum::FRUSTUM;
pub use hits::HITS;
pub use lambert::LAMBERT;
pub use lobes::LOBES;
pub use phong_vectors::PHONG_VECTORS;
pub use ray::RAY;
pub use row::ROW;
pub use three_cases::THREE_CASES;

use crate::svg::Drawing;

/// A drawing, what it shows, and what to look at.
#[derive(Debug)]
pub struct Figure {
    /// What it shows, for those who can't see it.
    pub title: &'static str,
    /// What to look at; Markdown, with formulas.
    pub caption: &'static str,
    /// The drawing itself.
    pub drawing: Drawing,
}

/// The name that a chapter calls a figure by, and what draws it.
type Named = (&'static str, fn() -> Figure);

const FIGURES: [Named; 14] = [
    ("ray", ray::figure),
    ("pinhole", pinhole::figure),
    ("row", row::figure),
    ("right-hand", right_hand::figure),
    ("frustum", frustum::figure),
    ("aspect-ratios", aspect_ratios::figure),
    ("three-cases", three_cases::figure),
    ("hits-along-a-ray", hits::figure),
    ("from-above", from_above::figure),
    ("eggs", eggs::figure),
    ("lambert", lambert::figure),
    ("attenuation", attenuation::figure),
    ("phong-vectors", phong_vectors::figure),
    ("lobes", lobes::figure),
];

/// The name of every figure.
pub fn names() -> impl Iterator<Item = &'static str> {
    FIGURES.iter().map(|(name, _)| *name)
}

/// The figure called `name`.
pub fn figure(name: &str) -> Option<Figure> {
    let (_, figure) = FIGURES.iter().find(|(known, _)| *known == name)?;
    Some(figure())
}
