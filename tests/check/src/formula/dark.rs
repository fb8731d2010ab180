//! Two things of which one is of the ambient light: what no other light reaches tells it.

use super::explain::solutions;
use super::{
    Change, Context, Edit, Evidence, Node, Of, Op, Pixel, Riddle, Tree, Values,
    kept, spread,
};
use image::RgbImage;

impl Riddle<'_> {
    /// The edits and the numbers that explain what no light reaches in a picture, where
    /// that is another colour than ours. There an object has one colour all over, whatever
    /// becomes of the lights.
    pub fn of_dark(&self, tree: &Tree, edits: &[Edit]) -> Vec<Edit> {
        let black = Node::of(Op::Vector, [0.0; 3].map(Node::Number));
        let mut terms = vec![];
        for name in ["E_d", "E_s"] {
            if let Some(line) = tree.find(name)
                && tree.lines[line].is_needed
            {
                terms.push(Change::Line(line, black.clone()));
            }
        }
        if terms.is_empty() {
            return vec![];
        }
        let unlit = tree.with(&terms);
        let (dark, colours) = self.flat(tree);
        // Where one of ours is seen, it is that of another object.
        let places = spread(self.places, 400, 0);
        let ours = Values::at(&unlit, &places, 1);
        let ours = ours.changed(&Context::plain(&unlit)).pixels();
        let is_ours = colours.iter().any(|colour| ours.contains(colour));
        if is_ours || colours.len() < 2 {
            return vec![];
        }
        // Right sky stays right.
        let sky = self.sees_none(tree, &places);
        let sky = kept(&sky, &mut |place| self.is_right(place));
        let evidence = Evidence::new(&unlit, self.yours, 1, &dark, &sky);
        let is_its = |edit: &Edit| {
            ["ambient", "sum"].contains(&tree.lines[edit.line].place.stage)
        };
        let its = edits.iter().filter(|edit| is_its(edit)).collect();
        let mut all: Vec<_> =
            evidence.survivors(its).into_iter().cloned().collect();
        let mut numbers = solutions(&evidence, all.is_empty());
        numbers.retain(is_its);
        all.extend(numbers);
        all
    }

    /// Pixels in which objects are of one colour, that of most of its even pixels each; and
    /// these colours.
    fn flat(&self, tree: &Tree) -> (Vec<Pixel>, Vec<[u8; 3]>) {
        let flat = kept(self.places, &mut |place| is_flat(self.yours, place));
        let groups = self.groups(tree, &spread(&flat, 1000, 0));
        let colour = |&(i, j): &Pixel| self.yours.get_pixel(i, j).0;
        let (mut dark, mut colours) = (vec![], vec![]);
        for object in 1..=tree.count(Of::Object) {
            let mut its = vec![];
            for (key, some) in &groups {
                if key / 4 == object {
                    its.extend(some);
                }
            }
            let mut most = vec![];
            for one in &its {
                let same = kept(&its, &mut |other| colour(one) == colour(&other));
                if most.len() < same.len() {
                    most = same;
                }
            }
            // Few of one colour are a highlight, or another object.
            if its.len() < 2 * most.len() && 8 < most.len() {
                let its = colour(&most[0]);
                if !colours.contains(&its) {
                    colours.push(its);
                }
                dark.extend(most);
            }
        }
        (dark, colours)
    }
}

/// Whether the colours around a pixel are its own, and none of its bytes is at an end.
fn is_flat(yours: &RgbImage, (i, j): Pixel) -> bool {
    let one = yours.get_pixel(i, j);
    one.0.iter().all(|byte| !matches!(byte, 0 | 255))
        && [(0, 2), (2, 0), (4, 2), (2, 4)].into_iter().all(|(u, v)| {
            let at = |k: u32, by: u32| (k + by).checked_sub(2);
            let (Some(i), Some(j)) = (at(i, u), at(j, v)) else { return false };
            yours.get_pixel_checked(i, j) == Some(one)
        })
}
