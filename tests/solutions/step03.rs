use course::examples::many::Tree;
use course::examples::*;
use proptest::{collection::vec, prelude::*};
use std::cell::Cell;
use step03_nearest::{OBJECTS, Object, Ray, nearest};
use tests::{primary_rays, random_point, random_sphere, random_sphere_and_ray, random_unit_vector};

#[test]
fn tree_finds_the_hits_of_the_loop_with_few_intersections() {
    let (mut sorted, intersections) = (many::sunflower(), Cell::new(0));
    let (tree, objects) = (Tree::new(&mut sorted), many::sunflower());
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
    assert!(ray_count / 4 < hit_count);
    // The loop intersects 1000 spheres for each ray. The limit is tight: a tree that goes
    // into the farther half first, or into boxes behind the nearest hit, fails.
    let count = intersections.get();
    assert!(2 * count < 3 * ray_count, "{count} spheres for {ray_count} rays");
}

proptest! {
    #[test]
    fn depth_does_not_depend_on_the_length_of_v(v in random_unit_vector(), k in -3..4, s in random_point()) {
        // A power of two scales every number of the formula exactly.
        let (objects, start) = (OBJECTS, s / 10.0);
        let ray = Ray { start, direction: v };
        let scaled_ray = Ray { start, direction: 2_f64.powi(k) * v };
        let d = depth::distance(&objects, &scaled_ray);
        prop_assert_eq!(d, depth::distance(&objects, &ray));
        let p = nearest(&objects, &scaled_ray).map(|hit| scaled_ray.at(hit.t));
        prop_assert_eq!(p.is_some(), d.is_some());
        if let (Some(p), Some(d)) = (p, d) {
            prop_assert!((p.distance(start) - d).abs() < 1e-9);
        }
    }

    #[test]
    fn tree_finds_the_hits_of_the_loop(
        (target, ray) in random_sphere_and_ray(), mut spheres in vec(random_sphere(), 0..30),
        has_duplicates in any::<bool>()
    ) {
        spheres.push(target);
        if has_duplicates {
            spheres.extend_from_within(..);
        }
        let objects = spheres.into_iter();
        let objects = objects.map(|sphere| Object { name: "ball", sphere, material: () });
        let mut objects: Vec<_> = objects.collect();
        let t = nearest(&objects, &ray).map(|hit| hit.t);
        let tree = Tree::new(&mut objects);
        let hit = tree.nearest(&ray, f64::INFINITY, &|leaf| nearest(leaf, &ray));
        prop_assert_eq!(hit.as_ref().map(|hit| hit.t), t);
        let sphere_t = hit.and_then(|hit| hit.object.sphere.intersect(&ray).first_hit());
        prop_assert_eq!(sphere_t, t);
    }
}
