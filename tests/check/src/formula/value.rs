use glam::DVec3;
use std::ops::Mul;
use std::slice::from_ref;
use std::sync::Arc;

/// The values of an expression for many rays at once, or the one that all have.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    Scalar(f64),
    Vector(DVec3),
    Scalars(Arc<[f64]>),
    Vectors(Arc<[DVec3]>),
}

impl From<f64> for Value {
    fn from(one: f64) -> Self {
        Self::Scalar(one)
    }
}

impl From<DVec3> for Value {
    fn from(one: DVec3) -> Self {
        Self::Vector(one)
    }
}

/// The values as such.
enum List<'a> {
    Scalars(&'a [f64]),
    Vectors(&'a [DVec3]),
}

/// One of many values: the k-th, or the only one.
#[inline(always)]
fn at<T: Copy>(all: &[T], k: usize) -> T {
    if all.len() == 1 { all[0] } else { all[k] }
}

#[inline(always)]
fn zip<A: Copy, B: Copy, C>(
    a: &[A],
    b: &[B],
    f: impl Fn(A, B) -> C,
) -> Result<C, Arc<[C]>> {
    Err(match (a, b) {
        ([a], [b]) => return Ok(f(*a, *b)),
        ([a], b) => b.iter().map(|b| f(*a, *b)).collect(),
        (a, [b]) => a.iter().map(|a| f(*a, *b)).collect(),
        (a, b) => a.iter().zip(b).map(|(a, b)| f(*a, *b)).collect(),
    })
}

#[inline(always)]
fn each<A: Copy, C>(a: &[A], f: impl Fn(A) -> C) -> Result<C, Arc<[C]>> {
    match a {
        [a] => Ok(f(*a)),
        all => Err(all.iter().map(|a| f(*a)).collect()),
    }
}

impl From<Result<f64, Arc<[f64]>>> for Value {
    fn from(all: Result<f64, Arc<[f64]>>) -> Self {
        all.map_or_else(Self::Scalars, Self::Scalar)
    }
}

impl From<Result<DVec3, Arc<[DVec3]>>> for Value {
    fn from(all: Result<DVec3, Arc<[DVec3]>>) -> Self {
        all.map_or_else(Self::Vectors, Self::Vector)
    }
}

impl Value {
    #[inline(always)]
    fn list(&self) -> List<'_> {
        match self {
            Self::Scalar(one) => List::Scalars(from_ref(one)),
            Self::Vector(one) => List::Vectors(from_ref(one)),
            Self::Scalars(all) => List::Scalars(all),
            Self::Vectors(all) => List::Vectors(all),
        }
    }

    /// How many values there are: 1 where all rays have the same.
    #[inline(always)]
    pub fn len(&self) -> usize {
        match self.list() {
            List::Scalars(all) => all.len(),
            List::Vectors(all) => all.len(),
        }
    }

    /// Whether each is a vector.
    #[inline(always)]
    pub fn is_vector(&self) -> bool {
        matches!(self.list(), List::Vectors(_))
    }

    /// That of the k-th ray, where it is a scalar; else its x.
    #[inline(always)]
    pub fn scalar(&self, k: usize) -> f64 {
        match self.list() {
            List::Scalars(all) => at(all, k),
            List::Vectors(all) => at(all, k).x,
        }
    }

    /// That of the k-th ray, as a vector.
    #[inline(always)]
    pub fn vector(&self, k: usize) -> DVec3 {
        match self.list() {
            List::Scalars(all) => DVec3::splat(at(all, k)),
            List::Vectors(all) => at(all, k),
        }
    }

    /// Part by part.
    pub fn map(&self, f: impl Fn(f64) -> f64) -> Self {
        match self.list() {
            List::Scalars(all) => each(all, f).into(),
            List::Vectors(all) => {
                each(all, |v| DVec3::new(f(v.x), f(v.y), f(v.z))).into()
            }
        }
    }

    /// Part by part, with those of another.
    pub fn zip(&self, other: &Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let parts =
            |a: DVec3, b: DVec3| DVec3::new(f(a.x, b.x), f(a.y, b.y), f(a.z, b.z));
        let splat = DVec3::splat;
        match (self.list(), other.list()) {
            (List::Scalars(a), List::Scalars(b)) => zip(a, b, f).into(),
            (List::Scalars(a), List::Vectors(b)) => {
                zip(a, b, |a, b| parts(splat(a), b)).into()
            }
            (List::Vectors(a), List::Scalars(b)) => {
                zip(a, b, |a, b| parts(a, splat(b))).into()
            }
            (List::Vectors(a), List::Vectors(b)) => zip(a, b, parts).into(),
        }
    }

    /// A vector of each.
    pub fn vectors(&self, f: impl Fn(DVec3) -> DVec3) -> Self {
        match self.list() {
            List::Scalars(all) => each(all, |x| f(DVec3::splat(x))).into(),
            List::Vectors(all) => each(all, f).into(),
        }
    }

    /// A scalar of each.
    pub fn scalars(&self, f: impl Fn(DVec3) -> f64) -> Self {
        match self.list() {
            List::Scalars(all) => each(all, |x| f(DVec3::splat(x))).into(),
            List::Vectors(all) => each(all, f).into(),
        }
    }

    /// l·n of each two.
    pub fn dot(&self, other: &Self) -> Self {
        match (self.list(), other.list()) {
            (List::Vectors(a), List::Vectors(b)) => zip(a, b, DVec3::dot).into(),
            _ => self.zip(other, f64::mul),
        }
    }

    /// l × n of each two.
    pub fn cross(&self, other: &Self) -> Self {
        match (self.list(), other.list()) {
            (List::Vectors(a), List::Vectors(b)) => zip(a, b, DVec3::cross).into(),
            _ => self.clone(),
        }
    }

    /// The number, where all rays have the same.
    pub fn uniform(&self) -> Option<f64> {
        let List::Scalars(all) = self.list() else { return None };
        let first = *all.first()?;
        all.iter().all(|x| *x == first).then_some(first)
    }

    /// This where a number is true (not 0), else the other.
    pub fn select(truth: &Self, yes: &Self, no: &Self) -> Self {
        if truth.len() == 1 {
            return if truth.scalar(0) == 0.0 { no.clone() } else { yes.clone() };
        }
        let all = 0..truth.len();
        let which = |k: usize| if truth.scalar(k) == 0.0 { no } else { yes };
        match yes.is_vector() || no.is_vector() {
            false => Self::Scalars(all.map(|k| which(k).scalar(k)).collect()),
            true => Self::Vectors(all.map(|k| which(k).vector(k)).collect()),
        }
    }
}
