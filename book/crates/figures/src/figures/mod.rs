//! The drawings, which call the steps' own functions wherever possible. Each file in this folder
//! says `use super::*`, which imports everything that this module imports.

pub mod attenuation;
pub mod ball_outlines;
pub mod camera;
pub mod flat_world;
pub mod frustum;
pub mod hits_along_a_ray;
pub mod lambert;
pub mod phong_vectors;
pub mod pinhole;
pub mod ray;
pub mod right_hand;
pub mod rim;
pub mod row_of_rays;
pub mod scene_from_above;
pub mod specular_lobes;
pub mod three_cases;

use crate::{
    Axis, Content, Drawing, Figure, Handle, Mark, Parameter, ParameterId, ParameterValues, PointId,
    Readouts, Shading, TO_LIGHT, View, collect_readouts, direction_left_of_up, format_number,
    format_vector, format_with_max_decimals, short_name,
};
use glam::{DVec2, DVec3, dvec2};
