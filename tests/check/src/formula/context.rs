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

/// What is evaluated: the lines, with changes and with a value for the unknown.
pub(crate) struct Context<'a> {
    pub tree: &'a Tree,
    pub changes: &'a [Change],
    pub free: Value,
    /// The lines that the changes reach, a bit for each.
    pub stale: u128,
}

impl<'a> Context<'a> {
    /// The lines as they are.
    pub fn plain(tree: &'a Tree) -> Self {
        Self::new(tree, &[], 0.0.into())
    }

    pub fn new(tree: &'a Tree, changes: &'a [Change], free: Value) -> Self {
        let mut context = Self { tree, changes, free, stale: 0 };
        for change in changes {
            context.stale |= 1
                << match change {
                    Change::Line(k, _)
                    | Change::Lamp(k, _)
                    | Change::Given(k, ..) => *k,
                    Change::Objects(..) | Change::Without(_) => tree.nearest,
                };
        }
        for (k, line) in tree.lines.iter().enumerate() {
            let uses = context.other(k).map_or(line.uses, |node| tree.uses(node));
            context.stale |= u128::from(uses & context.stale != 0) << k;
        }
        context
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
