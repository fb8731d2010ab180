use super::step05::object_parameters;
use crate::probe::{draw_picture, probe_ray, probed_picture};
use crate::{
    Figure, Numbers, Parameter, array, collect_numbers, format_number, format_vector, short_name,
};
use course::examples::mirror::{Mirror, colour, mirrors};
use glam::DVec3;
use step05_phong::{Light, Ray, Scene, reflect, rgb8, visible_point};

/// The offsets, written as in the listing.
const OFFSETS: &[&str] = &[
    "0", "1e-16", "1e-15", "1e-14", "1e-13", "1e-12", "1e-11", "1e-10", "1e-9", "1e-8", "1e-7",
    "1e-6", "1e-5", "1e-4", "1e-3", "1e-2", "1e-1", "1",
];

/// The largest depth, that of the example.
const MAX_DEPTH: u32 = 10;

/// The picture of the example `mirror`: a probe, the depth and the offset, and the k of
/// the object at the probe to set.
pub fn figure() -> Figure {
    let depth = f64::from(MAX_DEPTH);
    let depth = Parameter::new(["", "depth", ""], depth, [0.0, depth], 1.0);
    let offset = Parameter::choice("offset", 8.0, OFFSETS);
    let ks = mirrors().objects.into_iter().map(|object| object.material.k);
    let ks = object_parameters("k", ks, [0.0, 1.0], 20.0);
    let parameters = [depth, offset].into_iter().chain(ks).collect();
    Figure {
        numbers,
        ..probed_picture("mirror", [168.0, 295.0], parameters, |values| {
            let mirrors = Mirrors::new(values);
            draw_picture(values, |ray| mirrors.colour(ray, mirrors.depth))
        })
    }
}

struct Mirrors {
    depth: u32,
    offset: f64,
    scene: Scene<Mirror, Light>,
}

impl Mirrors {
    fn new(values: &[f64]) -> Self {
        let (first, ks) = values[3..].split_at(2);
        let [depth, choice] = array(first);
        let offset = OFFSETS[choice as usize].parse().unwrap_or_default();
        let mut scene = mirrors();
        for (object, k) in scene.objects.iter_mut().zip(ks) {
            object.material.k = *k;
        }
        Self { depth: depth as u32, offset, scene }
    }

    /// The colour that `ray` sees by way of at most `depth` mirrors.
    fn colour(&self, ray: &Ray, depth: u32) -> DVec3 {
        colour(&self.scene, ray, depth, self.offset)
    }

    /// The object, t, k and I of what `ray` meets, and the mirrored ray.
    fn trace_hit(&self, ray: &Ray, depth: u32) -> ([String; 4], Option<Ray>) {
        let objects = &self.scene.objects;
        let intensity = format_vector(self.colour(ray, depth));
        let Some(point) = visible_point(objects, ray) else {
            return (["sky".into(), String::new(), String::new(), intensity], None);
        };
        let k = if depth == 0 { 0.0 } else { point.material().k };
        let object = short_name(point.hit.object.name).into();
        let row = [object, format_number(point.hit.t), format_number(k), intensity];
        let start = point.p + self.offset * point.n;
        let mirrored = Ray { start, direction: reflect(point.n, -ray.direction) };
        (row, (k > 0.0).then_some(mirrored))
    }
}

/// The way of the probe's ray, row by row; the numbers of rows that it does not have are empty.
fn numbers(values: &[f64]) -> Numbers {
    let mirrors = Mirrors::new(values);
    let ray = probe_ray(values);
    let bytes = rgb8(mirrors.colour(&ray, mirrors.depth)).0;
    let mut numbers = collect_numbers([
        ("i", format_number(values[0])),
        ("j", format_number(values[1])),
        ("bytes", format_vector(bytes.map(f64::from))),
    ]);
    let mut ray = Some(ray);
    for k in 0..=MAX_DEPTH {
        let hit = ray.map(|ray| mirrors.trace_hit(&ray, mirrors.depth - k));
        let (row, mirrored) = hit.unwrap_or_default();
        let names = ["object", "t", "k", "I"].map(|name| format!("{name}{k}"));
        numbers.extend(names.into_iter().zip(row));
        ray = mirrored;
    }
    numbers
}
