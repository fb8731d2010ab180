//! A thousand spheres, fast: a tree of boxes, a bounding volume hierarchy.

use glam::{DMat3, DVec3};
use image::RgbImage;
use std::f64::consts::PI;
use std::process::ExitCode;
use step03_nearest::{
    COLOURS, Camera, Hit, Ray, Sphere, direction_colour, render, run,
};

/// A box whose sides are along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The corner with the smallest x, y and z.
    pub low: DVec3,
    /// The corner with the largest.
    pub high: DVec3,
}

impl Bounds {
    /// A box with nothing in it.
    pub const EMPTY: Self =
        Self { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    /// The box around `sphere`, a hair larger, so that rounding never loses a hit.
    pub fn around(sphere: &Sphere) -> Self {
        let half = DVec3::splat(1.000_001 * sphere.radius);
        Self { low: sphere.centre - half, high: sphere.centre + half }
    }

    /// The box around two boxes.
    pub fn with(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The t at which `ray` enters the box; 0 from inside, infinity for a miss.
    ///
    /// It is inside while it is between the two planes of all three axes.
    pub fn enter(&self, ray: &Ray) -> f64 {
        let one = (self.low - ray.start) / ray.direction;
        let other = (self.high - ray.start) / ray.direction;
        let enter = one.min(other).max_element().max(0.0);
        let leave = one.max(other).min_element();
        if enter <= leave { enter } else { f64::INFINITY }
    }
}

/// A tree of boxes: each holds a few spheres, or two smaller trees.
#[derive(Debug)]
pub struct Tree {
    bounds: Bounds,
    content: Content,
}

#[derive(Debug)]
enum Content {
    /// The places of the spheres in their list.
    Spheres(Vec<usize>),
    Halves(Box<[Tree; 2]>),
}

impl Tree {
    /// The tree around all `spheres`.
    pub fn new(spheres: &[Sphere]) -> Self {
        let mut indices: Vec<usize> = (0..spheres.len()).collect();
        Self::over(spheres, &mut indices)
    }

    fn over(spheres: &[Sphere], indices: &mut [usize]) -> Self {
        let boxes = indices.iter().map(|&index| Bounds::around(&spheres[index]));
        let bounds = boxes.fold(Bounds::EMPTY, Bounds::with);
        if indices.len() <= 2 {
            return Self { bounds, content: Content::Spheres(indices.to_vec()) };
        }
        // Halve the spheres across the longest side of their box.
        let axis = (bounds.high - bounds.low).max_position();
        let at = |index: usize| spheres[index].centre[axis];
        indices.sort_by(|&a, &b| at(a).total_cmp(&at(b)));
        let (low, high) = indices.split_at_mut(indices.len() / 2);
        let halves = [Self::over(spheres, low), Self::over(spheres, high)];
        Self { bounds, content: Content::Halves(Box::new(halves)) }
    }

    /// The hit with the smallest t, where `first_hit` tells that of each sphere.
    pub fn nearest(
        &self,
        ray: &Ray,
        mut first_hit: impl FnMut(usize) -> Option<f64>,
    ) -> Option<Hit> {
        let mut nearest = None;
        self.visit(ray, &mut first_hit, &mut nearest);
        nearest
    }

    fn visit(
        &self,
        ray: &Ray,
        first_hit: &mut impl FnMut(usize) -> Option<f64>,
        nearest: &mut Option<Hit>,
    ) {
        match &self.content {
            Content::Spheres(indices) => {
                for &index in indices {
                    // Of two at the same t the first in the list, as in step 3.
                    if let Some(t) = first_hit(index)
                        && nearest.is_none_or(|hit| (t, index) < (hit.t, hit.index))
                    {
                        *nearest = Some(Hit { t, index });
                    }
                }
            }
            Content::Halves(halves) => {
                let mut order =
                    halves.each_ref().map(|half| (half.bounds.enter(ray), half));
                order.sort_by(|(one, _), (other, _)| one.total_cmp(other));
                for (enter, half) in order {
                    // What begins behind the nearest hit can't hold a nearer one.
                    if enter < nearest.map_or(f64::INFINITY, |hit| hit.t) {
                        half.visit(ray, first_hit, nearest);
                    }
                }
            }
        }
    }
}

/// How many spheres the picture has.
const COUNT: u32 = 1000;

/// A sunflower: each sphere is the golden angle further around than the last, and
/// further out.
pub fn spheres() -> Vec<Sphere> {
    let golden = PI * (3.0 - 5_f64.sqrt());
    let tilt = DMat3::from_rotation_x(1.0);
    let sphere = |k: u32| {
        let (angle, out) = (golden * f64::from(k), f64::from(k) / f64::from(COUNT));
        let around = DVec3::new(angle.cos(), 0.0, angle.sin());
        let p = 2.6 * out.sqrt() * around - 1.2 * out * DVec3::Y;
        let centre = DVec3::new(0.0, 0.85, -7.0) + tilt * p;
        Sphere { centre, radius: 0.07 + 0.02 * out }
    };
    (0..COUNT).map(sphere).collect()
}

/// The picture: a thousand spheres, found through the tree.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let spheres = spheres();
    let tree = Tree::new(&spheres);
    render(camera, samples, |ray| {
        let hit =
            tree.nearest(ray, |index| spheres[index].intersect(ray).first_hit());
        hit.map_or(direction_colour(ray), |hit| petal(hit.index))
    })
}

/// The colour of sphere `k`: from teal inside to blue outside, in three shades.
fn petal(k: usize) -> DVec3 {
    let stops = [5, 6, 2, 0, 3].map(|index| COLOURS[index]);
    let out = 4.0 * k as f64 / f64::from(COUNT);
    let stop = out as usize;
    stops[stop].lerp(stops[stop + 1], out.fract()) * [1.0, 0.9, 0.8][k % 3]
}

fn main() -> ExitCode {
    run(env!("CARGO_CRATE_NAME"), picture)
}
