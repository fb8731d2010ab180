//! A scene of the reader's own: the picture of step 5 with everything in it to set, and
//! its Rust.

mod address;
mod parameters;

pub use address::parse_address;

use crate::projection::SIZE;
use crate::{Handle, Interactive, Mark, Numbers, Output, Parameter, collect_numbers};
use course::{OwnScene, Owner, format_scene_program};
use glam::{DVec2, DVec3};
use parameters::{PARAMETERS, Target, own_scene};
use step05_phong::nearest;

/// The picture of the scene, and the values that it was made from.
pub struct OwnScenePicture {
    own: OwnScene,
    values: Vec<f64>,
}

impl Interactive for OwnScenePicture {
    const NAME: &str = "own_scene";

    fn parameters() -> Vec<Parameter> {
        PARAMETERS.iter().map(|(_, parameter)| parameter.clone()).collect()
    }

    fn from_values(values: &[f64]) -> Self {
        Self { own: own_scene(values), values: values.to_vec() }
    }

    fn handles() -> Vec<Handle> {
        // The switch of a sphere or light comes before its position.
        let handles = PARAMETERS.iter().enumerate().filter_map(|(k, (target, parameter))| {
            let Target::Presence(owner, _) = *target else { return None };
            let mark = if owner == Owner::Light { Mark::Light } else { Mark::Point };
            let camera_and_point = move |Self { own, values }: &Self| {
                let point = DVec3::from_slice(&values[k + 1..]);
                (values[k] == 1.0).then(|| (own.camera(SIZE.x), point))
            };
            let handle = Self::handle_in_picture(parameter.group, k + 1, 0.0, camera_and_point);
            Some(Handle { mark, ..handle })
        });
        handles.collect()
    }

    fn is_allowed(&self) -> bool {
        self.own.position != self.own.target
    }

    fn draw(&self) -> Output {
        // The first parameter is the columns.
        Output::Pixels(self.own.picture(self.values[0]))
    }

    fn group_at(&self, place: DVec2) -> Option<&'static str> {
        let pixel = place - 0.5;
        let ray = self.own.camera(SIZE.x).ray(pixel.x, pixel.y);
        nearest(&self.own.scene.objects, &ray).map(|hit| hit.object.name)
    }

    fn numbers(&self) -> Numbers {
        collect_numbers([
            ("rust", format_scene_program(&self.own)),
            ("address", address::format_address(&self.values)),
        ])
    }
}
