//! A thousand spheres, fast: a tree of boxes, a bounding volume hierarchy.

use glam::{DMat3, DVec3};
use image::RgbImage;
use std::f64::consts::PI;
use step03_nearest::{
    Camera, Hit, OBJECTS, Object, Ray, Sphere, direction_colour, draw_and_save,
    nearest, render,
};

/// A box with sides parallel to the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The corner with the smallest x, y and z.
    pub low: DVec3,
    /// The corner with the largest x, y and z.
    pub high: DVec3,
}

impl Bounds {
    /// An empty box.
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

    /// The t at which `ray` enters the box: 0 if it starts inside, infinity if it
    /// misses.
    ///
    /// Each axis has two planes. The ray is inside the box while it is between the
    /// two planes of all three axes.
    pub fn enter(&self, ray: &Ray) -> f64 {
        let one = (self.low - ray.start) / ray.direction;
        let other = (self.high - ray.start) / ray.direction;
        let enter = one.min(other).max_element().max(0.0);
        let leave = one.max(other).min_element();
        if enter <= leave { enter } else { f64::INFINITY }
    }
}

/// A tree of boxes: each holds a few objects, or two smaller trees.
#[derive(Debug)]
pub struct Tree<'a, M> {
    /// The box around its objects.
    pub bounds: Bounds,
    /// The objects, or the two smaller trees.
    pub content: Content<'a, M>,
}

/// The content of a box.
#[derive(Debug)]
pub enum Content<'a, M> {
    /// At most two objects.
    Few(&'a [Object<M>]),
    /// More objects, in two halves.
    Halves(Box<[Tree<'a, M>; 2]>),
}

impl<'a, M> Tree<'a, M> {
    /// Builds the tree around all `objects`, and sorts them into the tree's order.
    pub fn new(objects: &'a mut [Object<M>]) -> Self {
        let boxes = objects.iter().map(|object| Bounds::around(&object.sphere));
        let bounds = boxes.fold(Bounds::EMPTY, Bounds::with);
        if objects.len() <= 2 {
            return Self { bounds, content: Content::Few(objects) };
        }
        // Halve the objects across the longest side of their box.
        let axis = (bounds.high - bounds.low).max_position();
        let at = |object: &Object<M>| object.sphere.centre[axis];
        objects.sort_by(|one, other| at(one).total_cmp(&at(other)));
        let (low, high) = objects.split_at_mut(objects.len() / 2);
        let halves = [Self::new(low), Self::new(high)];
        Self { bounds, content: Content::Halves(Box::new(halves)) }
    }

    /// The hit with the smallest t below `end`. `ask` finds the nearest hit among a
    /// few objects.
    pub fn nearest(
        &self,
        ray: &Ray,
        end: f64,
        ask: &impl Fn(&'a [Object<M>]) -> Option<Hit<'a, M>>,
    ) -> Option<Hit<'a, M>> {
        let halves = match &self.content {
            Content::Few(objects) => return ask(objects).filter(|hit| hit.t < end),
            Content::Halves(halves) => halves.each_ref(),
        };
        let mut order = halves.map(|half| (half.bounds.enter(ray), half));
        order.sort_by(|(one, _), (other, _)| one.total_cmp(other));
        let mut found: Option<Hit<M>> = None;
        for (enter, half) in order {
            let end = found.as_ref().map_or(end, |hit| hit.t);
            // A box that begins farther away than the nearest hit can't hold a
            // nearer one.
            if enter < end {
                found = half.nearest(ray, end, ask).or(found);
            }
        }
        found
    }
}

/// A sunflower of a thousand spheres: each is the golden angle further around than
/// the last, and further out.
pub fn sunflower() -> Vec<Object<DVec3>> {
    let golden = PI * (3.0 - 5_f64.sqrt());
    let tilt = DMat3::from_rotation_x(1.0);
    let object = |k: u32| {
        let (angle, out) = (golden * f64::from(k), f64::from(k) / 1000.0);
        let around = DVec3::new(angle.cos(), 0.0, angle.sin());
        let p = 2.6 * out.sqrt() * around - 1.2 * out * DVec3::Y;
        let centre = DVec3::new(0.0, 0.85, -7.0) + tilt * p;
        let sphere = Sphere { centre, radius: 0.07 + 0.02 * out };
        Object { name: "floret", sphere, material: floret(k) }
    };
    (0..1000).map(object).collect()
}

/// The colour of floret `k`: from teal inside to blue outside, in three shades.
fn floret(k: u32) -> DVec3 {
    let [red, _, golden, blue, _, teal, white, ..] = OBJECTS;
    let stops = [teal, white, golden, red, blue].map(|object| object.material);
    let out = 4.0 * f64::from(k) / 1000.0;
    let stop = out as usize;
    let shade = [1.0, 0.9, 0.8][k as usize % 3];
    stops[stop].lerp(stops[stop + 1], out.fract()) * shade
}

/// The picture: a thousand spheres, found through the tree.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let mut objects = sunflower();
    let tree = Tree::new(&mut objects);
    render(camera, samples, |ray| {
        let hit = tree.nearest(ray, f64::INFINITY, &|few| nearest(few, ray));
        hit.map_or(direction_colour(ray), |hit| hit.object.material)
    })
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
