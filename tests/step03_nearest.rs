//! Step 3: the nearest hit.

use glam::DVec3;
use proptest::{collection::vec, prelude::*};
use step03_nearest::{Object, Ray, Sphere, nearest};
use tests::{assert_program_works, random_sphere, random_sphere_and_ray};

const RAY_AHEAD: Ray = Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z };

/// The unit sphere around (0, 0, z).
fn sphere_at(z: f64) -> Sphere {
    Sphere { centre: DVec3::new(0.0, 0.0, z), radius: 1.0 }
}

/// t of the nearest hit, and the index of the sphere that is hit.
fn nearest_t_and_index(spheres: &[Sphere], ray: &Ray) -> Option<(f64, usize)> {
    let spheres = spheres.iter().copied().enumerate();
    let objects: Vec<_> =
        spheres.map(|(material, sphere)| Object { name: "ball", sphere, material }).collect();
    nearest(&objects, ray).map(|hit| (hit.t, hit.object.material))
}

#[test]
fn program_draws_the_locked_picture_and_rejects_invalid_arguments() {
    assert_program_works("step03_nearest");
}

#[test]
fn first_object_wins_at_equal_t() {
    assert_eq!(
        nearest_t_and_index(&[sphere_at(-5.0), sphere_at(-5.0)], &RAY_AHEAD),
        Some((4.0, 0))
    );
}

#[test]
fn spheres_behind_or_beside_the_ray_are_not_hit() {
    let sphere_beside = Sphere { centre: DVec3::new(3.0, 0.0, -2.0), radius: 1.0 };
    assert_eq!(
        nearest_t_and_index(&[sphere_at(2.0), sphere_beside, sphere_at(-9.0)], &RAY_AHEAD),
        Some((8.0, 2))
    );
    assert_eq!(nearest_t_and_index(&[sphere_at(2.0), sphere_beside], &RAY_AHEAD), None);
    assert_eq!(nearest_t_and_index(&[], &RAY_AHEAD), None);
}

proptest! {
    #[test]
    fn nearest_hit_has_the_smallest_t((target, ray) in random_sphere_and_ray(), mut spheres in vec(random_sphere(), 0..6)) {
        spheres.push(target);
        let hits: Vec<_> = spheres.iter().map(|sphere| sphere.intersect(&ray).first_hit()).collect();
        match nearest_t_and_index(&spheres, &ray) {
            Some((t, index)) => {
                prop_assert_eq!(hits[index], Some(t));
                prop_assert!(hits.iter().flatten().all(|&other_t| t <= other_t));
            }
            None => prop_assert!(hits.iter().all(Option::is_none)),
        }
    }
}
