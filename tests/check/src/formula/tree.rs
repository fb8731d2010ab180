use super::{Change, Kind, Node, Op, Value, parse};
use crate::{Named, Parts, Section, Step, camera, section};
use std::sync::Arc;
use std::sync::atomic::AtomicUsize;
use step03_nearest::Object;
use step05_phong::Light;

/// The formulas as text.
const LECTURE: &str = include_str!("lecture.txt");

/// All formulas of a step, and the numbers of its scene.
#[derive(Clone, Debug)]
pub(crate) struct Tree {
    pub step: Step,
    pub lines: Vec<Line>,
    /// The values that are given, in the places that the values of a ray have.
    pub given: Vec<Option<Value>>,
    /// The places of column and row of a ray, and of its own in the pixel.
    pub of_ray: [usize; 4],
    /// The places of an object's hit, and of the nearest object.
    pub hit: usize,
    pub nearest: usize,
    /// What is changed besides the lines and the numbers.
    pub always: Vec<Change>,
    /// The names of its objects.
    objects: Vec<&'static str>,
    /// What it has cost so far to evaluate the lines, of this tree and of those made from it.
    pub work: Arc<AtomicUsize>,
}

/// One formula, or one number of the scene or of a ray.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    pub name: Arc<str>,
    pub kind: Kind,
    pub of: Of,
    /// The formula; None for a number that is given.
    pub node: Option<Node>,
    /// The numbers of the scene, one for each object or light, or a single one.
    pub given: Vec<Value>,
    pub place: Place,
    /// Whether a pixel of this step needs it.
    pub is_needed: bool,
    /// The lines that it needs, a bit for each.
    pub uses: u128,
    /// Itself and all lines that need it, or need one that does.
    pub reaches: u128,
    /// Where its values are among those of a ray, and how many it has.
    pub start: usize,
    pub count: usize,
    /// Whether it has an argument.
    pub is_function: bool,
}

/// Of what there is one value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Of {
    /// Of each ray.
    Ray,
    /// Of each ray and each object.
    Object,
    /// Of each ray and its nearest object.
    Hit,
    /// Of each ray and each light.
    Light,
    /// Of each pixel.
    Pixel,
}

/// Where a formula belongs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    /// The stage.
    pub stage: &'static str,
    pub section: Section,
    /// The function of `tests/by_hand.rs`.
    pub test: &'static str,
}

/// The sections that headings name.
const SECTIONS: [(&str, Section); 25] = [
    ("PROGRAM", section::PROGRAM),
    ("CAMERA", section::CAMERA),
    ("BYTES", section::BYTES),
    ("DIRECTIONS", section::DIRECTIONS),
    ("SCENE", section::SCENE),
    ("CENTRE", section::CENTRE),
    ("MEETING", section::MEETING),
    ("FORMULA", section::FORMULA),
    ("ROOT", section::ROOT),
    ("NEAREST", section::NEAREST),
    ("MATERIALS", section::MATERIALS),
    ("RAY", section::RAY),
    ("NORMAL", section::NORMAL),
    ("AMBIENT", section::AMBIENT),
    ("DIFFUSE", section::DIFFUSE),
    ("LIGHT", section::LIGHT),
    ("ATTENUATION", section::ATTENUATION),
    ("REFLECT", section::REFLECT),
    ("SPECULAR", section::SPECULAR),
    ("RENDER", section::RENDER),
    ("SURFACE", section::SURFACE),
    ("LIGHTS", section::LIGHTS),
    ("LAMPS", section::LAMPS),
    ("SUM", section::SUM),
    ("EYE", section::EYE),
];

impl Tree {
    /// Those of a step, for a picture of this size, in degrees and in rays a pixel.
    pub fn new(step: Step, size: (u32, u32), fov: f64, samples: u32) -> Self {
        let mut tree = Self {
            step,
            lines: vec![],
            given: vec![],
            of_ray: [0; 4],
            hit: 0,
            nearest: 0,
            always: vec![],
            objects: vec![],
            work: Arc::default(),
        };
        tree.give(size, fov, samples);
        let mut heading = self::heading("ray | rays | CAMERA | ");
        for line in LECTURE.lines().filter(|line| !line.starts_with('#')) {
            if let Some(words) = line.strip_prefix('[') {
                heading = self::heading(words.trim_end_matches(']'));
            } else if let Some((name, text)) = line.split_once(" = ") {
                let (text, place) = own(step, name).unwrap_or((text, heading.1));
                tree.add(name, text, (heading.0, place));
            }
        }
        tree.thin();
        let place = |name: &str| tree.find(name).unwrap_or(0);
        (tree.hit, tree.nearest) = (place("t"), place("nearest"));
        tree.join();
        tree
    }

    /// The place of a line.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.lines.iter().position(|line| &*line.name == name)
    }

    /// The tree with these changes in it.
    pub fn with(&self, changes: &[Change]) -> Self {
        let mut tree = self.clone();
        for change in changes {
            match change {
                Change::Line(line, node) => {
                    tree.lines[*line].node = Some(node.clone())
                }
                Change::Given(line, which, value) => {
                    tree.lines[*line].given[*which] = value.clone();
                }
                other => tree.always.push(other.clone()),
            }
        }
        tree.join();
        tree
    }

    /// Notes which lines each line needs, and where its values are.
    fn join(&mut self) {
        self.given.clear();
        for k in 0..self.lines.len() {
            let uses = self.lines[k].node.as_ref().map_or(0, |n| self.uses(n));
            let count = match (&self.lines[k].node, self.lines[k].of) {
                (None, _) => self.lines[k].given.len(),
                (_, of @ (Of::Object | Of::Light)) => self.count(of),
                _ => 1,
            };
            let line = &mut self.lines[k];
            (line.uses, line.start, line.count) = (uses, self.given.len(), count);
            self.given.extend(line.given.iter().cloned().map(Some));
            self.given.resize(line.start + count, None);
        }
        for k in (0..self.lines.len()).rev() {
            let need = self.lines[k + 1..].iter().filter(|l| l.uses >> k & 1 != 0);
            let reaches = need.fold(1 << k, |all, line| all | line.reaches);
            self.lines[k].reaches = reaches;
        }
        self.of_ray = ["column", "row", "k_u", "k_v"]
            .map(|name| self.find(name).map_or(0, |k| self.lines[k].start));
    }

    /// How many objects there are, or lights.
    pub fn count(&self, of: Of) -> usize {
        if of == Of::Object { self.objects.len() } else { 2 }
    }

    /// The lines whose values an expression needs, a bit for each.
    pub fn uses(&self, node: &Node) -> u128 {
        match node {
            Node::Name(name) => 1 << name,
            Node::Of(op, nodes) => {
                let own = match op {
                    Op::Call(line) => 1 << line | self.lines[*line].uses,
                    Op::Chosen => 1 << self.nearest,
                    Op::Nearest => 1 << self.hit,
                    _ => 0,
                };
                nodes.iter().fold(own, |all, node| all | self.uses(node))
            }
            _ => 0,
        }
    }

    /// What an object is called.
    pub fn object(&self, k: usize) -> &'static str {
        self.objects[k]
    }

    fn add(&mut self, name: &str, text: &str, (of, place): (Of, Place)) {
        let known = |word: &str| match word {
            "x" => Some(Node::Argument),
            "none" => Some(Node::Number(f64::INFINITY)),
            "π" => Some(Node::Number(std::f64::consts::PI)),
            // The last one: several things of the scene have letters of the lecture.
            _ => self.lines.iter().rposition(|l| &*l.name == word).map(Node::Name),
        };
        let node = parse(text, &known);
        let node = node.unwrap_or_else(|what| panic!("{name} = {text}: {what}"));
        let kind = node.kind(&|name| self.lines[name].kind).unwrap_or(Kind::Scalar);
        let is_function = name.ends_with("(x)");
        let name = name.trim_end_matches("(x)").into();
        let node = Some(node);
        self.lines.push(Line {
            name,
            kind,
            of,
            node,
            given: vec![],
            place,
            is_needed: false,
            uses: 0,
            reaches: 0,
            start: 0,
            count: 0,
            is_function,
        });
    }

    /// Leaves out what no pixel of this step needs.
    fn thin(&mut self) {
        let last = self.lines.len() - 1;
        self.lines[last].is_needed = true;
        // Letters that may be taken for others, although nothing needs them yet.
        let others: &[&str] = match self.step {
            Step::Rays => &[],
            Step::Sphere => &["t'"],
            Step::Nearest => &["t'", "centre'", "radius'"],
            Step::Diffuse => &["t'", "v"],
            Step::Phong => &["t'", "v", "halfway"],
        };
        for line in self.lines.iter_mut().filter(|l| others.contains(&&*l.name)) {
            line.is_needed = true;
        }
        for k in (0..=last).rev() {
            let node =
                self.lines[k].node.clone().filter(|_| self.lines[k].is_needed);
            let Some(node) = node else { continue };
            for (name, line) in self.lines.iter_mut().enumerate().take(k) {
                let is_called = |n: &Node| matches!(n, Node::Of(Op::Call(line), _) if *line == name);
                line.is_needed |= node.has(name) || node.any(&is_called);
            }
        }
    }

    /// The numbers that are given: those of the options, of the ray, and of the scene.
    fn give(&mut self, (width, height): (u32, u32), fov: f64, samples: u32) {
        let camera = camera(width, height);
        let parts = Parts::right(&camera);
        let (objects, lights) = (parts.objects(self.step), &parts.scene.lights);
        let place = |stage, section| Place { stage, section, test: "" };
        let rays = place("rays", section::CAMERA);
        let middle = f64::from(samples - 1) / 2.0;
        for (name, number) in [
            ("fov", fov),
            ("hRes", width.into()),
            ("vRes", height.into()),
            ("samples", samples.into()),
            ("column", 0.0),
            ("row", 0.0),
            ("k_u", middle),
            ("k_v", middle),
        ] {
            self.put(name, Of::Ray, vec![number.into()], rays);
        }
        self.objects = objects.iter().map(|o| o.material.name).collect();
        let numbers = (0..objects.len()).map(|k| (k as f64).into()).collect();
        self.put("number", Of::Object, numbers, place("nearest", section::NEAREST));
        let scene = if self.step == Step::Sphere {
            section::ONE_COLOUR
        } else {
            section::SCENE
        };
        let (shape, colours) = (place("outlines", scene), place("colours", scene));
        for (k, name) in ["x_0", "y_0", "z_0"].into_iter().enumerate() {
            let all = objects.iter().map(|o| o.sphere.centre[k].into()).collect();
            self.put(name, Of::Object, all, shape);
        }
        let of = |value: &dyn Fn(&Object<Named>) -> Value| -> Vec<Value> {
            objects.iter().map(value).collect()
        };
        let materials = place("specular", section::MATERIALS);
        self.put("radius''", Of::Object, of(&|o| o.sphere.radius.into()), shape);
        let colour = of(&|o| o.material.material.surface.diffuse.into());
        self.put("colour", Of::Object, colour, colours);
        let g = of(&|o| o.material.material.specular.x.into());
        self.put("g", Of::Object, g, materials);
        let n = of(&|o| f64::from(o.material.material.shininess).into());
        self.put("n''", Of::Object, n, materials);
        let of = |value: &dyn Fn(&Light) -> Value| -> Vec<Value> {
            lights.iter().map(value).collect()
        };
        let lamps = |stage| place(stage, section::LAMPS);
        self.put(
            "P",
            Of::Light,
            of(&|l| l.point_light.position.into()),
            lamps("diffuse"),
        );
        self.put(
            "L_d",
            Of::Light,
            of(&|l| l.point_light.diffuse.into()),
            lamps("diffuse"),
        );
        self.put("L_s", Of::Light, of(&|l| l.specular.into()), materials);
        let fade = lamps("attenuation");
        self.put(
            "a'",
            Of::Light,
            of(&|l| l.point_light.attenuation.a.into()),
            fade,
        );
        self.put(
            "b'",
            Of::Light,
            of(&|l| l.point_light.attenuation.b.into()),
            fade,
        );
        self.put(
            "c'",
            Of::Light,
            of(&|l| l.point_light.attenuation.c.into()),
            fade,
        );
        let l_a = vec![parts.scene.ambient_light.into()];
        self.put("L_a", Of::Ray, l_a, lamps("ambient"));
    }

    fn put(&mut self, name: &str, of: Of, given: Vec<Value>, place: Place) {
        let is_vector = given.first().is_some_and(Value::is_vector);
        let kind = if is_vector { Kind::Vector } else { Kind::Scalar };
        let (name, node) = (name.into(), None);
        self.lines.push(Line {
            name,
            kind,
            of,
            node,
            given,
            place,
            is_needed: false,
            uses: 0,
            reaches: 0,
            start: 0,
            count: 0,
            is_function: false,
        });
    }
}

/// What stands for a formula of the last step in an earlier one.
fn own(step: Step, name: &str) -> Option<(&'static str, Place)> {
    let place = |stage, section| Place { stage, section, test: "" };
    match (step, name) {
        (Step::Rays, "I'") => Some(("sky", place("sky", section::DIRECTIONS))),
        (Step::Sphere, "I") => {
            Some(("colour'", place("colours", section::ONE_COLOUR)))
        }
        (Step::Nearest, "I") => Some(("colour'", place("colours", section::FLAT))),
        (Step::Diffuse, "I") => Some(("I_a + E_d", place("sum", section::LIGHTS))),
        _ => None,
    }
}

/// What a heading says.
fn heading(words: &'static str) -> (Of, Place) {
    let words: Vec<_> = words.split(" | ").collect();
    let of = match words[0] {
        "object" => Of::Object,
        "hit" => Of::Hit,
        "light" => Of::Light,
        "pixel" => Of::Pixel,
        _ => Of::Ray,
    };
    let known = SECTIONS.iter().find(|(name, _)| *name == words[2]);
    let (_, section) = known.unwrap_or_else(|| panic!("no section {}", words[2]));
    (of, Place { stage: words[1], section: *section, test: words[3] })
}
