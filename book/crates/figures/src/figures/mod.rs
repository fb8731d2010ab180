//! The figures: each is drawn by the step's own functions.

mod aspect_ratios;
mod attenuation;
mod camera;
mod eggs;
mod flat_world;
mod frustum;
mod hits;
mod lambert;
mod lobes;
mod phong_vectors;
mod pinhole;
mod ray;
mod right_hand;
mod row;
mod scene_from_above;
mod shared;
mod three_cases;

pub use scene_from_above::draw as draw_scene_from_above;

use crate::Live;

/// Every figure, in the order of the book.
pub fn all() -> Vec<Live> {
    vec![
        ray::figure(),
        pinhole::figure(),
        frustum::figure(),
        row::figure(),
        right_hand::figure(),
        camera::figure(),
        aspect_ratios::figure(),
        three_cases::figure(),
        hits::figure(),
        scene_from_above::figure(),
        eggs::figure(),
        lambert::figure(),
        attenuation::figure(),
        phong_vectors::figure(),
        lobes::figure(),
        flat_world::figure(),
    ]
}
