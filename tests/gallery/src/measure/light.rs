use super::alternatives::Vectors;
use super::{Alternative, Bytes, Least};
use crate::{Parts, Step};
use glam::DVec3;
use step01_rays::Ray;
use step04_diffuse::{Attenuation, Point, PointLight, ambient};
use step05_phong::{Light, Material};

/// The parts of the light at one point: ambient, diffuse and specular of the warm light,
/// diffuse and specular of the cool one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Terms {
    /// Which object it is.
    pub object: usize,
    /// The five parts, which add up to the intensity.
    pub parts: [DVec3; 5],
    /// d of each light.
    pub distances: [f64; 2],
    /// l·n of each light.
    pub cosines: [f64; 2],
}

impl Terms {
    /// What `parts` add up where `ray` meets something, with these things done wrong.
    pub fn of(
        parts: &Parts,
        step: Step,
        ray: &Ray,
        wrong: &[Alternative],
    ) -> Option<Self> {
        let ray = (parts.ray)(*ray);
        let Point { p, n, material } = parts.seen(step, &ray)?;
        let objects = parts.objects(step).iter();
        let mut all = objects.map(|object| &object.material);
        let object = all.position(|one| std::ptr::eq(one, material))?;
        let v = (parts.to_eye)(&ray);
        let (l, d, r) = (DVec3::ZERO, 0.0, DVec3::ZERO);
        let seen = Vectors { ray, p, n, v, l, d, r };
        let mut terms = [DVec3::ZERO; 5];
        let (mut distances, mut cosines) = ([0.0; 2], [0.0; 2]);
        let material = &material.material;
        terms[0] = ambient(material.surface.ambient, parts.scene.ambient_light);
        for (k, light) in parts.scene.lights.iter().enumerate().take(2) {
            let (two, d, cosine) = lit(parts, step, material, light, seen, wrong);
            terms[1 + 2 * k..3 + 2 * k].copy_from_slice(&two);
            (distances[k], cosines[k]) = (d, cosine);
        }
        wrong.iter().for_each(|a| (a.sum)(&mut terms, parts.scene.ambient_light));
        Some(Self { object, parts: terms, distances, cosines })
    }

    /// The larger of the two highlights.
    pub fn shine(&self) -> f64 {
        self.parts[2].max(self.parts[4]).max_element()
    }

    /// The five parts of one channel.
    fn channel(&self, k: usize) -> [f64; 5] {
        self.parts.map(|part| part[k])
    }
}

/// The diffuse and the specular part of one light, its d and its l·n.
fn lit(
    parts: &Parts,
    step: Step,
    material: &Material,
    light: &Light,
    mut seen: Vectors,
    wrong: &[Alternative],
) -> ([DVec3; 2], f64, f64) {
    let change = |seen: &mut Vectors, which: usize| {
        wrong.iter().for_each(|a| (a.vectors[which])(seen));
    };
    change(&mut seen, 0);
    (seen.l, seen.d) = (parts.seen_from)(&light.point, seen.p);
    seen.r = (parts.reflect)(seen.l, seen.n);
    let fades = |d: f64| {
        // The divisor, whatever it is, as the light's own: the terms divide by it.
        let a = (parts.attenuation)(&light.point.attenuation, d);
        let attenuation = Attenuation { a, b: 0.0, c: 0.0 };
        Light { point: PointLight { attenuation, ..light.point }, ..*light }
    };
    let mut matt = seen;
    change(&mut matt, 1);
    let Vectors { n, l, d, .. } = matt;
    let diffuse = (parts.diffuse)(n, l, d, &material.surface, &fades(d).point);
    if step < Step::Phong || !(parts.lit)(seen.n, seen.l) {
        return ([diffuse, DVec3::ZERO], d, l.dot(n));
    }
    change(&mut seen, 2);
    let cosine = l.dot(n);
    let Vectors { r, v, d, .. } = seen;
    ([diffuse, (parts.specular)(r, v, d, material, &fades(d))], d, cosine)
}

/// One pixel of an object.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    /// The intensity that the picture has.
    pub yours: DVec3,
    /// Which of its channels are clamped, to 0 or to 1.
    pub clamped: [bool; 3],
    /// How much each channel changes from one byte to the next.
    pub byte: DVec3,
    /// The bytes themselves, and how they were made.
    pub pixel: image::Rgb<u8>,
    pub bytes: Bytes,
    /// The parts of ours.
    pub terms: Terms,
}

impl Sample {
    /// The pixel in column `i` and row `j`.
    pub fn of(
        parts: &Parts,
        step: Step,
        bytes: &Bytes,
        pixel: &image::Rgb<u8>,
        (i, j): (u32, u32),
        wrong: &[Alternative],
    ) -> Option<Self> {
        let ray = parts.camera.ray(i.into(), j.into());
        let terms = Terms::of(parts, step, &ray, wrong)?;
        let clamped = [0, 1, 2].map(|k| bytes.is_clamped(pixel, k));
        let byte = bytes.size(pixel);
        Some(Self {
            yours: bytes.read(pixel),
            clamped,
            byte,
            pixel: *pixel,
            bytes: *bytes,
            terms,
        })
    }

    /// How many bytes a channel is from what the weights make of its parts.
    fn off(&self, k: usize, weights: &[f64; 5]) -> f64 {
        let parts = self.terms.channel(k);
        let sum: f64 = parts.iter().zip(weights).map(|(part, w)| part * w).sum();
        match self.bytes.is_from(&self.pixel, k, sum) {
            true => 0.0,
            false => (self.yours[k] - sum.clamp(0.0, 1.0)).abs() / self.byte[k],
        }
    }

    /// Whether the weights explain all three channels.
    pub fn is_explained(&self, weights: &Weights, near: f64) -> bool {
        (0..3).all(|k| self.off(k, &weights[k]) <= near)
    }
}

/// How many times each of the five parts counts, for red, green and blue.
pub(super) type Weights = [[f64; 5]; 3];

/// All of them once.
pub(super) const ONCE: Weights = [[1.0; 5]; 3];

/// Weights that explain most of many pixels.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fit {
    pub weights: Weights,
    /// How far off each weight may be.
    pub errors: Weights,
    /// How many pixels they explain.
    pub explained: usize,
}

impl Fit {
    /// The weights that explain most of the samples to within `near`.
    pub fn of(samples: &[Sample], near: f64) -> Self {
        let once = Self::from(samples, near, ONCE);
        let free = (0..3).map(|k| fit(samples, k, &[1.0; 5], f64::INFINITY).0);
        let free: Vec<_> = free.collect();
        let free = Self::from(samples, near, [free[0], free[1], free[2]]);
        let best = if once.explained < free.explained { free } else { once };
        // Where 1 explains nearly as much, it is 1, and has to do so to the last byte.
        let exact = if near < 1.0 { 0.0 } else { near };
        let is_explained = |s: &&Sample| s.is_explained(&ONCE, exact);
        let explained = samples.iter().filter(is_explained).count();
        let is_other = 100 * explained < 99 * best.explained;
        match is_other && 0 < best.strangeness() {
            true => best,
            false => Self { weights: ONCE, explained, ..best },
        }
    }

    /// How many of the weights are not 1, as far as they can be told.
    pub fn strangeness(&self) -> usize {
        let pairs = self.weights.iter().flatten().zip(self.errors.iter().flatten());
        pairs
            .filter(|(w, error)| (5.0 * **error).max(0.01) < (*w - 1.0).abs())
            .count()
    }

    /// The same, begun at some weights: again and again from the pixels that are
    /// explained best.
    fn from(samples: &[Sample], near: f64, mut weights: Weights) -> Self {
        let mut errors = [[f64::INFINITY; 5]; 3];
        for k in 0..3 {
            for _ in 0..6 {
                let width = width(samples, k, &weights[k], near);
                (weights[k], errors[k]) = fit(samples, k, &weights[k], width);
            }
        }
        let is_explained = |s: &&Sample| s.is_explained(&weights, near);
        let explained = samples.iter().filter(is_explained).count();
        Self { weights, errors, explained }
    }
}

/// How far off a pixel may be to count: three times the median.
fn width(samples: &[Sample], k: usize, weights: &[f64; 5], near: f64) -> f64 {
    let mut off: Vec<_> = samples.iter().map(|s| s.off(k, weights)).collect();
    let middle = off.len() / 2;
    if off.is_empty() {
        return near;
    }
    let (_, median, _) = off.select_nth_unstable_by(middle, f64::total_cmp);
    (3.0 * *median).max(near)
}

fn fit(
    samples: &[Sample],
    k: usize,
    weights: &[f64; 5],
    width: f64,
) -> ([f64; 5], [f64; 5]) {
    let mut least = Least::new();
    for sample in samples.iter().filter(|s| !s.clamped[k]) {
        if width.is_infinite() || sample.off(k, weights) <= width {
            least.add(&sample.terms.channel(k), sample.yours[k]);
        }
    }
    (least.solve_near(&[1.0; 5]), least.errors(1.0 / (255.0 * 12_f64.sqrt())))
}
