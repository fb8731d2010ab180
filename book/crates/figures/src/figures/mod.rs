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

use crate::Figure;

/// Every figure, in the order of the book.
pub fn all() -> Vec<Figure> {
    vec![
        Figure::of::<ray::RayFigure>(),
        Figure::of::<pinhole::Pinhole>(),
        Figure::of::<frustum::Frustum>(),
        Figure::of::<row::RowFigure>(),
        Figure::of::<right_hand::RightHand>(),
        Figure::of::<camera::CameraFigure>(),
        Figure::of::<aspect_ratios::AspectRatios>(),
        Figure::of::<three_cases::ThreeCases>(),
        Figure::of::<hits_along_a_ray::HitsAlongARay>(),
        Figure::of::<scene_from_above::SceneFromAbove>(),
        Figure::of::<ball_outlines_figure::BallOutlines>(),
        Figure::of::<lambert::Lambert>(),
        Figure::of::<attenuation::AttenuationFigure>(),
        Figure::of::<phong_vectors::PhongVectors>(),
        Figure::of::<lobes::Lobes>(),
        Figure::of::<flat_world::FlatWorld>(),
    ]
}
