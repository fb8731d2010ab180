//! The list of all figures.

use crate::figures::*;
use crate::pictures::*;
use crate::{Figure, own_scene};
use std::sync::LazyLock;

/// Every figure: the drawings, then the pictures, each in the order of the book.
pub static FIGURES: LazyLock<Vec<Figure>> = LazyLock::new(|| {
    vec![
        ray::figure(),
        pinhole::figure(),
        frustum::figure(),
        row::figure(),
        right_hand::figure(),
        camera::figure(),
        three_cases::figure(),
        hits_along_a_ray::figure(),
        scene_from_above::figure(),
        ball_outlines::figure(),
        lambert::figure(),
        attenuation::figure(),
        phong_vectors::figure(),
        lobes::figure(),
        flat_world::figure(),
        step01::figure(),
        step02::figure(),
        step03::figure(),
        step04::figure(),
        step05::figure(),
        mirror::figure(),
        own_scene::figure(),
    ]
});

/// The figure of this name.
pub fn find(name: &str) -> Option<&'static Figure> {
    FIGURES.iter().find(|figure| figure.name == name)
}
