//! Step 3: the nearest hit, and the objects that steps 3 to 5 share.

use glam::DVec3;
use proptest::{collection::vec, prelude::*};
use step03_nearest::{OBJECTS, Object, Ray, Sphere, nearest};
use tests::{assert_program, camera, point, rays, sphere};

const AHEAD: Ray = Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z };

fn at(z: f64) -> Sphere {
    Sphere { centre: DVec3::new(0.0, 0.0, z), radius: 1.0 }
}

/// The spheres as objects whose material is their place in the list.
fn numbered(spheres: &[Sphere]) -> Vec<Object<usize>> {
    let numbered = spheres.iter().enumerate();
    numbered.map(|(material, &sphere)| Object { sphere, material }).collect()
}

/// t of the nearest hit, and the place of its sphere in the list.
fn found(spheres: &[Sphere], ray: &Ray) -> Option<(f64, usize)> {
    nearest(&numbered(spheres), ray).map(|hit| (hit.t, hit.object.material))
}

#[test]
fn the_program_draws_helps_and_refuses() {
    assert_program("step03_nearest");
}

#[test]
fn of_two_at_the_same_t_the_first_in_the_list_is_hit() {
    assert_eq!(found(&[at(-5.0), at(-5.0)], &AHEAD), Some((4.0, 0)));
}

#[test]
fn spheres_behind_and_missed_do_not_count() {
    let aside = Sphere { centre: DVec3::new(3.0, 0.0, -2.0), radius: 1.0 };
    assert_eq!(found(&[at(2.0), aside, at(-9.0)], &AHEAD), Some((8.0, 2)));
    assert_eq!(found(&[at(2.0), aside], &AHEAD), None);
    assert_eq!(found(&[], &AHEAD), None);
}

#[test]
fn the_scene_tests_what_it_should() {
    let spheres = OBJECTS.map(|object| object.sphere);
    let [red, ground, golden, blue, green, teal, white, salmon, cream] =
        [0, 1, 2, 3, 4, 5, 6, 7, 8];
    let numbered = numbered(&spheres);
    let seen = |i: u32, j: u32| {
        let ray = camera().ray(i.into(), j.into());
        nearest(&numbered, &ray).map(|hit| hit.object.material)
    };
    let pixels = (0..360).flat_map(|j| (0..640).map(move |i| (i, j)));
    let mut shown = [0; 9];
    let mut hides = [[false; 9]; 9];
    for (i, j) in pixels {
        let Some(front) = seen(i, j) else { continue };
        shown[front] += 1;
        for (back, sphere) in spheres.iter().enumerate() {
            let ray = camera().ray(i.into(), j.into());
            hides[front][back] |=
                back != front && sphere.intersect(&ray).first_hit().is_some();
        }
    }
    // The one behind the camera does not show; all others do.
    assert_eq!(shown[green], 0);
    for other in [red, ground, golden, blue, teal, white, salmon, cream] {
        assert!(0 < shown[other], "{other}");
    }
    // Some sphere hides a later one of the list, and some an earlier one.
    assert!(hides[red][blue] && hides[red][salmon] && hides[white][blue]);
    // One is cut off by the edge of the picture, and the ground fills the corners.
    assert!((0..360).any(|j| seen(639, j) == Some(teal)));
    assert_eq!([seen(0, 359), seen(639, 359)], [Some(ground); 2]);
}

proptest! {
    #[test]
    fn the_nearest_is_not_farther_than_any((target, ray) in rays(), mut list in vec(sphere(), 0..6)) {
        list.push(target);
        let hits: Vec<_> = list.iter().map(|sphere| sphere.intersect(&ray).first_hit()).collect();
        match found(&list, &ray) {
            Some((t, index)) => {
                prop_assert_eq!(hits[index], Some(t));
                prop_assert!(hits.iter().flatten().all(|&other| t <= other));
            }
            None => prop_assert!(hits.iter().all(Option::is_none)),
        }
    }

    #[test]
    fn the_order_of_the_list_does_not_matter((target, ray) in rays(), mut list in vec(sphere(), 0..6)) {
        list.push(target);
        let t = found(&list, &ray).map(|(t, _)| t);
        list.reverse();
        prop_assert_eq!(t, found(&list, &ray).map(|(t, _)| t));
    }

    #[test]
    fn moving_everything_by_one_offset_changes_nothing(
        (target, ray) in rays(), mut list in vec(sphere(), 0..6), by in point()
    ) {
        list.push(target);
        // At a tangent or from a surface, rounding decides what is hit.
        for Sphere { centre, radius } in &list {
            let apart = (*centre - ray.start).cross(ray.direction).length() / ray.direction.length();
            prop_assume!(1e-4 < (apart - radius).abs());
            prop_assume!(1e-4 < (centre.distance(ray.start) - radius).abs());
        }
        let moved: Vec<_> = list.iter().map(|s| Sphere { centre: s.centre + by, ..*s }).collect();
        let hit = found(&list, &ray);
        let again = found(&moved, &Ray { start: ray.start + by, ..ray });
        prop_assert_eq!(hit.is_some(), again.is_some());
        if let (Some((t, index)), Some((u, other))) = (hit, again) {
            prop_assert!((t - u).abs() < 1e-4 * (1.0 + t));
            // Two that are hit at nearly the same t may change places.
            let rival = list[other].intersect(&ray).first_hit();
            prop_assert!(index == other || rival.is_some_and(|r| (r - t).abs() < 1e-4 * (1.0 + t)));
        }
    }
}
