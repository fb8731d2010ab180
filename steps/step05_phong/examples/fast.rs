//! Any scene of step 5, fast: eight pixels side by side, and the same bytes.

use fearless_simd::{Level, Simd, dispatch, f64x8, prelude::*};
use glam::{DMat3, DVec3};
use image::RgbImage;
use many::{Content, Tree};
use rayon::prelude::*;
use std::array::from_fn;
use step05_phong::{
    Camera, Light, Material, Object, Scene, ambient, draw_and_save, scene,
};

#[allow(dead_code)]
#[path = "../../step03_nearest/examples/many.rs"]
pub mod many;

type Lit = Scene<Material, Light>;

/// Eight vectors: the x of each, the y of each and the z of each.
type Vectors<S> = [f64x8<S>; 3];

#[inline(always)]
fn dot<S: Simd>(v: Vectors<S>, w: Vectors<S>) -> f64x8<S> {
    v[0] * w[0] + v[1] * w[1] + v[2] * w[2]
}

/// xⁿ, for n above 0, by the multiplications of `powi`.
#[inline(always)]
fn power<S: Simd>(mut x: f64x8<S>, mut n: i32, mut product: f64x8<S>) -> f64x8<S> {
    while 0 < n {
        product = if n % 2 == 1 { product * x } else { product };
        (x, n) = (x * x, n / 2);
    }
    product
}

/// Where in a row an object may be seen, and what all rays of the row share.
struct Span {
    object: usize,
    first: f64,
    last: f64,
    s: DVec3,
    c: f64,
}

impl Span {
    /// None where no ray from `start` along ui + w, for any i, meets the object.
    fn new(o: &Object<usize>, start: DVec3, u: DVec3, w: DVec3) -> Option<Self> {
        let (object, s, r) = (o.material, start - o.sphere.centre, o.sphere.radius);
        let (c, size) = (s.dot(s) - r * r, s.dot(s) + r * r);
        // D is 4(Ai² + 2Bi + C) in column i, but for rounding far below the margin.
        let (su, sw, uu, ww) = (s.dot(u), s.dot(w), u.dot(u), w.dot(w));
        let (a, b) = (su * su - uu * c, su * sw - u.dot(w) * c);
        let d = b * b - a * (sw * sw - ww * c) + 1e-9 * uu * ww * size * size;
        let [first, last] = match a < -1e-6 * uu * size {
            true if d < 0.0 => return None,
            true => [(-b + d.sqrt()) / a - 2.0, (-b - d.sqrt()) / a + 2.0],
            false => [f64::NEG_INFINITY, f64::INFINITY],
        };
        Some(Self { object, first, last, s, c })
    }
}

/// Eight rays from one point, the a of their quadratics, and what there is to see.
struct Packet<'a, S: Simd>(S, DVec3, Vectors<S>, f64x8<S>, &'a Lit);

impl<S: Simd> Packet<'_, S> {
    /// The smallest t above 0 and the object there; infinity and −1 for a miss.
    #[inline(always)]
    fn nearest(&self, near: &[&Span]) -> [f64x8<S>; 2] {
        let &Self(simd, _, v, a, _) = self;
        let zero = simd.splat_f64x8(0.0);
        let mut nearest = [f64::INFINITY, -1.0].map(|x| simd.splat_f64x8(x));
        for Span { object, s, c, .. } in near {
            let b = 2.0 * (s.x * v[0] + s.y * v[1] + s.z * v[2]);
            let d = b * b - 4.0 * a * *c;
            if d.simd_lt(zero).all_true() {
                continue;
            }
            // Below 0, D has a root that is not a number, and no comparison holds.
            let mut t = (-b - d.sqrt()) / (2.0 * a);
            if t.simd_le(zero).any_true() {
                t = t.simd_gt(zero).select(t, (-b + d.sqrt()) / (2.0 * a));
            }
            let is_nearer = t.simd_gt(zero) & t.simd_lt(nearest[0]);
            let hit = [t, simd.splat_f64x8(*object as f64)];
            nearest = from_fn(|k| is_nearer.select(hit[k], nearest[k]));
        }
        nearest
    }

    /// The sum of `phong` at eight points of an object.
    #[inline(always)]
    fn phong(&self, t: f64x8<S>, object: usize) -> Vectors<S> {
        let &Self(simd, start, v, a, scene) = self;
        let Object { sphere, material, .. } = &scene.objects[object];
        let (r_d, r_s) = (material.matte.diffuse, material.specular);
        let [zero, one] = [0.0, 1.0].map(|x| simd.splat_f64x8(x));
        let p: Vectors<S> = from_fn(|k| start[k] + t * v[k]);
        let n = from_fn(|k| (p[k] - sphere.centre[k]) / sphere.radius);
        let eye = v.map(|v| -(v * (1.0 / a.sqrt())));
        let (mut i_d, mut i_s) = ([zero; 3], [zero; 3]);
        for Light { point_light, specular } in &scene.lights {
            let to_light = from_fn(|k| point_light.position[k] - p[k]);
            let d = dot(to_light, to_light).sqrt();
            let l = to_light.map(|x| x * (1.0 / d));
            let fade = point_light.attenuation;
            let fade = fade.a + fade.b * d + fade.c * d * d;
            let cosine = dot(l, n);
            if cosine.simd_le(zero).all_true() {
                continue; // The terms of this light are 0.
            }
            let max = cosine.max_precise(0.0);
            i_d =
                from_fn(|k| i_d[k] + r_d[k] / fade * max * point_light.diffuse[k]);
            let r_v = dot(from_fn(|k| 2.0 * cosine * n[k] - l[k]), eye);
            let shines = cosine.simd_gt(zero) & r_v.simd_gt(zero);
            if shines.any_true() {
                let power = power(r_v, material.shininess, one);
                let term = |k: usize| r_s[k] / fade * power * specular[k];
                i_s = from_fn(|k| i_s[k] + shines.select(term(k), zero));
            }
        }
        let i_a = ambient(&material.matte, scene.ambient_light);
        from_fn(|k| i_a[k] + i_d[k] + i_s[k])
    }

    /// The sum of the terms, or else the direction, as `colour` has them.
    #[inline(always)]
    fn colour(&self, near: &[&Span]) -> Vectors<S> {
        let &Self(simd, _, [x, y, z], ..) = self;
        let mut colour = [x, y, -z].map(|v| 0.7 + 0.3 * v);
        let [t, nearest] = self.nearest(near);
        for Span { object, .. } in near {
            let is_seen = nearest.simd_eq(simd.splat_f64x8(*object as f64));
            if is_seen.any_true() {
                let lit = self.phong(t, *object);
                colour = from_fn(|k| is_seen.select(lit[k], colour[k]));
            }
        }
        colour
    }
}

/// The objects in boxes that the plane through `start` with this normal cuts.
fn objects_cut<'a, M>(
    tree: &Tree<'a, M>,
    start: DVec3,
    normal: DVec3,
) -> Vec<&'a Object<M>> {
    let normal = normal.normalize();
    let (mut found, mut trees) = (vec![], vec![tree]);
    while let Some(Tree { bounds, content }) = trees.pop() {
        let to_middle = (bounds.low + bounds.high) / 2.0 - start;
        let reach = normal.abs().dot(bounds.high - bounds.low) / 2.0;
        // Rounding makes far less of a difference.
        let reach = reach + 1e-6 * to_middle.length();
        match content {
            _ if reach < normal.dot(to_middle).abs() => {}
            Content::Few(objects) => found.extend(*objects),
            Content::Halves(halves) => trees.extend(halves.iter()),
        }
    }
    found
}

/// A camera, what it sees, the tree of that, and where in a pixel the rays go.
type View<'a> = (&'a Camera, &'a Lit, &'a Tree<'a, usize>, &'a [f64]);

/// Draws row `j`, three bytes per pixel. Its rays, along xi + w, lie in one plane.
#[inline(always)]
fn draw_row<S: Simd>(simd: S, view: View, j: usize, row: &mut [u8]) {
    let (camera, scene, tree, offsets) = view;
    let DMat3 { x_axis: x, y_axis: y, z_axis: z } = camera.matrix;
    let mut sums = vec![[simd.splat_f64x8(0.0); 3]; row.len().div_ceil(24)];
    for j in offsets.iter().map(|v| j as f64 + v) {
        let (start, w) = (camera.centre, y * j + z);
        let objects = objects_cut(tree, start, w.cross(x)).into_iter();
        let spans = objects.filter_map(|o| Span::new(o, start, x, w));
        let (mut spans, mut near) = (spans.collect::<Vec<_>>(), vec![]);
        spans.sort_by_key(|span| span.object);
        for (packet, sum) in sums.iter_mut().enumerate() {
            let i = 8.0 * packet as f64;
            near.clear();
            near.extend(spans.iter().filter(|s| s.first <= i + 8.0 && i <= s.last));
            for u in offsets {
                let i = f64x8::from_fn(simd, |k| i + k as f64 + u);
                let v = from_fn(|k| x[k] * i + y[k] * j + z[k]);
                let colour = Packet(simd, start, v, dot(v, v), scene).colour(&near);
                *sum = from_fn(|k| sum[k] + colour[k]);
            }
        }
    }
    let count = (offsets.len() * offsets.len()) as f64;
    for (sum, pixels) in sums.iter().zip(row.chunks_mut(24)) {
        let bytes = sum.map(|i| (255.0 * (i / count) + 0.5).max_precise(0.0));
        let [r, g, b] = bytes.map(|byte| byte.min(255.0).floor());
        let colours = (r + 256.0 * g + 65536.0 * b).to_array();
        for (pixel, colour) in pixels.chunks_exact_mut(3).zip(colours) {
            pixel.copy_from_slice(&(colour as u32).to_le_bytes()[..3]);
        }
    }
}

/// The picture that `render` draws with `colour`, to the byte.
pub fn draw(level: Level, camera: &Camera, samples: u32, scene: &Lit) -> RgbImage {
    let centre = |k| (f64::from(k) + 0.5) / f64::from(samples) - 0.5;
    let offsets: Vec<f64> = (0..samples).map(centre).collect();
    let objects = scene.objects.iter().enumerate();
    let mut objects: Vec<_> = objects.map(|(k, o)| o.with_material(k)).collect();
    let view = (camera, scene, &Tree::new(&mut objects), &*offsets);
    let mut image = RgbImage::new(camera.h_res, camera.v_res);
    let rows = image.par_chunks_exact_mut(3 * camera.h_res as usize).enumerate();
    rows.for_each(|(j, row)| dispatch!(level, s => draw_row(s, view, j, row)));
    image
}

/// The picture of step 5, with the best instructions of this processor.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    draw(Level::new(), camera, samples, &scene())
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
