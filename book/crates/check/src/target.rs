use crate::comparison::{Pixel, scattered_places};
use crate::drawing::{Drawing, LineHit};
use crate::escape_for_terminal;
use course::{Step, camera, camera_with_size};
use image::RgbImage;
use std::cell::OnceCell;
use std::rc::Rc;
use step01_rays::{Camera, Ray};
use step05_phong::{normal, reflect};

/// What a picture is compared with: a locked picture, or the scene of a name.
pub(crate) struct Target {
    /// Such as `the picture of glass`.
    pub title: String,
    /// The name of a locked picture; None of the scene of a name.
    pub name: Option<String>,
    /// None of an exercise.
    pub drawing: Option<Drawing>,
    pub picture: Rc<RgbImage>,
    /// The camera that draws it.
    pub camera: Camera,
    pixels: OnceCell<Vec<Pixel>>,
}

impl Target {
    /// The locked picture of a name.
    pub fn of_locked(name: &str, picture: RgbImage) -> Self {
        let (columns, rows) = picture.dimensions();
        Self {
            title: format!("the picture of {name}"),
            name: Some(name.to_owned()),
            drawing: Step::from_name(name).map(Drawing::of_step),
            picture: Rc::new(picture),
            camera: camera_with_size(columns, rows),
            pixels: OnceCell::new(),
        }
    }

    /// The scene that belongs to a name.
    pub fn of_scene(name: &str) -> Self {
        let (drawing, camera) = (Drawing::of_name(name), camera());
        Self {
            title: scene_title(name),
            name: None,
            picture: Rc::new(drawing.render(&camera)),
            drawing: Some(drawing),
            camera,
            pixels: OnceCell::new(),
        }
    }

    /// All pixels, scattered over the picture, each with what is seen there; yours are as ours.
    pub fn pixels(&self) -> &[Pixel] {
        self.pixels.get_or_init(|| {
            let (columns, rows) = self.picture.dimensions();
            scattered_places(columns, rows).map(|place| self.pixel(place)).collect()
        })
    }

    fn pixel(&self, place: (u32, u32)) -> Pixel {
        let ours = self.picture.get_pixel(place.0, place.1).0;
        let pixel = Pixel {
            place,
            yours: ours,
            ours,
            hit: None,
            lit: [false; 2],
            in_highlight: false,
            is_above_1: false,
        };
        let ray = self.camera.ray(place.0.into(), place.1.into());
        self.drawing.as_ref().map_or(pixel, |drawing| locate(pixel, drawing, &ray))
    }
}

/// A title such as `the scene of ada`.
pub(crate) fn scene_title(name: &str) -> String {
    format!("the scene of {}", escape_for_terminal(name))
}

/// The pixel with its hit, and what lights it there.
fn locate(mut pixel: Pixel, drawing: &Drawing, ray: &Ray) -> Pixel {
    let scene = &drawing.scene;
    pixel.is_above_1 = 1.0 < drawing.colour(ray).max_element();
    let hits = scene.objects.iter().enumerate().filter_map(|(object, one)| {
        let t = one.sphere.intersect(ray).first_hit()?;
        Some(LineHit { t, object, is_far_side: false })
    });
    pixel.hit = hits.min_by(|a, b| a.t.total_cmp(&b.t));
    let Some(hit) = pixel.hit.filter(|_| Step::Diffuse <= drawing.step) else { return pixel };
    let p = ray.at(hit.t);
    let n = normal(&scene.objects[hit.object].sphere, p);
    for (light, lit) in scene.lights.iter().zip(&mut pixel.lit) {
        let l = (light.point_light.position - p).normalize();
        *lit = 0.0 < n.dot(l);
        let in_highlight = *lit && 0.0 < reflect(n, l).dot(-ray.direction);
        pixel.in_highlight |= drawing.step == Step::Phong && in_highlight;
    }
    pixel
}
