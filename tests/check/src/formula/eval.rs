use super::{Node, Of, Op, Tree, Value};
use glam::DVec3;
use std::rc::Rc;

/// The value of every line, for some rays at once: for each object, or light, or one.
#[derive(Clone, Debug, Default)]
pub(crate) struct Values {
    pub all: Vec<Rc<[Value]>>,
    /// How many rays there are, and how many of them a pixel has.
    pub rays: usize,
    pub side: usize,
}

/// What takes the place of a line, or of a number that is given.
#[derive(Clone, Debug)]
pub(crate) enum Change {
    /// A line is another formula.
    Line(usize, Node),
    /// The number of an object or a light is another one.
    Given(usize, usize, Value),
    /// A line takes the numbers of one light for all.
    Lamp(usize, usize),
    /// Objects that are not there: those before the first, and from the second on.
    Objects(usize, usize),
    /// The object is left out.
    Without(usize),
}

/// What is evaluated: the lines, with changes and with a value for the unknown.
pub(crate) struct Context<'a> {
    pub tree: &'a Tree,
    pub changes: &'a [Change],
    pub free: Value,
}

impl Context<'_> {
    /// The changes of this time, and those of the tree.
    fn others(&self) -> impl Iterator<Item = &Change> {
        self.changes.iter().chain(&self.tree.always)
    }
}

impl Values {
    /// The values at some pixels, each of `samples` × `samples` rays.
    pub fn at(context: &Context, places: &[(u32, u32)], samples: u32) -> Self {
        let side = samples as usize * samples as usize;
        let mut values = Self { all: vec![], rays: places.len() * side, side };
        // What is given to each ray, from its pixel and its place in that.
        let list = |f: &dyn Fn(usize, usize) -> f64| {
            let rays =
                (0..places.len()).flat_map(|p| (0..side).map(move |k| (p, k)));
            Value::Scalars(rays.map(|(p, k)| f(p, k)).collect())
        };
        let given = |name: &str| match name {
            "column" => Some(list(&|p, _| places[p].0.into())),
            "row" => Some(list(&|p, _| places[p].1.into())),
            "k_u" if 1 < side => Some(list(&|_, k| (k % samples as usize) as f64)),
            "k_v" if 1 < side => Some(list(&|_, k| (k / samples as usize) as f64)),
            _ => None,
        };
        for line in &context.tree.lines {
            let own = given(&line.name).map(|value| Rc::from([value]));
            values.all.push(own.unwrap_or_else(|| line.given.clone().into()));
        }
        values.fill(context, u128::MAX);
        values
    }

    /// The same with other changes: only what they reach is evaluated anew.
    pub fn changed(&self, context: &Context) -> Self {
        let mut values = self.clone();
        let mut stale = 0;
        for change in context.changes {
            match change {
                Change::Line(k, _) | Change::Lamp(k, _) | Change::Given(k, ..) => {
                    stale |= 1 << k;
                }
                Change::Objects(..) | Change::Without(_) => {
                    stale |= 1 << context.tree.nearest;
                }
            }
        }
        values.fill(context, stale);
        values
    }

    /// Evaluates all lines that are stale, a bit for each, or that need one which is.
    fn fill(&mut self, context: &Context, mut stale: u128) {
        let tree = context.tree;
        for change in context.changes {
            if let Change::Given(name, which, value) = change {
                let mut all = self.all[*name].to_vec();
                all[*which] = value.clone();
                self.all[*name] = all.into();
            }
        }
        for (k, line) in tree.lines.iter().enumerate() {
            let mut its = context.changes.iter();
            let other = its.find_map(|change| match change {
                Change::Line(name, node) if *name == k => Some(node),
                _ => None,
            });
            let uses = other.map_or(line.uses, |node| tree.uses(node));
            let Some(node) = other.or(line.node.as_ref()) else { continue };
            if uses & stale != 0 {
                stale |= 1 << k;
            }
            if stale >> k & 1 == 0 || !line.is_needed || line.is_function {
                continue;
            }
            let count = match line.of {
                Of::Object | Of::Light => tree.count(line.of),
                _ => 1,
            };
            let lamp = context.others().find_map(|change| match change {
                Change::Lamp(name, lamp) if *name == k => Some(*lamp),
                _ => None,
            });
            let value = |which: usize| {
                let here = Here { values: self, context, which, lamp };
                here.value(node, &Value::from(0.0))
            };
            self.all[k] = (0..count).map(value).collect();
        }
    }

    /// The bytes of the pixels.
    pub fn pixels(&self, context: &Context) -> Vec<[u8; 3]> {
        let value = &self.all[context.tree.lines.len() - 1][0];
        let byte = |v: DVec3| v.to_array().map(|channel| channel as u8);
        (0..self.rays / self.side).map(|k| byte(value.vector(k))).collect()
    }
}

/// Where an expression is evaluated: for which object or light.
struct Here<'a> {
    values: &'a Values,
    context: &'a Context<'a>,
    which: usize,
    lamp: Option<usize>,
}

impl Here<'_> {
    fn name(&self, name: usize) -> &Value {
        let all = &self.values.all[name];
        let line = &self.context.tree.lines[name];
        let is_lamp = line.of == Of::Light && line.node.is_none();
        let which = self.lamp.filter(|_| is_lamp).unwrap_or(self.which);
        all.get(which).unwrap_or(&all[0])
    }

    fn value(&self, node: &Node, argument: &Value) -> Value {
        let Node::Of(op, nodes) = node else {
            return match node {
                Node::Number(number) => (*number).into(),
                Node::Name(name) => self.name(*name).clone(),
                Node::Free(_) => self.context.free.clone(),
                _ => argument.clone(),
            };
        };
        match (op, &nodes[..]) {
            (Op::Nearest, [Node::Name(order)]) => return self.nearest(*order),
            (Op::Chosen, [Node::Name(name)]) => return self.chosen(*name),
            (Op::Sum | Op::Product | Op::Alone(_), [Node::Name(name)]) => {
                return self.total(*op, *name);
            }
            _ => {}
        }
        let mut all = nodes.iter().map(|node| self.value(node, argument));
        let first = all.next().unwrap_or(Value::from(0.0));
        let Some(second) = all.next() else { return self.one(*op, &first) };
        match all.next() {
            None => two(*op, &first, &second),
            Some(third) if *op == Op::If => Value::select(&first, &second, &third),
            Some(third) => vector(&first, &second, &third),
        }
    }

    fn one(&self, op: Op, v: &Value) -> Value {
        match op {
            Op::Neg => v.map(|x| -x),
            Op::Sqrt => v.map(f64::sqrt),
            Op::Abs => v.map(f64::abs),
            Op::Length => v.scalars(DVec3::length),
            Op::Unit => v.vectors(DVec3::normalize),
            Op::Tan => v.map(f64::tan),
            Op::Sin => v.map(f64::sin),
            Op::Cos => v.map(f64::cos),
            Op::Acos => v.map(|x| x.clamp(-1.0, 1.0).acos()),
            Op::Floor => v.map(f64::floor),
            Op::Ceil => v.map(f64::ceil),
            Op::Part(axis) => v.scalars(|v| v[axis]),
            Op::Mean => self.mean(v),
            Op::Last => self.last(v),
            Op::Call(line) => {
                let other = self.context.changes.iter().find_map(|c| match c {
                    Change::Line(name, node) if *name == line => Some(node),
                    _ => None,
                });
                let own = self.context.tree.lines[line].node.as_ref();
                other.or(own).map_or(v.clone(), |node| self.value(node, v))
            }
            _ => v.clone(),
        }
    }

    /// Which object has the least number, of those that are met.
    fn nearest(&self, order: usize) -> Value {
        let tree = self.context.tree;
        let (orders, ts) = (&self.values.all[order], &self.values.all[tree.hit]);
        let is_there = |k: usize| {
            self.context.others().all(|change| match change {
                Change::Objects(start, end) => (*start..*end).contains(&k),
                Change::Without(object) => k != *object,
                _ => true,
            })
        };
        let there: Vec<_> = (0..ts.len()).filter(|k| is_there(*k)).collect();
        let one = |ray: usize| {
            let mut best = (-1.0, f64::INFINITY);
            for &k in &there {
                let key = orders[k.min(orders.len() - 1)].scalar(ray);
                if ts[k].scalar(ray) != f64::INFINITY
                    && (best.0 < 0.0 || key < best.1)
                {
                    best = (k as f64, key);
                }
            }
            best.0
        };
        Value::Scalars((0..self.values.rays).map(one).collect())
    }

    /// A number of the nearest object; that of the first where none is met.
    fn chosen(&self, name: usize) -> Value {
        let nearest = self.context.tree.nearest;
        let (which, all) = (&self.values.all[nearest][0], &self.values.all[name]);
        let object = |ray: usize| {
            all.get(which.scalar(ray).max(0.0) as usize).unwrap_or(&all[0])
        };
        let rays = 0..self.values.rays;
        match all[0].is_vector() {
            false => {
                Value::Scalars(rays.map(|ray| object(ray).scalar(ray)).collect())
            }
            true => {
                Value::Vectors(rays.map(|ray| object(ray).vector(ray)).collect())
            }
        }
    }

    /// That of all lights together.
    fn total(&self, op: Op, name: usize) -> Value {
        let all = &self.values.all[name];
        match op {
            Op::Alone(which) => all[which.min(all.len() - 1)].clone(),
            Op::Product => all
                .iter()
                .skip(1)
                .fold(all[0].clone(), |a, b| a.zip(b, |a, b| a * b)),
            _ => all
                .iter()
                .skip(1)
                .fold(all[0].clone(), |a, b| a.zip(b, |a, b| a + b)),
        }
    }

    /// That of the last ray of a pixel, as if it were all of them.
    fn last(&self, value: &Value) -> Value {
        let side = self.values.side;
        let last =
            |pixel: usize| value.vector(pixel * side + side - 1) / side as f64;
        Value::Vectors((0..self.values.rays / side).map(last).collect())
    }

    /// That of all rays of a pixel.
    fn mean(&self, value: &Value) -> Value {
        let side = self.values.side;
        if side == 1 || value.len() == 1 {
            return value.clone();
        }
        let weight = 1.0 / side as f64;
        let mean = |pixel: usize| {
            let rays = pixel * side..(pixel + 1) * side;
            rays.map(|ray| value.vector(ray)).sum::<DVec3>() * weight
        };
        Value::Vectors((0..self.values.rays / side).map(mean).collect())
    }
}

fn two(op: Op, a: &Value, b: &Value) -> Value {
    match op {
        Op::Add => a.zip(b, |a, b| a + b),
        Op::Sub => a.zip(b, |a, b| a - b),
        Op::Mul => a.zip(b, |a, b| a * b),
        Op::Div => a.zip(b, |a, b| a / b),
        Op::Max => a.zip(b, f64::max),
        Op::Min => a.zip(b, f64::min),
        Op::Less => a.zip(b, |a, b| f64::from(a < b)),
        Op::LessOrEqual => a.zip(b, |a, b| f64::from(a <= b)),
        Op::Pow => a.zip(b, power),
        _ => a.dot(b),
    }
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
