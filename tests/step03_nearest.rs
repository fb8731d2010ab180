//! Step 3: the nearest hit, and the objects that steps 3 to 5 share.

use glam::DVec3;
use proptest::{collection::vec, prelude::*};
use step03_nearest::{Object, Ray, Sphere, nearest};
use tests::{assert_program, rays, sphere};

const AHEAD: Ray = Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z };

fn at(z: f64) -> Sphere {
    Sphere { centre: DVec3::new(0.0, 0.0, z), radius: 1.0 }
}

/// The spheres as objects whose material is their place in the list.
fn numbered(spheres: &[Sphere]) -> Vec<Object<usize>> {
    let numbered = spheres.iter().enumerate();
    numbered
        .map(|(material, &sphere)| Object { name: "ball", sphere, material })
        .collect()
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
}
