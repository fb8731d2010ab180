//! The figures: each is drawn by the steps' own functions, where they have one for it. All begin
//! with what is imported here.

pub mod attenuation;
pub mod ball_outlines;
pub mod camera;
pub mod flat_world;
pub mod frustum;
pub mod hits_along_a_ray;
pub mod lambert;
pub mod lobes;
pub mod phong_vectors;
pub mod pinhole;
pub mod ray;
pub mod right_hand;
pub mod row;
pub mod scene_from_above;
pub mod three_cases;

use crate::{
    Drawing, Figure, Handle, Mark, Numbers, Output, Parameter, View, array, collect_numbers,
    direction_left_of_up, discriminant, format_number, format_rounded, format_vector, short_name,
};
use glam::{DVec2, DVec3, dvec2};
