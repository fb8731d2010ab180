use crate::own_scene::OwnScenePicture;
use crate::{Figure, figures, pictures};
use std::sync::LazyLock;

/// Every figure and every picture, in the order of the book.
pub static FIGURES: LazyLock<Vec<Figure>> = LazyLock::new(|| {
    let steps = figures::all().into_iter().chain(pictures::all());
    steps.chain([Figure::of::<OwnScenePicture>()]).collect()
});

/// The figure or picture of this name.
pub fn find(name: &str) -> Option<&'static Figure> {
    FIGURES.iter().find(|figure| figure.name == name)
}
