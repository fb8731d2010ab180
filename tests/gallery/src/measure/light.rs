use super::{Bytes, Least};
use crate::{Parts, Step};
use glam::DVec3;
use step01_rays::Ray;
use step04_diffuse::{Attenuation, PointLight, ambient};
use step05_phong::Light;

/// The parts of the light at one point: ambient, diffuse and specular of the warm light,
/// diffuse and specular of the cool one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Terms {
    /// Which object it is.
    pub object: usize,
    /// The five parts, which add up to the intensity.
    pub parts: [DVec3; 5],
}

impl Terms {
    /// What `parts` add up where `ray` meets something.
    pub fn of(parts: &Parts, step: Step, ray: &Ray) -> Option<Self> {
        let ray = (parts.ray)(*ray);
        let point = parts.seen(step, &ray)?;
        let objects = parts.objects(step);
        let is_it = |m: &crate::Named| std::ptr::eq(m, point.material);
        let object = objects.iter().position(|object| is_it(&object.material))?;
        let (p, n, v) = (point.p, point.n, (parts.to_eye)(&ray));
        let material = &point.material.material;
        let mut terms = [DVec3::ZERO; 5];
        terms[0] = ambient(material.surface.ambient, parts.scene.ambient_light);
        for (k, light) in parts.scene.lights.iter().enumerate().take(2) {
            let (l, d) = (parts.seen_from)(&light.point, p);
            let a = (parts.attenuation)(&light.point.attenuation, d);
            let attenuation = Attenuation { a, b: 0.0, c: 0.0 };
            let point = PointLight { attenuation, ..light.point };
            terms[1 + 2 * k] = (parts.diffuse)(n, l, d, &material.surface, &point);
            if step == Step::Phong && (parts.lit)(n, l) {
                let (r, light) = ((parts.reflect)(l, n), Light { point, ..*light });
                terms[2 + 2 * k] = (parts.specular)(r, v, d, material, &light);
            }
        }
        Some(Self { object, parts: terms })
    }

    /// The five parts of one channel.
    fn channel(&self, k: usize) -> [f64; 5] {
        self.parts.map(|part| part[k])
    }
}

/// One pixel of an object.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    /// The intensity that the picture has.
    pub yours: DVec3,
    /// Which of its channels are clamped, to 0 or to 1.
    pub clamped: [bool; 3],
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
    ) -> Option<Self> {
        let terms = Terms::of(parts, step, &parts.camera.ray(i.into(), j.into()))?;
        let clamped = [0, 1, 2].map(|k| bytes.is_clamped(pixel, k));
        Some(Self { yours: bytes.read(pixel), clamped, terms })
    }

    /// How far a channel is from what the weights make of its parts.
    fn off(&self, k: usize, weights: &[f64; 5]) -> f64 {
        let parts = self.terms.channel(k);
        let sum: f64 = parts.iter().zip(weights).map(|(part, w)| part * w).sum();
        (self.yours[k] - sum.clamp(0.0, 1.0)).abs()
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
        if once.explained < free.explained { free } else { once }
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
