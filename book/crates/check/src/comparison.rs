//! Compares a picture with ours pixel by pixel. Also contains the budget, which limits how many
//! rays the search for an explanation may compute, and how many pixels it may compare.

use crate::step_scene::ObjectHit;
use crate::target::Target;
use course::{camera_with_size, largest_channel_difference};
use image::{Rgb, RgbImage};
use std::cell::Cell;
use step01_rays::Ray;

/// A reader's picture and ours, pixel by pixel. Both pictures have the same size.
pub(crate) struct Comparison<'a> {
    pub target: &'a Target,
    /// The pixels that differ, of which there is at least one. They are in a scattered order, so
    /// that even the first few come from all over the picture.
    pub wrong: Vec<Pixel>,
    pub right: Vec<Pixel>,
    /// The wrong pixel with the largest difference.
    pub most_different: Pixel,
}

/// One pixel in both pictures.
#[derive(Clone, Copy)]
pub(crate) struct Pixel {
    /// The column and the row.
    pub position: (u32, u32),
    /// The ray that our camera sends through the pixel.
    pub ray: Ray,
    /// The hit that this pixel shows in our picture. None if the pixel shows the sky, or if we have
    /// no scene for the picture.
    pub hit: Option<ObjectHit>,
    pub yours: [u8; 3],
    pub ours: [u8; 3],
}

impl Pixel {
    /// The difference in the channel that differs most.
    pub fn largest_difference(&self) -> u8 {
        largest_channel_difference(&Rgb(self.yours), &Rgb(self.ours))
    }
}

impl<'a> Comparison<'a> {
    /// Compares a picture with a target. Returns None if the sizes differ, or if the pictures are
    /// equal.
    pub fn new(target: &'a Target, yours: &RgbImage) -> Option<Self> {
        let Target { scene, picture: ours, .. } = target;
        let (columns, rows) = ours.dimensions();
        if yours.dimensions() != (columns, rows) {
            return None;
        }
        let camera = camera_with_size(columns, rows);
        let pixel = |(i, j): (u32, u32)| {
            let ray = camera.ray(i.into(), j.into());
            let hit = scene.as_ref().and_then(|scene| scene.visible_hit(&ray));
            let [yours, ours] = [yours, ours].map(|picture| picture.get_pixel(i, j).0);
            Pixel { position: (i, j), ray, hit, yours, ours }
        };
        let pixels = scattered_positions((columns, rows)).map(pixel);
        let (right, wrong): (Vec<_>, Vec<_>) = pixels.partition(|pixel| pixel.yours == pixel.ours);
        let most_different = *wrong.iter().max_by_key(|pixel| pixel.largest_difference())?;
        Some(Self { target, wrong, right, most_different })
    }

    /// All pixels. The wrong pixels come first, because they soon rule out most causes that don't
    /// explain the picture.
    pub fn pixels(&self) -> impl Iterator<Item = &Pixel> {
        self.wrong.iter().chain(&self.right)
    }
}

/// Returns the column and row of every pixel, in an order that soon reaches each part of the
/// picture.
pub(crate) fn scattered_positions(size: (u32, u32)) -> impl Iterator<Item = (u32, u32)> {
    let (columns, count) = (u64::from(size.0), u64::from(size.0) * u64::from(size.1));
    // 7919 is prime, so this stride visits every position unless 7919 divides the count.
    let stride = if count.is_multiple_of(7919) { 1 } else { 7919 };
    let index = move |n: u64| n * stride % count;
    (0..count).map(move |n| ((index(n) % columns) as u32, (index(n) / columns) as u32))
}

/// The number of rays that may still be computed, or of pixels that may still be compared. A budget
/// limits the running time. Unlike a time limit, a budget leads to the same result on every
/// machine.
pub(crate) struct Budget(Cell<u32>);

impl Budget {
    pub fn new(count: u32) -> Self {
        Self(Cell::new(count))
    }

    pub fn is_spent(&self) -> bool {
        self.0.get() == 0
    }

    /// Subtracts a cost from the budget. If the cost exceeds the budget, spends what is left and
    /// returns false.
    pub fn spend(&self, cost: u32) -> bool {
        let remaining_budget = self.0.get().checked_sub(cost);
        self.0.set(remaining_budget.unwrap_or(0));
        remaining_budget.is_some()
    }

    /// Returns whether `condition` holds for every item. Testing an item costs `cost`. If the
    /// budget runs out, the result is false.
    ///
    /// The first item for which `condition` doesn't hold moves to the front. That item will
    /// probably fail the caller's next condition as well, and then no other item has to be tested.
    pub fn holds_for_all<T>(
        &self,
        items: &mut [T],
        cost: u32,
        condition: impl Fn(&T) -> bool,
    ) -> bool {
        let refuting = items.iter().position(|item| !self.spend(cost) || !condition(item));
        if let Some(k) = refuting {
            items[..=k].rotate_right(1);
        }
        refuting.is_none()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn budget_is_spent_when_the_costs_use_it_up() {
        let budget = Budget::new(5);
        assert!(!budget.is_spent());
        assert!(budget.spend(3) && !budget.is_spent());
        assert!(budget.spend(2) && budget.is_spent());
        assert!(!budget.spend(1));
        // A cost that exceeds the budget spends the whole budget.
        let budget = Budget::new(5);
        assert!(!budget.spend(6) && budget.is_spent());
    }

    #[test]
    fn holds_for_all_moves_an_item_that_fails_the_condition_to_the_front() {
        let mut items = [1, 2, 3, 4];
        let budget = Budget::new(100);
        assert!(!budget.holds_for_all(&mut items, 10, |item| *item != 3));
        assert_eq!(items, [3, 1, 2, 4]);
        assert!(!budget.holds_for_all(&mut items, 10, |item| *item != 3));
        assert_eq!(items, [3, 1, 2, 4]);
        // The first call tested three items, and the second call tested one. Each test cost 10, so
        // a budget of 60 is left.
        assert!(budget.holds_for_all(&mut items, 15, |item| *item < 5));
        assert!(budget.is_spent());
    }

    #[test]
    fn holds_for_all_is_false_if_the_budget_runs_out() {
        let mut items = [1, 2, 3, 4];
        assert!(Budget::new(4).holds_for_all(&mut items, 1, |_| true));
        assert!(!Budget::new(3).holds_for_all(&mut items, 1, |_| true));
        assert!(!Budget::new(0).holds_for_all(&mut items, 1, |_| true));
    }

    #[test]
    fn scattered_positions_visit_each_position_once() {
        for (columns, rows) in [(640, 360), (64, 36), (7919, 2), (1, 1)] {
            let positions: Vec<_> = scattered_positions((columns, rows)).collect();
            let different: BTreeSet<_> = positions.iter().collect();
            assert_eq!(positions.len(), (columns * rows) as usize);
            assert_eq!(different.len(), positions.len());
            assert!(positions.iter().all(|(i, j)| *i < columns && *j < rows));
        }
        // The first hundred positions reach every cell of a 3×3 grid.
        let first_positions = scattered_positions((640, 360)).take(100);
        let ninths: BTreeSet<_> = first_positions.map(|(i, j)| (i / 214, j / 120)).collect();
        assert_eq!(ninths.len(), 9);
    }

    #[test]
    fn pixels_are_right_or_wrong_and_the_most_different_one_is_found() {
        let ours = RgbImage::from_pixel(4, 3, Rgb([9, 9, 9]));
        let target = Target::of_locked("rings", ours.clone());
        assert!(Comparison::new(&target, &ours).is_none());
        assert!(Comparison::new(&target, &RgbImage::new(3, 4)).is_none());
        let mut yours = ours;
        yours[(1, 2)] = Rgb([9, 8, 9]);
        yours[(3, 0)] = Rgb([9, 9, 19]);
        let comparison = Comparison::new(&target, &yours).expect("the pictures differ");
        assert_eq!((comparison.wrong.len(), comparison.right.len()), (2, 10));
        assert_eq!(comparison.most_different.position, (3, 0));
        assert_eq!(comparison.most_different.largest_difference(), 10);
        let first_two = comparison.pixels().take(2);
        assert!(first_two.into_iter().all(|pixel| pixel.yours != pixel.ours));
        assert_eq!(comparison.pixels().count(), 12);
    }
}
