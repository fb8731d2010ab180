//! Tests of predictions. A chapter says what a program draws, often after a change. Each test
//! quotes the chapter, and checks that the quoted sentences are true.

use glam::DVec3;
use step02_sphere::{Ray, Roots};
use step03_nearest::{OBJECTS, Object, nearest};
use support::primary_rays;

/// "Red is the first in the list, so it loses every overlap; wherever two others overlap, the
/// nearer one happens to come later."
#[test]
fn last_hit_in_place_of_the_nearest_loses_red_pixels_only() {
    for ray in primary_rays() {
        let has_hit = |object: &&Object<_>| object.sphere.intersect(&ray).first_hit().is_some();
        let last_name = OBJECTS.iter().rfind(has_hit).map(|object| object.name);
        let nearest_name = nearest(&OBJECTS, &ray).map(|hit| hit.object.name);
        assert!(last_name == nearest_name || nearest_name == Some("red sphere"), "{ray:?}");
    }
}

/// "Suppose the loop compared how far away the *centres* are. Steps 3, 4 and 5 would come out
/// right. To the last pixel."
#[test]
fn nearer_centre_in_place_of_the_nearest_hit_changes_no_pixel() {
    let distance = |object: &&Object<_>| object.sphere.centre.length();
    for ray in primary_rays() {
        let has_hit = |object: &&Object<_>| object.sphere.intersect(&ray).first_hit().is_some();
        let hit_objects = OBJECTS.iter().filter(has_hit);
        let object = hit_objects.min_by(|a, b| distance(a).total_cmp(&distance(b)));
        assert_eq!(object, nearest(&OBJECTS, &ray).map(|hit| hit.object));
    }
}

/// "Every mirror except the ground shows it after a single bounce." Here, "it" is the green sphere
/// behind the eye.
#[test]
fn each_ball_that_mirrors_shows_the_green_sphere() {
    let objects = course::examples::mirror::mirrors().objects;
    let mut names: Vec<_> = primary_rays()
        .filter_map(|ray| {
            let point = step05_phong::visible_point(&objects, &ray)?;
            let name = point.hit.object.name;
            let direction = step05_phong::reflect(point.n, -ray.direction);
            let start = point.p + course::examples::mirror::OFFSET * point.n;
            let mirrored_hit = nearest(&objects, &Ray { start, direction })?;
            let is_mirror = point.material().k > 0.0 && name != "ground";
            (is_mirror && mirrored_hit.object.name == "green sphere").then_some(name)
        })
        .collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), 6, "{names:?}");
}

/// "The centre of the green sphere is above you and to the right. Why is its disc to the left and
/// below?"
#[test]
fn sphere_behind_the_eye_is_on_the_lines_of_the_lower_left_rays() {
    let Object { sphere: green, .. } = OBJECTS[4];
    let rays = primary_rays().filter(|ray| green.intersect(ray) != Roots::Zero);
    let direction_sum: DVec3 = rays.map(|ray| ray.direction).sum();
    assert!(green.centre.x > 0.0 && green.centre.y > 0.0);
    assert!(direction_sum.x < 0.0 && direction_sum.y < 0.0);
}
