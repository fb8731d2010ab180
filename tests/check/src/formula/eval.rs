use super::{Change, Context, Node, Of, Op, Pixel, Tree, Value};
use glam::DVec3;
use std::borrow::Cow;
use std::cell::{Cell, OnceCell};
use std::ops::{Add, Div, Mul, Sub};
use std::sync::atomic::Ordering;

/// How many rays are best evaluated at once, where there are many.
const SOME: usize = 512;

/// How many pixels of `samples` × `samples` rays are best evaluated at once.
pub(crate) fn batch(samples: u32) -> usize {
    (SOME / samples.pow(2) as usize).max(1)
}

/// The values of the lines at some pixels; each is computed when it is asked for.
#[derive(Clone, Debug)]
pub(crate) struct Values {
    /// In lists: of the first ray of each pixel, then of the second, and so on.
    known: Vec<Option<Value>>,
    rays: usize,
    pixels: usize,
}

/// The same with changes: what they do not reach is known already.
pub(crate) struct Changed<'a> {
    context: &'a Context<'a>,
    base: &'a Values,
    own: Vec<OnceCell<Value>>,
    /// How many values have been computed, and lists of them.
    work: Cell<usize>,
}

/// Where an expression is evaluated: for which object or light.
#[derive(Clone, Copy)]
struct Here<'a> {
    which: usize,
    lamp: Option<usize>,
    argument: &'a Value,
}

const ZERO: Value = Value::Scalar(0.0);

/// As many values cost as much as making the list for them.
const LIST: usize = 40;

impl Values {
    /// Those of pixels of `samples` × `samples` rays; of one ray, through the centre.
    pub fn at(tree: &Tree, places: &[Pixel], samples: u32) -> Self {
        let rays = samples * samples;
        let list = |of: &dyn Fn(u32, Pixel) -> u32| -> Value {
            let all = || {
                (0..rays).flat_map(|ray| places.iter().map(move |at| of(ray, *at)))
            };
            match (places, rays) {
                ([place], 1) => f64::from(of(0, *place)).into(),
                _ => Value::Scalars(all().map(f64::from).collect()),
            }
        };
        let own = [
            list(&|_, place| place.0),
            list(&|_, place| place.1),
            list(&|ray, _| ray % samples),
            list(&|ray, _| ray / samples),
        ];
        let mut known = tree.given.clone();
        // The tree has the centre.
        let given = if samples == 1 { 2 } else { 4 };
        for (slot, value) in tree.of_ray.iter().zip(own).take(given) {
            known[*slot] = Some(value);
        }
        Self { known, rays: rays as usize, pixels: places.len() }
    }

    /// With all values known that the pixels need.
    pub fn filled(self, context: &Context) -> Self {
        let all = self.changed(context);
        all.pixels();
        let both = all.own.into_iter().zip(&self.known);
        let known = both.map(|(own, known)| known.clone().or(own.into_inner()));
        Self { known: known.collect(), ..self }
    }

    pub fn changed<'a>(&'a self, context: &'a Context) -> Changed<'a> {
        let mut own = vec![];
        own.resize_with(self.known.len(), OnceCell::new);
        for change in context.changes {
            let Change::Given(line, which, value) = change else { continue };
            let line = &context.tree.lines[*line];
            for (k, ours) in line.given.iter().enumerate() {
                own[line.start + k].get_or_init(|| ours.clone());
            }
            own[line.start + which] = value.clone().into();
        }
        Changed { context, base: self, own, work: Cell::new(1) }
    }

    /// How many rays there are.
    fn all_rays(&self) -> usize {
        self.rays * self.pixels
    }
}

impl Changed<'_> {
    /// The bytes of the pixels.
    pub fn pixels(&self) -> Vec<[u8; 3]> {
        let tree = self.context.tree;
        let value = self.name(tree.lines.len() - 1, 0);
        tree.work.fetch_add(self.work.get(), Ordering::Relaxed);
        let byte = |v: DVec3| v.to_array().map(|channel| channel as u8);
        (0..self.base.pixels).map(|k| byte(value.vector(k))).collect()
    }

    /// The values of a line, for an object or a light; what there is one of has no other.
    pub fn name(&self, name: usize, which: usize) -> &Value {
        let context = self.context;
        let line = &context.tree.lines[name];
        let which = if which < line.count { which } else { 0 };
        let slot = line.start + which;
        let is_stale = context.is_stale(name, which);
        let base = self.base.known[slot].as_ref().filter(|_| !is_stale);
        base.unwrap_or_else(|| {
            self.own[slot].get_or_init(|| {
                self.work.set(self.work.get() + LIST + self.base.all_rays());
                let lamp = context.lamp(name);
                let here = Here { which, lamp, argument: &ZERO };
                let node = context.other(name).or(line.node.as_ref());
                node.map_or(ZERO, |node| self.value(node, here).into_owned())
            })
        })
    }

    fn value<'s>(&'s self, node: &Node, here: Here<'s>) -> Cow<'s, Value> {
        let context = self.context;
        let Node::Of(op, nodes) = node else {
            return match node {
                Node::Number(number) => Cow::Owned((*number).into()),
                Node::Name(name) => {
                    let line = &context.tree.lines[*name];
                    let is_lamp = line.of == Of::Light && line.node.is_none();
                    let lamp = here.lamp.filter(|_| is_lamp);
                    let which = lamp.unwrap_or(here.which);
                    Cow::Borrowed(self.name(*name, which))
                }
                Node::Free(_) => Cow::Borrowed(&context.free),
                _ => Cow::Borrowed(here.argument),
            };
        };
        Cow::Owned(match (op, &nodes[..]) {
            (Op::Nearest, [Node::Name(order), margin]) => {
                let margin = self.value(margin, here).scalar(0);
                self.nearest(*order, margin)
            }
            (Op::Chosen, [Node::Name(name)]) => self.chosen(*name),
            (
                Op::Sum | Op::Product | Op::Most | Op::Alone(_),
                [Node::Name(name)],
            ) => self.total(*op, *name),
            (Op::Mean, [node]) if 1 < self.base.rays => {
                self.mean(&self.value(node, here), 0)
            }
            (Op::Last, [node]) => {
                self.mean(&self.value(node, here), self.base.rays - 1)
            }
            (Op::Call(line), [node]) => {
                let argument = self.value(node, here);
                let node = context.other(*line);
                let node = node.or(context.tree.lines[*line].node.as_ref());
                let here = Here { argument: &argument, ..here };
                node.map_or(ZERO, |node| self.value(node, here).into_owned())
            }
            (Op::If, [truth, yes, no]) => {
                let truth = self.value(truth, here);
                match truth.uniform() {
                    Some(truth) => {
                        let which = if truth == 0.0 { no } else { yes };
                        return self.value(which, here);
                    }
                    None => {
                        let yes = self.value(yes, here);
                        Value::select(&truth, &yes, &self.value(no, here))
                    }
                }
            }
            (op, [a]) => one(*op, &self.value(a, here)),
            (op, [a, b]) => two(*op, &self.value(a, here), &self.value(b, here)),
            (_, [x, y, z]) => {
                let [x, y, z] = [x, y, z].map(|node| self.value(node, here));
                vector(&x, &y, &z)
            }
            _ => ZERO,
        })
    }

    /// Which object has the least number, of those that are met: each has to be less
    /// than the one before it and the margin.
    fn nearest(&self, order: usize, margin: f64) -> Value {
        let tree = self.context.tree;
        let there = (0..tree.count(Of::Object)).filter(|k| self.context.has(*k));
        let there = there.map(|k| (k as f64, self.name(tree.hit, k), k));
        let is_met = |t: &Value| t.uniform() != Some(f64::INFINITY);
        let met: Vec<_> = there
            .filter(|(_, t, _)| is_met(t))
            .map(|(number, t, k)| (number, t, self.name(order, k)))
            .collect();
        let one = |ray: usize| {
            let mut best = (-1.0, f64::INFINITY);
            for (number, t, keys) in &met {
                let key = keys.scalar(ray);
                if t.scalar(ray) != f64::INFINITY
                    && (best.0 < 0.0 || key < best.1 + margin)
                {
                    best = (*number, key);
                }
            }
            best.0
        };
        match self.base.all_rays() {
            1 => one(0).into(),
            all => Value::Scalars((0..all).map(one).collect()),
        }
    }

    /// A number of the nearest object; that of the first where none is met.
    fn chosen(&self, name: usize) -> Value {
        let nearest = self.name(self.context.tree.nearest, 0);
        let object = |ray: usize| {
            let object = nearest.scalar(ray).max(0.0) as usize;
            self.name(name, object)
        };
        let all = 0..self.base.all_rays();
        match (all.len(), object(0).is_vector()) {
            (1, _) => object(0).clone(),
            (_, false) => {
                Value::Scalars(all.map(|ray| object(ray).scalar(ray)).collect())
            }
            (_, true) => {
                Value::Vectors(all.map(|ray| object(ray).vector(ray)).collect())
            }
        }
    }

    /// That of all lights together, or of one alone.
    fn total(&self, op: Op, name: usize) -> Value {
        let count = self.context.tree.lines[name].count;
        let mut all = (0..count).map(|which| self.name(name, which).clone());
        let f: fn(f64, f64) -> f64 = match op {
            Op::Alone(which) => {
                return all.nth(which.min(count - 1)).unwrap_or(ZERO);
            }
            Op::Product => f64::mul,
            Op::Most => f64::max,
            _ => f64::add,
        };
        all.reduce(|a, b| a.zip(&b, f)).unwrap_or(ZERO)
    }

    /// That of all rays of a pixel, from one of them on: their sum, by the number of all.
    fn mean(&self, value: &Value, from: usize) -> Value {
        let Values { rays, pixels, .. } = *self.base;
        let mean = |pixel: usize| {
            let its = (from..rays).map(|ray| value.vector(ray * pixels + pixel));
            its.sum::<DVec3>() * (1.0 / rays as f64)
        };
        match pixels {
            1 => mean(0).into(),
            all => Value::Vectors((0..all).map(mean).collect()),
        }
    }
}

fn one(op: Op, v: &Value) -> Value {
    // One copy of what lists need for these.
    let part: fn(f64) -> f64 = match op {
        Op::Length => return v.scalars(DVec3::length),
        Op::Unit => return v.vectors(DVec3::normalize),
        Op::Part(axis) => return v.scalars(|v| v[axis]),
        Op::Neg => |x| -x,
        Op::Sqrt => f64::sqrt,
        Op::Abs => f64::abs,
        Op::Tan => f64::tan,
        Op::Atan => f64::atan,
        Op::Sin => f64::sin,
        Op::Cos => f64::cos,
        Op::Acos => |x| x.clamp(-1.0, 1.0).acos(),
        Op::Floor => f64::floor,
        Op::Ceil => f64::ceil,
        _ => return v.clone(),
    };
    v.map(part)
}

fn two(op: Op, a: &Value, b: &Value) -> Value {
    // One copy of what lists need for these; what is met often has its own.
    let other: fn(f64, f64) -> f64 = match op {
        Op::Add => return a.zip(b, f64::add),
        Op::Sub => return a.zip(b, f64::sub),
        Op::Mul => return a.zip(b, f64::mul),
        Op::Cross => return a.cross(b),
        Op::Div => f64::div,
        Op::Max => f64::max,
        Op::Min => f64::min,
        Op::Less => |a, b| f64::from(a < b),
        Op::LessOrEqual => |a, b| f64::from(a <= b),
        Op::Pow => power,
        _ => return a.dot(b),
    };
    a.zip(b, other)
}

/// xⁿ, as `powi` has it where n is a whole number.
fn power(x: f64, n: f64) -> f64 {
    if n.fract() == 0.0 && n.abs() < 1e6 { x.powi(n as i32) } else { x.powf(n) }
}

fn vector(x: &Value, y: &Value, z: &Value) -> Value {
    if x.len().max(y.len()).max(z.len()) == 1 {
        return DVec3::new(x.scalar(0), y.scalar(0), z.scalar(0)).into();
    }
    let count = x.len().max(y.len()).max(z.len());
    let all = (0..count).map(|k| DVec3::new(x.scalar(k), y.scalar(k), z.scalar(k)));
    Value::Vectors(all.collect())
}
