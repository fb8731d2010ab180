use super::{Node, Tree, Value};

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

impl Change {
    /// Whether another one is of something else.
    pub fn is_apart(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Line(k, _), Self::Line(l, _)) => k != l,
            (Self::Given(k, a, _), Self::Given(l, b, _)) => (k, a) != (l, b),
            (Self::Lamp(k, _), Self::Lamp(l, _)) => k != l,
            _ => true,
        }
    }
}

/// What is evaluated: the lines, with changes and with a value for the unknown.
pub(crate) struct Context<'a> {
    pub tree: &'a Tree,
    pub changes: &'a [Change],
    pub free: Value,
    /// The lines that the changes reach, a bit for each.
    stale: u128,
    /// Those of them that the change of one object's or light's number reaches for
    /// others, too.
    others: u128,
    /// That object or light.
    which: usize,
}

impl<'a> Context<'a> {
    /// The lines as they are.
    pub fn plain(tree: &'a Tree) -> Self {
        Self::new(tree, &[], 0.0.into())
    }

    pub fn new(tree: &'a Tree, changes: &'a [Change], free: Value) -> Self {
        let mut context =
            Self { tree, changes, free, stale: 0, others: 0, which: 0 };
        let one = match changes {
            [Change::Given(line, which, _)] => Some((tree.lines[*line].of, *which)),
            _ => None,
        };
        context.which = one.map_or(0, |(_, which)| which);
        let own = changes.iter().map(|change| match change {
            Change::Line(k, _) | Change::Lamp(k, _) | Change::Given(k, ..) => *k,
            Change::Objects(..) | Change::Without(_) => tree.nearest,
        });
        let reached = own.map(|line| tree.lines[line].reaches);
        context.stale = reached.fold(0, |all, line| all | line);
        let Some((of, _)) = one else {
            context.others = context.stale;
            return context;
        };
        for (k, line) in tree.lines.iter().enumerate() {
            let is_apart = line.of == of;
            let all = if is_apart { context.others } else { context.stale };
            context.others |= u128::from(line.uses & all != 0) << k;
        }
        context
    }

    /// Whether the changes reach a line, for an object or a light.
    pub fn is_stale(&self, line: usize, which: usize) -> bool {
        let stale = if which == self.which { self.stale } else { self.others };
        stale >> line & 1 != 0
    }

    /// What takes the place of a line's formula.
    pub fn other(&self, line: usize) -> Option<&'a Node> {
        self.changes.iter().find_map(|change| match change {
            Change::Line(k, node) if *k == line => Some(node),
            _ => None,
        })
    }

    /// The changes of this time, and those of the tree.
    fn all(&self) -> impl Iterator<Item = &'a Change> {
        self.changes.iter().chain(&self.tree.always)
    }

    /// The light of which a line takes the numbers.
    pub fn lamp(&self, line: usize) -> Option<usize> {
        self.all().find_map(|change| match change {
            Change::Lamp(k, lamp) if *k == line => Some(*lamp),
            _ => None,
        })
    }

    /// Whether an object is there.
    pub fn has(&self, object: usize) -> bool {
        self.all().all(|change| match change {
            Change::Objects(start, end) => (*start..*end).contains(&object),
            Change::Without(other) => object != *other,
            _ => true,
        })
    }
}
