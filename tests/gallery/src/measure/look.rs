use super::{Alternative, Bytes, Eye, Sky};
use crate::difference::apart;
use crate::{Parts, Step, camera};
use glam::DMat3;
use image::{Rgb, RgbImage};

/// A picture of a step, and what is known so far of the program that drew it.
pub(super) struct Look<'a> {
    pub yours: &'a RgbImage,
    pub step: Step,
    /// How its intensities became bytes.
    pub bytes: Bytes,
    /// What its sky tells; None where it has none.
    pub sky: Option<Sky>,
    /// How well its camera is known.
    pub eye: Eye,
    /// Whether it has several rays a pixel, as its edges tell.
    pub is_smooth: bool,
    /// The side of the grid of rays in each pixel, where that is known.
    pub samples: u32,
    /// What draws the right picture.
    pub right: Parts,
    /// What draws this one, as far as it is known.
    pub theirs: Parts,
    /// What the colour of the sky makes of V before it becomes a colour.
    pub tint: DMat3,
    /// Whether its outlines are known.
    pub has_shapes: bool,
    /// Other parts that draw the same outlines.
    pub others: Vec<Parts>,
    /// What is wrong with the rays or the sky, where that has a name.
    pub fault: Option<Alternative>,
}

/// A pixel, and what is seen there by the parts that are known.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub i: u32,
    pub j: u32,
    /// Whether the picture has the sky's colour here.
    pub is_sky: bool,
    /// Which object should be here.
    pub hit: Option<usize>,
}

impl<'a> Look<'a> {
    pub fn new(yours: &'a RgbImage, step: Step) -> Self {
        let (width, height) = yours.dimensions();
        let right = Parts::right(&camera(width, height));
        let mut look = Self {
            yours,
            step,
            bytes: Bytes::of(yours, step),
            sky: None,
            eye: Eye::Right,
            is_smooth: false,
            samples: 1,
            has_shapes: true,
            others: vec![],
            theirs: right.clone(),
            right,
            tint: DMat3::IDENTITY,
            fault: None,
        };
        look.sky = Sky::of(yours, &look.bytes);
        look.find_eye();
        if look.bytes.is_swapped() && look.eye != Eye::Right {
            look.unswap();
        }
        if look.eye == Eye::Read {
            look.recode();
        }
        look.is_smooth = look.has_smooth_edges();
        look
    }

    /// Takes the bytes for those of another curve where that makes the sky exact.
    fn recode(&mut self) {
        let (bytes, sky, fault) = (self.bytes, self.sky, self.fault);
        let (eye, theirs, tint) = (self.eye, self.theirs.clone(), self.tint);
        for other in Bytes::others() {
            self.bytes = other;
            self.sky = Sky::of(self.yours, &self.bytes);
            if self.sky.is_some() && self.has_exact_sky() {
                return;
            }
        }
        (self.bytes, self.sky, self.fault) = (bytes, sky, fault);
        (self.eye, self.theirs, self.tint) = (eye, theirs, tint);
    }

    /// Takes the bytes for those of the right order where that makes the sky right.
    fn unswap(&mut self) {
        let (bytes, sky, fault) = (self.bytes, self.sky, self.fault);
        let (eye, theirs, tint) = (self.eye, self.theirs.clone(), self.tint);
        self.bytes.order = Bytes::RIGHT.order;
        self.sky = Sky::of(self.yours, &self.bytes);
        self.find_eye();
        if self.eye != Eye::Right {
            (self.bytes, self.sky, self.fault) = (bytes, sky, fault);
            (self.eye, self.theirs, self.tint) = (eye, theirs, tint);
        }
    }

    /// Whether what is known of it draws some pixels a little otherwise.
    pub fn is_loose(&self) -> bool {
        self.is_smooth || matches!(self.eye, Eye::Read | Eye::Unknown)
    }

    /// All pixels, or some 200,000 of them where there are many more.
    pub fn pixels(&self) -> impl Iterator<Item = (u32, u32)> + use<> {
        let (width, height) = self.yours.dimensions();
        let all = u64::from(width) * u64::from(height);
        let stride = (all / 260_000).isqrt() as usize + 1;
        let columns = move |j| (0..width).step_by(stride).map(move |i| (i, j));
        (0..height).step_by(stride).flat_map(columns)
    }

    /// Those pixels, and what is seen there.
    pub fn places(&self) -> Vec<Place> {
        let place = |(i, j)| {
            let hit = hit(&self.theirs, self.step, f64::from(i), f64::from(j));
            let sky = self.sky_pixel(&self.theirs, &self.tint, i, j);
            let most = if hit.is_some() { 1 } else { 6 };
            let is_sky = apart(self.yours.get_pixel(i, j), &sky) <= most;
            // Where an object has the sky's colour, it is the object.
            let is_sky = is_sky && (hit.is_none() || !self.is_object(i, j));
            Place { i, j, is_sky, hit }
        };
        self.pixels().map(place).collect()
    }

    /// Whether a pixel is what the parts that are known make of their object there.
    fn is_object(&self, i: u32, j: u32) -> bool {
        let ours = self.bytes.write(self.theirs.intensity(self.step, i, j));
        near(self.yours.get_pixel(i, j), &ours)
    }

    /// The pixel that the sky should be, by these parts and this tint.
    pub fn sky_pixel(
        &self,
        parts: &Parts,
        tint: &DMat3,
        i: u32,
        j: u32,
    ) -> Rgb<u8> {
        let mut ray = (parts.ray)(parts.camera.ray(i.into(), j.into()));
        ray.direction = *tint * ray.direction;
        self.bytes.write((parts.miss)(&ray))
    }

    /// Whether one ray through this pixel may see something else than another.
    pub fn is_edge(&self, i: u32, j: u32) -> bool {
        let hit = |di: f64, dj: f64| {
            hit(&self.theirs, self.step, f64::from(i) + di, f64::from(j) + dj)
        };
        let middle = hit(0.0, 0.0);
        let corners = [(-0.6, -0.6), (0.6, -0.6), (-0.6, 0.6), (0.6, 0.6)];
        corners.iter().any(|&(di, dj)| hit(di, dj) != middle)
    }

    /// Whether the pixels along the outlines are mixed of two colours.
    fn has_smooth_edges(&self) -> bool {
        let (mut all, mut mixed) = (0, 0);
        for (i, j) in self.pixels().filter(|(_, j)| j % 4 == 0) {
            let is_sky = hit(&self.theirs, self.step, i.into(), j.into()).is_none();
            if is_sky && self.is_edge(i, j) {
                let sky = self.sky_pixel(&self.theirs, &self.tint, i, j);
                all += 1;
                mixed += usize::from(!near(self.yours.get_pixel(i, j), &sky));
            }
        }
        all < 4 * mixed
    }
}

/// The number of the object that `parts` see through a point of the picture.
pub(super) fn hit(parts: &Parts, step: Step, i: f64, j: f64) -> Option<usize> {
    let point = parts.seen(step, &(parts.ray)(parts.camera.ray(i, j)))?;
    let objects = parts.objects(step).iter();
    objects
        .map(|object| &object.material)
        .position(|m| std::ptr::eq(m, point.material))
}

/// Whether two pixels differ by one at most.
pub(super) fn near(a: &Rgb<u8>, b: &Rgb<u8>) -> bool {
    apart(a, b) <= 1
}
