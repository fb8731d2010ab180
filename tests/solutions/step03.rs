//! Tests of the solutions for step 3.

use course::examples::many::{Tree, sunflower};
use std::cell::Cell;
use step03_nearest::nearest;
use support::primary_rays;

#[test]
fn tree_finds_the_same_hits_as_the_loop_with_few_intersections() {
    let (mut sorted_objects, intersections) = (sunflower(), Cell::new(0));
    let (tree, objects) = (Tree::new(&mut sorted_objects), sunflower());
    let (mut ray_count, mut hit_count) = (0, 0);
    for ray in primary_rays().step_by(17) {
        let hit = tree.nearest(&ray, f64::INFINITY, &|leaf| {
            intersections.set(intersections.get() + leaf.len());
            nearest(leaf, &ray)
        });
        assert_eq!(hit, nearest(&objects, &ray), "{ray:?}");
        ray_count += 1;
        hit_count += usize::from(hit.is_some());
    }
    assert!(hit_count > ray_count / 4);
    // The loop intersects 1000 spheres per ray. The limit for the tree is 1.5 spheres per ray. This
    // limit is tight: a search that begins with the farther half of a box would exceed the limit,
    // and so would a search that enters boxes behind the nearest hit.
    let count = intersections.get();
    assert!(2 * count < 3 * ray_count, "{count} spheres for {ray_count} rays");
}
