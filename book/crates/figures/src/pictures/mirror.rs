use super::step05::object_parameters;
use crate::{
    Interactive, Numbers, Output, Parameter, Probe, array, collect_numbers, format_number,
    format_vector, short_name,
};
use course::examples::mirror::{Mirror, colour, mirrors};
use glam::DVec3;
use step05_phong::{
    Hit, Light, Ray, Scene, SurfacePoint, nearest, reflect, render, rgb8, visible_point,
};

/// The offsets, written as in the listing.
const OFFSETS: &[&str] = &[
    "0", "1e-16", "1e-15", "1e-14", "1e-13", "1e-12", "1e-11", "1e-10", "1e-9", "1e-8", "1e-7",
    "1e-6", "1e-5", "1e-4", "1e-3", "1e-2", "1e-1", "1",
];

/// The largest depth, that of the example.
const MAX_DEPTH: u32 = 10;

/// The picture of the example `mirror`: a probe, the depth and the offset, and the k of
/// the object at the probe to set.
pub struct Mirrors {
    probe: Probe,
    depth: u32,
    offset: f64,
    scene: Scene<Mirror, Light>,
}

impl Mirrors {
    /// The colour that `ray` sees by way of at most `depth` mirrors.
    fn colour(&self, ray: &Ray, depth: u32) -> DVec3 {
        colour(&self.scene, ray, depth, self.offset)
    }

    /// The object, t, k and I of what `ray` meets, and the mirrored ray.
    fn trace_hit(&self, ray: &Ray, depth: u32) -> ([String; 4], Option<Ray>) {
        let objects = &self.scene.objects;
        let intensity = format_vector(self.colour(ray, depth));
        let hit = nearest(objects, ray).zip(visible_point(objects, ray));
        let Some((Hit { object, t }, SurfacePoint { p, n, material })) = hit else {
            return (["sky".into(), String::new(), String::new(), intensity], None);
        };
        let k = if depth == 0 { 0.0 } else { material.k };
        let row = [short_name(object.name).into(), format_number(t), format_number(k), intensity];
        let start = p + self.offset * n;
        let mirrored = Ray { start, direction: reflect(n, -ray.direction) };
        (row, (0.0 < k).then_some(mirrored))
    }
}

impl Interactive for Mirrors {
    const NAME: &str = "mirror";
    const PROBE: Option<[f64; 2]> = Some([168.0, 295.0]);

    fn parameters() -> Vec<Parameter> {
        let depth = f64::from(MAX_DEPTH);
        let depth = Parameter::new(["", "depth", ""], depth, [0.0, depth], 1.0);
        let offset = Parameter::choice("offset", 8.0, OFFSETS);
        let ks = mirrors().objects.into_iter().map(|object| object.material.k);
        let ks = object_parameters("k", ks, [0.0, 1.0], 20.0);
        [depth, offset].into_iter().chain(ks).collect()
    }

    fn from_values(values: &[f64]) -> Self {
        let (probe, others) = Probe::split_values(values);
        let (first, ks) = others.split_at(2);
        let [depth, choice] = array(first);
        let offset = OFFSETS[choice as usize].parse().unwrap_or_default();
        let mut scene = mirrors();
        for (object, k) in scene.objects.iter_mut().zip(ks) {
            object.material.k = *k;
        }
        Self { probe, depth: depth as u32, offset, scene }
    }

    fn draw(&self) -> Output {
        Output::Pixels(render(&self.probe.camera(), 1, |ray| self.colour(ray, self.depth)))
    }

    /// The way of the probe's ray, row by row; the numbers of rows that it does not have
    /// are empty.
    fn numbers(&self) -> Numbers {
        let mut ray = Some(self.probe.ray());
        let bytes = rgb8(self.colour(&self.probe.ray(), self.depth)).0;
        let mut numbers = collect_numbers([
            ("i", format_number(self.probe.i)),
            ("j", format_number(self.probe.j)),
            ("bytes", format_vector(bytes.map(f64::from))),
        ]);
        for k in 0..=MAX_DEPTH {
            let hit = ray.map(|ray| self.trace_hit(&ray, self.depth - k));
            let (row, mirrored) = hit.unwrap_or_default();
            let names = ["object", "t", "k", "I"].map(|name| format!("{name}{k}"));
            numbers.extend(names.into_iter().zip(row));
            ray = mirrored;
        }
        numbers
    }
}
