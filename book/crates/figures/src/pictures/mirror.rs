//! The picture of the example `mirror`, and the path of a pixel's ray from mirror to mirror.

use super::pixel_trace::describe_hit;
use super::step05::parameter_shown_if_probed;
use crate::probe::{I, J, draw_picture, probe_ray, probed_picture};
use crate::{
    Figure, Parameter, ParameterId, ParameterValues, Readouts, collect_readouts, format_number,
    format_vector, row_readout_name, short_name,
};
use course::examples::mirror::{Mirror, colour, mirrors};
use glam::DVec3;
use step05_phong::{Light, Ray, Scene, reflect, rgb8, visible_point};

const DEPTH: ParameterId = ParameterId::new("depth");
const OFFSET: ParameterId = ParameterId::new("offset");

/// The id of the parameter for an object's k.
fn k_id(object: &'static str) -> ParameterId {
    ParameterId::of(object, "k")
}

/// The offsets that the reader can choose, written as in the book's listing.
const OFFSETS: &[&str] = &[
    "0", "1e-16", "1e-15", "1e-14", "1e-13", "1e-12", "1e-11", "1e-10", "1e-9", "1e-8", "1e-7",
    "1e-6", "1e-5", "1e-4", "1e-3", "1e-2", "1e-1", "1",
];

/// The maximum depth, the same as in the example.
const MAX_DEPTH: u32 = 10;

/// The picture of the example `mirror`, with a probe. The reader can set the depth, the offset, and
/// the k of the object at the probe.
pub fn figure() -> Figure {
    let max_depth = f64::from(MAX_DEPTH);
    let depth = Parameter::number(DEPTH, "depth", max_depth, [0.0, max_depth], 1.0);
    let offset = Parameter::choice(OFFSET, "offset", 8.0, OFFSETS);
    let ks = mirrors().objects.into_iter().map(|object| {
        let default = object.material.k;
        parameter_shown_if_probed(k_id(object.name), object.name, default, [0.0, 1.0], 20.0)
            .with_symbol("k")
    });
    let parameters = [depth, offset].into_iter().chain(ks);
    Figure {
        readouts,
        row_count: 1 + MAX_DEPTH as usize,
        ..probed_picture("mirror", [168.0, 295.0], parameters, |values, columns| {
            let picture = MirrorPicture::new(values);
            draw_picture(columns, |ray| picture.colour(ray, picture.depth))
        })
    }
}

/// The picture with the depth, the offset and the values of `k` that the reader has set.
struct MirrorPicture {
    depth: u32,
    offset: f64,
    scene: Scene<Mirror, Light>,
}

impl MirrorPicture {
    fn new(values: &ParameterValues) -> Self {
        let mut scene = mirrors();
        for object in &mut scene.objects {
            object.material.k = values[k_id(object.name)];
        }
        let offset = values.choice(OFFSET, OFFSETS).parse().unwrap_or_default();
        Self { depth: values[DEPTH] as u32, offset, scene }
    }

    /// The colour that `ray` sees, with at most `depth` reflections.
    fn colour(&self, ray: &Ray, depth: u32) -> DVec3 {
        colour(&self.scene, ray, depth, self.offset)
    }

    /// Returns the table's row for `ray`: the object that the ray hits, and the values of `t`, `k`
    /// and `I`. Also returns the reflected ray, or None if nothing reflects `ray`.
    fn trace_ray(&self, ray: &Ray, depth: u32) -> ([String; 4], Option<Ray>) {
        let objects = &self.scene.objects;
        let intensity = format_vector(self.colour(ray, depth));
        let Some(point) = visible_point(objects, ray) else {
            return (["sky".into(), String::new(), String::new(), intensity], None);
        };
        let k = if depth == 0 { 0.0 } else { point.material().k };
        let object = short_name(point.hit.object.name).into();
        let row = [object, format_number(point.hit.t), format_number(k), intensity];
        let start = point.p + self.offset * point.n;
        let reflected_ray = Ray { start, direction: reflect(point.n, -ray.direction) };
        (row, (k > 0.0).then_some(reflected_ray))
    }
}

/// The readouts of the probe: its pixel, what the pixel shows, and the path of its ray. The path
/// has one row for each hit, and a row for the sky if the path ends there. Unused rows are empty.
fn readouts(values: &ParameterValues) -> Readouts {
    let picture = MirrorPicture::new(values);
    let ray = probe_ray(values);
    let bytes = rgb8(picture.colour(&ray, picture.depth)).0;
    let mut readouts = collect_readouts([
        ("i", format_number(values[I])),
        ("j", format_number(values[J])),
        ("seen", describe_hit(&picture.scene.objects, &ray)),
        ("bytes", format_vector(bytes.map(f64::from))),
    ]);
    let mut next_ray = Some(ray);
    for index in 0..=MAX_DEPTH {
        let row_and_ray = next_ray.map(|ray| picture.trace_ray(&ray, picture.depth - index));
        let (row, reflected_ray) = row_and_ray.unwrap_or_default();
        let names =
            ["object", "t", "k", "I"].map(|column| row_readout_name(column, index as usize));
        readouts.extend(names.into_iter().zip(row));
        next_ray = reflected_ray;
    }
    readouts
}
