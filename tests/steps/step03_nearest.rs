//! Step 3: the nearest hit.

use glam::DVec3;
use step03_nearest::{Object, Ray, Sphere, nearest};
use tests::test_law;

/// t of the nearest hit, and the index of the sphere that is hit.
fn nearest_t_and_index(spheres: &[Sphere], ray: &Ray) -> Option<(f64, usize)> {
    let spheres = spheres.iter().copied().enumerate();
    let objects: Vec<_> =
        spheres.map(|(material, sphere)| Object { name: "ball", sphere, material }).collect();
    nearest(&objects, ray).map(|hit| (hit.t, hit.object.material))
}

#[test]
fn first_object_wins_at_equal_t() {
    let sphere = Sphere { centre: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 };
    let ray = Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z };
    assert_eq!(nearest_t_and_index(&[sphere, sphere], &ray), Some((4.0, 0)));
}

#[test]
fn nearest_hit_has_the_smallest_t() {
    test_law(256, |random| {
        let (target, ray) = random.sphere_and_ray();
        let mut spheres: Vec<_> = (0..random.index(6)).map(|_| random.sphere()).collect();
        spheres.push(target);
        let hits: Vec<_> =
            spheres.iter().map(|sphere| sphere.intersect(&ray).first_hit()).collect();
        match nearest_t_and_index(&spheres, &ray) {
            Some((t, index)) => {
                assert_eq!(hits[index], Some(t));
                assert!(hits.iter().flatten().all(|&other_t| t <= other_t));
            }
            None => assert!(hits.iter().all(Option::is_none)),
        }
    });
}
