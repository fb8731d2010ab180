//! A scene that a reader puts together on a page.

use crate::examples::look_at::look_at;
use crate::examples::mirror::{self, Mirror};
use crate::{FOV_DEGREES, camera_with_fov};
use glam::DVec3;
use image::RgbImage;
use std::iter::zip;
use step05_phong::{Camera, Light, Material, Scene, colour, render};

/// A reader's scene and camera: everything that determines the picture, except for the picture's
/// size.
#[derive(Debug)]
pub struct OwnScene {
    /// The camera's field of view, in degrees.
    pub fov_degrees: f64,
    /// The camera's position.
    pub position: DVec3,
    /// The point that the camera looks at.
    pub target: DVec3,
    /// The camera's roll, in degrees.
    pub roll_degrees: f64,
    /// The objects and lights.
    pub scene: Scene<Material, Light>,
    /// Whether rays are also traced from the surfaces, to draw shadows and reflections.
    pub has_shadows_and_mirrors: bool,
    /// The number `k` of each object: the fraction of the object's colour that is a reflection.
    pub mirror_parts: Vec<f64>,
}

impl OwnScene {
    /// Combines a scene with the camera of the five steps. Shadows and mirrors are off.
    pub fn new(scene: Scene<Material, Light>) -> Self {
        Self {
            fov_degrees: FOV_DEGREES,
            position: DVec3::ZERO,
            target: DVec3::NEG_Z,
            roll_degrees: 0.0,
            mirror_parts: vec![0.0; scene.objects.len()],
            scene,
            has_shadows_and_mirrors: false,
        }
    }

    /// The camera for a picture with this many columns.
    pub fn camera(&self, columns: u32) -> Camera {
        let camera = camera_with_fov(self.fov_degrees, columns);
        look_at(&camera, self.position, self.target, self.roll_degrees.to_radians())
    }

    /// Draws the picture with this many columns. If the scene has no mirrors, step 5 draws the
    /// picture. Otherwise, the example `mirror` draws the picture, and reflects a ray at most ten
    /// times.
    pub fn picture(&self, columns: u32) -> RgbImage {
        let camera = self.camera(columns);
        if !self.has_shadows_and_mirrors {
            return render(&camera, 1, |ray| colour(&self.scene, ray));
        }
        let objects = zip(&self.scene.objects, &self.mirror_parts).map(|(object, &k)| {
            let material = object.material;
            object.with_material(Mirror { material, k })
        });
        let scene = Scene {
            objects: objects.collect(),
            ambient_light: self.scene.ambient_light,
            lights: self.scene.lights.clone(),
        };
        render(&camera, 1, |ray| mirror::colour(&scene, ray, 10, mirror::OFFSET))
    }
}
