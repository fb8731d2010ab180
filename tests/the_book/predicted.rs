//! What a chapter asks its reader to predict, where the answer is a run: the program that
//! the reader has there, changed as the question says, shows what the answer says.

use glam::DVec3;
use step02_sphere::{Ray, Roots, SPHERE, Sphere};
use step03_nearest::{OBJECTS, Object, colour, nearest};
use tests::rays_of_camera;

/// "In `sphere.rs`, you move the direction as you move the start."
#[test]
fn no_sphere_is_seen_along_directions_that_were_moved() {
    let moved = |ray: Ray| Ray { direction: ray.direction - SPHERE.centre, ..ray };
    let mut moved = rays_of_camera().map(moved);
    assert!(moved.all(|ray| SPHERE.intersect(&ray).first_hit().is_none()));
}

/// "You put the centre of `SPHERE` at the eye."
#[test]
fn all_is_red_from_within_the_sphere() {
    let around = Sphere { centre: DVec3::ZERO, ..SPHERE };
    assert!(
        rays_of_camera().all(|ray| around.intersect(&ray).first_hit().is_some())
    );
}

/// "In `nearest`, you keep the first hit that the loop finds."
#[test]
fn of_the_first_in_the_list_much_is_gone() {
    let (mut seen, mut shown) = ([0.0; 9], [0.0; 9]);
    for ray in rays_of_camera() {
        let t = |k: &usize| OBJECTS[*k].sphere.intersect(&ray).first_hit();
        let Some(first) = (0..9).find(|k| t(k).is_some()) else { continue };
        let hit = nearest(&OBJECTS, &ray).map(|hit| hit.t);
        let front = (0..9).find(|k| t(k) == hit).expect("it is the nearest");
        shown[first] += 1.0;
        seen[front] += 1.0;
    }
    let [golden, teal, white] = [2, 5, 6].map(|k| shown[k] / seen[k]);
    assert_eq!(golden, 0.0);
    assert!(0.0 < white && white < 0.05, "{white} of white is left");
    assert!(0.2 < teal && teal < 0.8, "{teal} of teal is left");
}

/// "The centre of the green sphere is above you and to the right."
#[test]
fn the_ball_behind_you_is_seen_to_the_left_and_below() {
    let Object { sphere: green, .. } = OBJECTS[4];
    let lines = rays_of_camera().filter(|ray| green.intersect(ray) != Roots::Zero);
    let middle: DVec3 = lines.map(|ray| ray.direction).sum();
    assert!(0.0 < green.centre.x && 0.0 < green.centre.y);
    assert!(middle.x < 0.0 && middle.y < 0.0);
}

/// "Add a ball with its centre at the eye and a radius of 100."
#[test]
fn a_ball_around_the_scene_is_its_sky() {
    let (objects, material) = (exercises::my_scene::objects(), DVec3::splat(0.2));
    let sphere = Sphere { centre: DVec3::ZERO, radius: 100.0 };
    let more =
        [&objects[..], &[Object { name: "ball", sphere, material }]].concat();
    for ray in rays_of_camera() {
        let hit = nearest(&objects, &ray);
        let seen = hit.map_or(material, |hit| hit.object.material);
        assert_eq!(colour(&more, &ray), seen);
    }
}
