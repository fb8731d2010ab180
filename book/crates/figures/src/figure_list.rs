use crate::Figure;
use crate::figures::*;
use crate::own_scene::OwnScenePicture;
use crate::pictures::*;
use std::sync::LazyLock;

/// Every figure and every picture, in the order of the book.
pub static FIGURES: LazyLock<Vec<Figure>> = LazyLock::new(|| {
    vec![
        Figure::of::<ray::RayFigure>(),
        Figure::of::<pinhole::Pinhole>(),
        Figure::of::<frustum::Frustum>(),
        Figure::of::<row::RowFigure>(),
        Figure::of::<right_hand::RightHand>(),
        Figure::of::<camera::CameraFigure>(),
        Figure::of::<three_cases::ThreeCases>(),
        Figure::of::<hits_along_a_ray::HitsAlongARay>(),
        Figure::of::<scene_from_above::SceneFromAbove>(),
        Figure::of::<ball_outlines::BallOutlines>(),
        Figure::of::<lambert::Lambert>(),
        Figure::of::<attenuation::AttenuationFigure>(),
        Figure::of::<phong_vectors::PhongVectors>(),
        Figure::of::<lobes::Lobes>(),
        Figure::of::<flat_world::FlatWorld>(),
        Figure::of::<step01::Rays>(),
        Figure::of::<step02::OneSphere>(),
        Figure::of::<step03::FlatSpheres>(),
        Figure::of::<step04::MovedLights>(),
        Figure::of::<step05::SwitchedTerms>(),
        Figure::of::<mirror::Mirrors>(),
        Figure::of::<OwnScenePicture>(),
    ]
});

/// The figure or picture of this name.
pub fn find(name: &str) -> Option<&'static Figure> {
    FIGURES.iter().find(|figure| figure.name == name)
}
