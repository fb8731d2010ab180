//! Step 3: the nearest hit, and the scene that steps 3 to 5 share.

use glam::DVec3;
use proptest::{collection::vec, prelude::*};
use step03_nearest::{Hit, Ray, SPHERES, Sphere, nearest, picture};
use tests::{
    Program, assert_locked, assert_refuses_bad_input, camera, point, rays, sphere,
};

const AHEAD: Ray = Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z };

fn at(z: f64) -> Sphere {
    Sphere { centre: DVec3::new(0.0, 0.0, z), radius: 1.0 }
}

#[test]
fn the_picture_is_locked() {
    assert_locked("step03_nearest", &picture(&camera(), 1));
}

#[test]
fn the_program_writes_the_locked_picture() {
    Program::new("step03_nearest", "writes").assert_writes_locked();
}

#[test]
fn the_program_helps() {
    Program::new("step03_nearest", "helps").assert_helps();
}

#[test]
fn the_program_refuses_bad_input() {
    assert_refuses_bad_input("step03_nearest");
}

#[test]
fn the_nearest_wins_wherever_it_stands_in_the_list() {
    let hit = |list: &[Sphere]| nearest(list, &AHEAD);
    assert_eq!(
        hit(&[at(-5.0), at(-9.0), at(-7.0)]),
        Some(Hit { t: 4.0, index: 0 })
    );
    assert_eq!(
        hit(&[at(-9.0), at(-5.0), at(-7.0)]),
        Some(Hit { t: 4.0, index: 1 })
    );
    assert_eq!(
        hit(&[at(-9.0), at(-7.0), at(-5.0)]),
        Some(Hit { t: 4.0, index: 2 })
    );
}

#[test]
fn of_two_at_the_same_t_the_first_in_the_list_is_hit() {
    assert_eq!(
        nearest(&[at(-5.0), at(-5.0)], &AHEAD),
        Some(Hit { t: 4.0, index: 0 })
    );
}

#[test]
fn spheres_behind_and_missed_do_not_count() {
    let aside = Sphere { centre: DVec3::new(3.0, 0.0, -2.0), radius: 1.0 };
    assert_eq!(
        nearest(&[at(2.0), aside, at(-9.0)], &AHEAD),
        Some(Hit { t: 8.0, index: 2 })
    );
    assert_eq!(nearest(&[at(2.0), aside], &AHEAD), None);
    assert_eq!(nearest(&[], &AHEAD), None);
}

/// Which sphere each pixel of the locked picture shows.
fn seen() -> Vec<Option<usize>> {
    let camera = camera();
    let pixels = (0..360).flat_map(|j| (0..640).map(move |i| (i, j)));
    pixels
        .map(|(i, j)| nearest(&SPHERES, &camera.ray(i.into(), j.into())))
        .map(|hit| Some(hit?.index))
        .collect()
}

#[test]
fn the_scene_tests_what_it_should() {
    let camera = camera();
    let seen = seen();
    let shows = |index| seen.contains(&Some(index));
    // One lies behind the camera and does not show; all others do.
    let behind: Vec<_> =
        (0..SPHERES.len()).filter(|&k| 0.0 < SPHERES[k].centre.z).collect();
    assert_eq!(behind.len(), 1);
    for index in 0..SPHERES.len() {
        assert_eq!(shows(index), !behind.contains(&index), "{index}");
    }
    // Some sphere hides a later one of the list, and some an earlier one.
    let mut hides = Vec::new();
    for (pixel, front) in seen.iter().enumerate() {
        let ray = camera.ray((pixel % 640) as f64, (pixel / 640) as f64);
        for back in (0..SPHERES.len()).filter(|&k| Some(k) != *front && k != 1) {
            if let (Some(front), Some(_)) =
                (front, SPHERES[back].intersect(&ray).first_hit())
            {
                hides.push((*front, back));
            }
        }
    }
    assert!(hides.iter().any(|(front, back)| front < back && *front != 1));
    assert!(hides.iter().any(|(front, back)| back < front && *front != 1));
    // One of them, besides the ground, is cut off by the edge of the picture.
    let edge = |pixel: usize| [0, 639].contains(&(pixel % 640));
    assert!(
        (0..seen.len()).any(|p| edge(p) && seen[p].is_some_and(|index| index != 1))
    );
    // The ground is the largest by far, and fills the lower corners.
    assert!(
        SPHERES
            .iter()
            .enumerate()
            .all(|(k, s)| k == 1 || s.radius < SPHERES[1].radius / 10.0)
    );
    assert_eq!(seen[359 * 640], Some(1));
}

proptest! {
    #[test]
    fn the_nearest_is_not_farther_than_any((target, ray) in rays(), mut list in vec(sphere(), 0..6)) {
        list.push(target);
        let hits: Vec<_> = list.iter().map(|sphere| sphere.intersect(&ray).first_hit()).collect();
        match nearest(&list, &ray) {
            Some(hit) => {
                prop_assert_eq!(hits[hit.index], Some(hit.t));
                prop_assert!(hits.iter().flatten().all(|&t| hit.t <= t));
            }
            None => prop_assert!(hits.iter().all(Option::is_none)),
        }
    }

    #[test]
    fn the_order_of_the_list_does_not_matter((target, ray) in rays(), mut list in vec(sphere(), 0..6)) {
        list.push(target);
        let t = nearest(&list, &ray).map(|hit| hit.t);
        list.reverse();
        prop_assert_eq!(t, nearest(&list, &ray).map(|hit| hit.t));
    }

    #[test]
    fn moving_everything_by_one_offset_changes_nothing(
        (target, ray) in rays(), mut list in vec(sphere(), 0..6), by in point()
    ) {
        list.push(target);
        let moved: Vec<_> = list.iter().map(|s| Sphere { centre: s.centre + by, ..*s }).collect();
        let hit = nearest(&list, &ray);
        let again = nearest(&moved, &Ray { start: ray.start + by, ..ray });
        if let (Some(hit), Some(again)) = (hit, again) {
            prop_assume!(hit.index == again.index);
            prop_assert!((hit.t - again.t).abs() < 1e-4 * (1.0 + hit.t));
        }
    }
}
