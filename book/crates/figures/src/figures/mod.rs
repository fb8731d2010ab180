//! The figures: each is drawn by the step's own functions.

mod aspect_ratios;
mod attenuation;
mod ball_outlines;
mod ball_outlines_figure;
mod camera;
mod flat_world;
mod frustum;
mod hits_along_a_ray;
mod lambert;
mod lobes;
mod phong_vectors;
mod pinhole;
mod ray;
mod right_hand;
mod row;
mod scene_from_above;

mod three_cases;
mod view_pyramid;

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
        hits_along_a_ray::figure(),
        scene_from_above::figure(),
        ball_outlines_figure::figure(),
        lambert::figure(),
        attenuation::figure(),
        phong_vectors::figure(),
        lobes::figure(),
        flat_world::figure(),
    ]
}
