//! Draws any scene of step 5 fast: nearest spheres first, eight pixels at once. It
//! draws the same bytes as `render` with `colour`.

use fearless_simd::{Level, Simd, dispatch, f64x8, prelude::*};
use glam::{DMat3, DVec3};
use image::RgbImage;
use rayon::prelude::*;
use std::ops::Range;
use step05_phong::{
    Camera, Light, Material, Object, Scene, ambient, draw_and_save, scene,
    sub_pixel_offsets,
};

// 1. Which spheres a block of pixels may see, the nearest first.

/// A sphere, with the numbers that are the same for all rays from the camera.
#[derive(Clone, Copy)]
struct Candidate {
    /// Its index among the objects of the scene.
    index: usize,
    /// S, the position of the camera, relative to the centre of the sphere.
    s: DVec3,
    /// The c of the quadratic, which is the same for all rays.
    c: f64,
    /// The radius plus a margin.
    reach: f64,
    /// No ray meets the sphere nearer to the camera than this.
    begin: f64,
}

impl Candidate {
    /// The margins allow for rounding errors, so that no sphere is left out that a
    /// ray would hit by its computed a, b and c. These errors change D / 4a by less
    /// than 1e-14 (|s|² + r²). So the computed D may be positive for rays that pass
    /// the sphere at a distance of √(r² + 1e-14 (|s|² + r²)), and √D may be wrong
    /// by the root of this error, as if t |V| were off by 1e-7 (|s| + r). The
    /// margins are at least ten times as large as both errors.
    fn new(
        index: usize,
        object: &Object<Material>,
        camera: DVec3,
        slack: f64,
    ) -> Self {
        let (s, r) = (camera - object.sphere.centre, object.sphere.radius);
        let (distance, c) = (s.length(), s.dot(s) - r * r);
        let widened = (r * r + 1e-12 * (s.dot(s) + r * r)).sqrt();
        let begin = (distance - r).abs() - 1e-6 * (distance + r);
        // After an overflow this may be NaN, which `max` turns into 0.
        let begin = begin.max(0.0);
        Self { index, s, c, reach: widened + slack * (distance + widened), begin }
    }
}

/// The pyramid that a rectangle of pixels sees. Its sides are four planes through
/// the camera, given by their unit normals, which point inwards.
#[derive(Clone, Copy)]
struct Pyramid([DVec3; 4]);

impl Pyramid {
    /// Returns true only if the whole sphere is on the outer side of a plane.
    fn misses(&self, sphere: &Candidate) -> bool {
        // The centre is at −s. If a number is NaN, the sphere isn't left out.
        self.0.iter().any(|normal| normal.dot(sphere.s) > sphere.reach)
    }
}

/// A list of candidates that begins with the nearest, and grows on demand.
trait Candidates {
    /// The candidates found so far.
    fn found(&self) -> &[Candidate];
    /// Returns true if there's no more to be found.
    fn is_complete(&self) -> bool;
    /// Finds a few more, unless the list is complete.
    fn find_more(&mut self);
}

/// A list that is complete from the beginning.
impl Candidates for &[Candidate] {
    fn found(&self) -> &[Candidate] {
        self
    }

    fn is_complete(&self) -> bool {
        true
    }

    fn find_more(&mut self) {}
}

/// The candidates in a longer list that a pyramid doesn't miss.
// `draw_band` has one on the stack, so this also aligns everything else on its
// stack. A vector of 64 bytes then lies in one cache line rather than in two.
#[repr(align(64))]
struct Sieve<C> {
    source: C,
    /// The number of the source's candidates that have been looked at.
    looked_at: usize,
    pyramid: Pyramid,
    found: Vec<Candidate>,
    is_complete: bool,
}

impl<C: Candidates> Sieve<C> {
    fn new(source: C, pyramid: Pyramid) -> Self {
        Self { source, looked_at: 0, pyramid, found: vec![], is_complete: false }
    }

    /// Starts over with a different pyramid.
    fn restart(&mut self, pyramid: Pyramid) {
        self.pyramid = pyramid;
        self.looked_at = 0;
        self.found.clear();
        self.is_complete = false;
    }
}

impl<C: Candidates> Candidates for Sieve<C> {
    #[inline(always)]
    fn found(&self) -> &[Candidate] {
        &self.found
    }

    #[inline(always)]
    fn is_complete(&self) -> bool {
        self.is_complete
    }

    #[cold]
    #[inline(never)]
    fn find_more(&mut self) {
        // Find twice as many, since the caller starts over with the first.
        let enough = 2 * self.found.len() + 4;
        while self.found.len() < enough {
            match self.source.found().get(self.looked_at) {
                Some(sphere) => {
                    self.looked_at += 1;
                    if !self.pyramid.misses(sphere) {
                        self.found.push(*sphere);
                    }
                }
                None if self.source.is_complete() => {
                    self.is_complete = true;
                    return;
                }
                None => self.source.find_more(),
            }
        }
    }
}

// 2. What eight rays see, computed by the operations of `colour` in the same order.

/// Eight vectors: the x of each, the y of each and the z of each.
type Vectors<S> = [f64x8<S>; 3];

/// Makes eight vectors, one axis at a time, from 0 to 2. It's here because
/// `std::array::from_fn` isn't always inlined.
#[inline(always)]
fn vectors<S: Simd>(axis: impl Fn(usize) -> f64x8<S>) -> Vectors<S> {
    [axis(0), axis(1), axis(2)]
}

#[inline(always)]
fn dot<S: Simd>(v: Vectors<S>, w: Vectors<S>) -> f64x8<S> {
    v[0] * w[0] + v[1] * w[1] + v[2] * w[2]
}

/// The `DVec3` method of this name, eight times. For a vector without a direction,
/// it returns (1, 0, 0) and 0.
#[inline(always)]
fn normalize_and_length<S: Simd>(simd: S, v: Vectors<S>) -> (Vectors<S>, f64x8<S>) {
    let splat = |x| simd.splat_f64x8(x);
    let mut length = dot(v, v).sqrt();
    let inverse = 1.0 / length;
    let mut unit = vectors(|k| v[k] * inverse);
    let has_direction =
        inverse.simd_gt(splat(0.0)) & inverse.simd_lt(splat(f64::INFINITY));
    if has_direction.any_false() {
        let x_axis = [splat(1.0), splat(0.0), splat(0.0)];
        unit = vectors(|k| has_direction.select(unit[k], x_axis[k]));
        length = has_direction.select(length, splat(0.0));
    }
    (unit, length)
}

/// xⁿ for n > 0, by the same multiplications as `powi`.
#[inline(always)]
fn power<S: Simd>(simd: S, mut x: f64x8<S>, mut n: i32) -> f64x8<S> {
    let mut product = simd.splat_f64x8(1.0);
    while n > 0 {
        if n % 2 == 1 {
            product *= x;
        }
        x *= x;
        n /= 2;
    }
    product
}

/// Eight rays that start at one point.
struct Packet<S: Simd> {
    simd: S,
    start: DVec3,
    /// Their directions V.
    v: Vectors<S>,
    /// The a of their quadratics, V·V.
    a: f64x8<S>,
}

/// Where eight rays first meet an object.
struct Hits<S: Simd> {
    /// The smallest t above 0; infinity for a miss.
    t: f64x8<S>,
    /// The index of the object there; −1 for a miss.
    index: f64x8<S>,
    /// The number of candidates that were tested. All that were hit are among them.
    tested: usize,
}

impl<S: Simd> Packet<S> {
    /// `nearest`, eight times. As there, the first in the scene wins if several t
    /// are equal. Returns None if a candidate that hasn't been found yet may be
    /// nearer.
    #[inline(always)]
    fn nearest(&self, found: &[Candidate], is_complete: bool) -> Option<Hits<S>> {
        let &Self { simd, v, a, .. } = self;
        let splat = |x| simd.splat_f64x8(x);
        let zero = splat(0.0);
        let mut hits =
            Hits { t: splat(f64::INFINITY), index: splat(-1.0), tested: 0 };
        let mut farthest = f64::INFINITY;
        for sphere in found {
            // This one, and all after it, begin behind all eight hits.
            if sphere.begin > farthest {
                return Some(hits);
            }
            hits.tested += 1;
            let s = sphere.s;
            let b = 2.0 * (s.x * v[0] + s.y * v[1] + s.z * v[2]);
            let d = b * b - 4.0 * a * sphere.c;
            if d.simd_lt(zero).all_true() {
                continue;
            }
            // If D is negative, its root is NaN, and every comparison with NaN is
            // false.
            let root = d.sqrt();
            let mut t = (-b - root) / (2.0 * a);
            if t.simd_le(zero).any_true() {
                t = t.simd_gt(zero).select(t, (-b + root) / (2.0 * a));
            }
            let index = splat(sphere.index as f64);
            let wins_tie = t.simd_eq(hits.t) & index.simd_lt(hits.index);
            let is_nearer = t.simd_gt(zero) & (t.simd_lt(hits.t) | wins_tie);
            if is_nearer.any_true() {
                hits.t = is_nearer.select(t, hits.t);
                hits.index = is_nearer.select(index, hits.index);
                farthest = (hits.t * a.sqrt()).reduce_max();
            }
        }
        is_complete.then_some(hits)
    }

    /// The sum of `phong` at eight points of one object.
    #[inline(always)]
    fn phong(
        &self,
        t: f64x8<S>,
        object: &Object<Material>,
        scene: &Scene<Material, Light>,
    ) -> Vectors<S> {
        let &Self { simd, start, v, a } = self;
        let Object { sphere, material, .. } = object;
        let (r_d, r_s) = (material.matte.diffuse, material.specular);
        let zero = simd.splat_f64x8(0.0);
        let p: Vectors<S> = vectors(|k| start[k] + t * v[k]);
        let n = vectors(|k| (p[k] - sphere.centre[k]) / sphere.radius);
        let eye = vectors(|k| -(v[k] * (1.0 / a.sqrt())));
        let (mut i_d, mut i_s) = ([zero; 3], [zero; 3]);
        for Light { point_light, specular } in &scene.lights {
            let to_light = vectors(|k| point_light.position[k] - p[k]);
            let (l, d) = normalize_and_length(simd, to_light);
            let fade = point_light.attenuation;
            let fade = fade.a + fade.b * d + fade.c * d * d;
            let cosine = dot(l, n);
            if cosine.simd_le(zero).all_true() {
                continue; // The terms of this light are 0.
            }
            let l_d = point_light.diffuse;
            let clamped = cosine.max_precise(0.0);
            i_d = vectors(|k| i_d[k] + r_d[k] / fade * clamped * l_d[k]);
            let r_v = dot(vectors(|k| 2.0 * cosine * n[k] - l[k]), eye);
            let shines = cosine.simd_gt(zero) & r_v.simd_gt(zero);
            if shines.any_true() {
                let power = power(simd, r_v, material.shininess);
                let term = |k: usize| r_s[k] / fade * power * specular[k];
                i_s = vectors(|k| i_s[k] + shines.select(term(k), zero));
            }
        }
        let i_a = ambient(&material.matte, scene.ambient_light);
        vectors(|k| i_a[k] + i_d[k] + i_s[k])
    }

    /// `direction_colour`, eight times.
    #[inline(always)]
    fn sky(&self) -> Vectors<S> {
        let [x, y, z] = self.v;
        [0.7 + 0.3 * x, 0.7 + 0.3 * y, 0.7 + 0.3 * -z]
    }

    /// `colour`, eight times. For each object that any of the rays sees, it lights
    /// all eight points, and keeps those of the rays that see the object.
    #[inline(always)]
    fn colour(
        &self,
        hits: &Hits<S>,
        found: &[Candidate],
        scene: &Scene<Material, Light>,
    ) -> Vectors<S> {
        let mut colour = self.sky();
        for sphere in &found[..hits.tested] {
            let index = self.simd.splat_f64x8(sphere.index as f64);
            let is_seen = hits.index.simd_eq(index);
            if is_seen.any_true() {
                let lit = self.phong(hits.t, &scene.objects[sphere.index], scene);
                colour = vectors(|k| is_seen.select(lit[k], colour[k]));
            }
        }
        colour
    }
}

/// Writes eight colours as `rgb8` does, or only as many as there's room for.
#[inline(always)]
fn write_rgb8<S: Simd>(colours: Vectors<S>, pixels: &mut [u8]) {
    let byte = |i: f64x8<S>| (255.0 * i + 0.5).max_precise(0.0).min(255.0).floor();
    // Put the three bytes of a pixel into one number, then the six of two
    // neighbours. An f64 holds whole numbers up to 2⁵³ exactly. Once 2⁵² is added
    // to such a number, its bits are the low bits of the f64.
    let [r, g, b] = colours;
    let pixel = byte(r) + 256.0 * byte(g) + 65536.0 * byte(b);
    let (even, odd) = pixel.deinterleave(pixel);
    let pairs = even + 16_777_216.0 * odd + 4_503_599_627_370_496.0;
    let mut bytes = [0; 24];
    for (six, pair) in bytes.chunks_exact_mut(6).zip(pairs.to_array()) {
        six.copy_from_slice(&pair.to_bits().to_le_bytes()[..6]);
    }
    if let Some(pixels) = pixels.first_chunk_mut() {
        *pixels = bytes;
    } else {
        // This is only for the right edge, because copying a length that isn't
        // known in advance is slower.
        pixels.iter_mut().zip(bytes).for_each(|(pixel, byte)| *pixel = byte);
    }
}

// 3. The picture, in bands of rows, in tiles, in blocks.

/// The side of a block, in pixels. A block is drawn with one list of candidates.
const BLOCK: usize = 16;

/// The side of a tile, and the height of a band; a multiple of the block's.
const TILE: usize = 32;

/// A part of the picture.
#[derive(Clone)]
struct Rectangle {
    columns: Range<usize>,
    rows: Range<usize>,
}

impl Rectangle {
    /// Cuts the rectangle into squares, which are smaller at its right and lower
    /// edges.
    fn squares(self, side: usize) -> impl Iterator<Item = Self> {
        let Self { columns, rows } = self;
        rows.clone().step_by(side).flat_map(move |j| {
            let (columns, rows) = (columns.clone(), j..rows.end.min(j + side));
            columns.clone().step_by(side).map(move |i| Self {
                columns: i..columns.end.min(i + side),
                rows: rows.clone(),
            })
        })
    }
}

/// Everything that the threads share.
struct View<'a> {
    camera: &'a Camera,
    scene: &'a Scene<Material, Light>,
    /// The points in a pixel through which its rays go.
    sub_pixel_offsets: Vec<(f64, f64)>,
    /// The spheres that the picture may show, from front to back.
    candidates: Vec<Candidate>,
    /// The normals of planes through the camera, each along the left edge of a
    /// column of blocks, and the last along the right edge. They point to the
    /// right.
    left_edges: Vec<DVec3>,
    /// The same for the upper edges of the rows of blocks. They point down.
    upper_edges: Vec<DVec3>,
}

impl<'a> View<'a> {
    fn new(
        camera: &'a Camera,
        samples: u32,
        scene: &'a Scene<Material, Light>,
    ) -> Self {
        let DMat3 { x_axis: x, y_axis: y, z_axis: z } = camera.matrix;
        let edges = |count: u32| {
            let blocks = count.div_ceil(BLOCK as u32);
            (0..=blocks).map(|k| f64::from(k) * BLOCK as f64 - 0.5)
        };
        // The plane along column i has the directions xi + z and y. If the picture
        // is mirrored, the determinant is negative, and the normal has to be
        // flipped.
        let determinant = camera.matrix.determinant();
        let sign = determinant.signum();
        let left = |i: f64| sign * y.cross(x * i + z).normalize();
        let upper = |j: f64| sign * (y * j + z).cross(x).normalize();
        let mut view = Self {
            camera,
            scene,
            sub_pixel_offsets: sub_pixel_offsets(samples),
            candidates: vec![],
            left_edges: edges(camera.h_res).map(left).collect(),
            upper_edges: edges(camera.v_res).map(upper).collect(),
        };
        // V and the normals are rounded, too. The terms of V are at most as long as
        // `longest`, and V itself is at least as long as `shortest`, the distance
        // of the plane of all V from the camera, so an error of 1e-14 `longest` is
        // an angle of 1e-14 `longest` / `shortest`. Again, the margin is larger
        // than that. In a picture without depth, the slack is infinite, and no
        // sphere is left out.
        let (right, down) = (x.length(), y.length());
        let longest = f64::from(camera.h_res) * right
            + f64::from(camera.v_res) * down
            + z.length();
        let shortest = determinant.abs() / (right * down);
        let slack = 1e-12 * longest / shortest;
        let whole = view.pyramid(&view.rectangle());
        let objects = scene.objects.iter().enumerate();
        let spheres = objects.map(|(index, object)| {
            Candidate::new(index, object, camera.centre, slack)
        });
        view.candidates = spheres.filter(|sphere| !whole.misses(sphere)).collect();
        view.candidates
            .sort_unstable_by(|one, other| one.begin.total_cmp(&other.begin));
        view
    }

    /// The whole picture.
    fn rectangle(&self) -> Rectangle {
        let (width, height) = (self.camera.h_res, self.camera.v_res);
        Rectangle { columns: 0..width as usize, rows: 0..height as usize }
    }

    /// The pyramid that a rectangle sees. The rectangle's left and upper edges have
    /// to be edges of blocks.
    fn pyramid(&self, Rectangle { columns, rows }: &Rectangle) -> Pyramid {
        Pyramid([
            self.left_edges[columns.start / BLOCK],
            -self.left_edges[columns.end.div_ceil(BLOCK)],
            self.upper_edges[rows.start / BLOCK],
            -self.upper_edges[rows.end.div_ceil(BLOCK)],
        ])
    }

    /// Draws a band, which consists of whole rows and begins with row `top`, into
    /// its bytes.
    ///
    /// The lists of a band, of a tile in it and of a block in the tile are sieves,
    /// one below the other. Each takes no more from the one above than it needs, so
    /// the spheres far behind a block's hits are never looked at.
    #[inline(always)]
    fn draw_band<S: Simd>(&self, simd: S, top: usize, bytes: &mut [u8]) {
        let mut band = self.rectangle();
        band.rows = top..top + bytes.len() / (3 * band.columns.end);
        let pyramid = self.pyramid(&band);
        let in_band = Sieve::new(&self.candidates[..], pyramid);
        let in_tile = Sieve::new(in_band, pyramid);
        let mut in_block = Sieve::new(in_tile, pyramid);
        for tile in band.squares(TILE) {
            let in_tile = &mut in_block.source;
            in_tile.restart(self.pyramid(&tile));
            in_tile.find_more();
            if in_tile.found().is_empty() {
                self.draw_rectangle(simd, &tile, top, bytes, &[], true);
                continue;
            }
            for mut block in tile.squares(BLOCK) {
                in_block.restart(self.pyramid(&block));
                // A call in the loop over the packets would cost it the registers
                // that hold V and a. So the search for more candidates is out here.
                while let Some(row) = self.draw_rectangle(
                    simd,
                    &block,
                    top,
                    bytes,
                    in_block.found(),
                    in_block.is_complete(),
                ) {
                    in_block.find_more();
                    block.rows.start = row;
                }
            }
        }
    }

    /// Draws a rectangle in a band, eight pixels at once. Returns None once all of
    /// it is drawn. If a row needs more candidates than an incomplete list has,
    /// returns that row. It and the rows below it have to be drawn again with a
    /// longer list.
    #[inline(always)]
    fn draw_rectangle<S: Simd>(
        &self,
        simd: S,
        Rectangle { columns, rows }: &Rectangle,
        top: usize,
        bytes: &mut [u8],
        found: &[Candidate],
        is_complete: bool,
    ) -> Option<usize> {
        let DMat3 { x_axis: x, y_axis: y, z_axis: z } = self.camera.matrix;
        let (start, width) = (self.camera.centre, self.camera.h_res as usize);
        let eight: f64x8<S> =
            [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0].simd_into(simd);
        for row in rows.clone() {
            for column in columns.clone().step_by(8) {
                let mut sum = [simd.splat_f64x8(0.0); 3];
                for (right, below) in &self.sub_pixel_offsets {
                    let i = column as f64 + eight + *right;
                    let j = row as f64 + below;
                    let v = vectors(|k| x[k] * i + y[k] * j + z[k]);
                    let packet = Packet { simd, start, v, a: dot(v, v) };
                    let Some(hits) = packet.nearest(found, is_complete) else {
                        return Some(row);
                    };
                    let colour = packet.colour(&hits, found, self.scene);
                    sum = vectors(|k| sum[k] + colour[k]);
                }
                let count = self.sub_pixel_offsets.len() as f64;
                if count > 1.0 {
                    sum = vectors(|k| sum[k] / count);
                }
                let first = 3 * ((row - top) * width + column);
                let last = 3 * ((row - top) * width + columns.end.min(column + 8));
                write_rgb8(sum, &mut bytes[first..last]);
            }
        }
        None
    }
}

/// The picture that `render` draws with `colour`, byte for byte.
pub fn draw(
    level: Level,
    camera: &Camera,
    samples: u32,
    scene: &Scene<Material, Light>,
) -> RgbImage {
    let view = View::new(camera, samples, scene);
    let mut image = RgbImage::new(camera.h_res, camera.v_res);
    let bands = image.par_chunks_mut(3 * TILE * camera.h_res as usize).enumerate();
    bands.for_each(|(k, bytes)| {
        dispatch!(level, simd => view.draw_band(simd, k * TILE, bytes));
    });
    image
}

/// The picture of step 5, drawn with the best instructions of this processor.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    draw(Level::new(), camera, samples, &scene())
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
