use exercises::many::Tree;
use exercises::*;
use glam::DVec3;
use proptest::{collection::vec, prelude::*};
use std::cell::Cell;
use step03_nearest::{Camera, OBJECTS, Object, Ray, Sphere, nearest};
use tests::{camera, point, rays, rays_of_camera, sphere, unit};

#[test]
fn up_to_4_samples_jitter_draws_the_same_picture() {
    let camera = Camera::new(160, 90, 60_f64.to_radians());
    let four = jitter::picture(&camera, 4);
    assert!(jitter::picture(&camera, 1) == four);
    assert!(jitter::picture(&camera, 5) != four);
}

#[test]
fn each_random_ray_stays_in_its_sub_pixel() {
    let (camera, side) = (camera(), 4);
    let inverse = camera.matrix.inverse();
    for (x, y) in (0..400).flat_map(|y| (0..400).map(move |x| (x, y))) {
        let centre = |k: i32| (f64::from(k) + 0.5) / f64::from(side) - 0.5;
        let place = DVec3::new(centre(x), centre(y), 1.0);
        let ray = jitter::jittered(&camera, side, place.x, place.y);
        let off = (inverse * ray.direction - place) * f64::from(side);
        assert!(off.abs().max_element() < 0.5 + 1e-9, "{x}, {y}: {off}");
    }
}

#[test]
fn the_tree_finds_what_the_loop_finds_and_asks_far_fewer() {
    let (mut sorted, asked) = (many::sunflower(), Cell::new(0));
    let (tree, objects) = (Tree::new(&mut sorted), many::sunflower());
    let (mut rays, mut hits) = (0, 0);
    for ray in rays_of_camera().step_by(17) {
        let found = tree.nearest(&ray, f64::INFINITY, &|few| {
            asked.set(asked.get() + few.len());
            nearest(few, &ray)
        });
        assert_eq!(found, nearest(&objects, &ray), "{ray:?}");
        rays += 1;
        hits += usize::from(found.is_some());
    }
    assert!(rays / 4 < hits);
    // The loop asks 1000 a ray. The limit is tight, so that a tree fails that goes
    // into the farther half first, or into boxes behind the nearest hit.
    let asked = asked.get();
    assert!(2 * asked < 3 * rays, "{asked} spheres for {rays} rays");
}

/// Fails unless a tree of `spheres` finds the t that the loop finds, and at that t one
/// of the spheres.
#[track_caller]
fn assert_found(spheres: impl IntoIterator<Item = Sphere>, ray: &Ray) {
    let objects = spheres.into_iter().map(|sphere| Object {
        name: "ball",
        sphere,
        material: (),
    });
    let mut objects: Vec<_> = objects.collect();
    let t = nearest(&objects, ray).map(|hit| hit.t);
    let tree = Tree::new(&mut objects);
    let found = tree.nearest(ray, f64::INFINITY, &|few| nearest(few, ray));
    assert_eq!(found.as_ref().map(|hit| hit.t), t, "{ray:?}");
    let own = found.and_then(|hit| hit.object.sphere.intersect(ray).first_hit());
    assert_eq!(own, t, "{ray:?}");
}

#[test]
fn rays_along_the_axes_and_tangents_are_found_too() {
    assert_found([], &Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z });
    let centre = |x: i32| DVec3::new((2 * x).into(), 0.0, -5.0);
    let row = (-8..8).map(|x| Sphere { centre: centre(x), radius: 1.0 });
    for x in -20..20 {
        let start = DVec3::new(f64::from(x) / 2.0, 0.0, 0.0);
        for direction in [DVec3::NEG_Z, DVec3::Z, DVec3::X, -DVec3::X] {
            for back in [0.0, 4.0, 5.0] {
                let start = start - back * DVec3::Z;
                assert_found(row.clone(), &Ray { start, direction });
            }
        }
    }
}

proptest! {
    #[test]
    fn depth_does_not_depend_on_the_length_of_v(v in unit(), k in -3..4, s in point()) {
        // Times a power of two, every number of the formula is exact.
        let (objects, start) = (OBJECTS, s / 10.0);
        let ray = Ray { start, direction: v };
        let longer = Ray { start, direction: 2_f64.powi(k) * v };
        let d = depth::distance(&objects, &longer);
        prop_assert_eq!(d, depth::distance(&objects, &ray));
        let p = nearest(&objects, &longer).map(|hit| longer.at(hit.t));
        prop_assert_eq!(p.is_some(), d.is_some());
        if let (Some(p), Some(d)) = (p, d) {
            prop_assert!((p.distance(start) - d).abs() < 1e-9);
        }
    }

    #[test]
    fn the_tree_finds_what_the_loop_finds(
        (target, ray) in rays(), mut list in vec(sphere(), 0..30), twice in any::<bool>()
    ) {
        list.push(target);
        if twice {
            // Each at the same t as another.
            list.extend_from_within(..);
        }
        assert_found(list, &ray);
    }
}
