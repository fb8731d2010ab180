//! What a chapter asks its reader to predict, where the answer is a run: the program that
//! the reader has there, changed as the question says, shows what the answer says.

use super::built::book;
use ::book::text;
use glam::DVec3;
use step02_sphere::{Ray, Roots, SPHERE, Sphere};
use step03_nearest::{OBJECTS, Object};
use tests::camera;

/// Fails unless a question on the page begins with these words.
#[track_caller]
fn assert_asked(page: &str, question: &str) {
    let book = book();
    let asked = book.pages[page].all("details.predict > summary");
    let mut asked = asked.into_iter().map(|one| text(one).replace('\n', " "));
    assert!(
        asked.any(|words| words.contains(question)),
        "{page} does not ask {question:?}."
    );
}

/// The rays of the course's pictures.
fn rays() -> impl Iterator<Item = Ray> {
    let camera = camera();
    let pixels =
        (0..camera.v_res).flat_map(move |j| (0..camera.h_res).map(move |i| (i, j)));
    pixels.map(move |(i, j)| camera.ray(i.into(), j.into()))
}

#[test]
fn no_sphere_is_seen_along_directions_that_were_moved() {
    assert_asked(
        "step02_sphere.html",
        "you move the direction as you move the start",
    );
    let moved = |ray: Ray| Ray { direction: ray.direction - SPHERE.centre, ..ray };
    let mut moved = rays().map(moved);
    assert!(moved.all(|ray| SPHERE.intersect(&ray).first_hit().is_none()));
}

#[test]
fn all_is_red_from_within_the_sphere() {
    assert_asked("step02_sphere.html", "the centre of SPHERE at the eye");
    let around = Sphere { centre: DVec3::ZERO, ..SPHERE };
    assert!(rays().all(|ray| around.intersect(&ray).first_hit().is_some()));
}

#[test]
fn of_the_first_in_the_list_much_is_gone() {
    assert_asked("step03_nearest.html", "you keep the first hit");
    let (mut seen, mut shown) = ([0.0; 9], [0.0; 9]);
    for ray in rays() {
        let t = |k: usize| {
            OBJECTS[k].sphere.intersect(&ray).first_hit().map(|t| (t, k))
        };
        let hits: Vec<_> = (0..9).filter_map(t).collect();
        let Some(&(_, first)) = hits.first() else { continue };
        shown[first] += 1.0;
        let nearest = hits.iter().min_by(|a, b| a.0.total_cmp(&b.0));
        seen[nearest.map_or(first, |hit| hit.1)] += 1.0;
    }
    let left = |k: usize| shown[k] / seen[k];
    assert_eq!(left(2), 0.0, "golden");
    assert!(0.0 < left(6) && left(6) < 0.05, "{} of white is left", left(6));
    assert!(0.2 < left(5) && left(5) < 0.8, "{} of teal is left", left(5));
}

#[test]
fn the_ball_behind_you_is_seen_to_the_left_and_below() {
    assert_asked("step03_nearest.html", "The centre of the green sphere is above");
    let Object { sphere: green, .. } = OBJECTS[4];
    let lines = rays().filter(|ray| green.intersect(ray) != Roots::None);
    let middle: DVec3 = lines.map(|ray| ray.direction).sum();
    assert!(0.0 < green.centre.x && 0.0 < green.centre.y);
    assert!(middle.x < 0.0 && middle.y < 0.0);
}

#[test]
fn a_ball_around_the_scene_is_its_sky() {
    assert_asked("step03_nearest.html", "Add a ball with its centre at the eye");
    let objects = exercises::my_scene::objects();
    let sky = DVec3::new(0.1, 0.2, 0.3);
    let mut more = objects.clone();
    let sphere = Sphere { centre: DVec3::ZERO, radius: 100.0 };
    more.push(Object { sphere, material: sky });
    for ray in rays() {
        let hit = step03_nearest::nearest(&objects, &ray);
        let colour = hit.map_or(sky, |hit| hit.object.material);
        assert_eq!(step03_nearest::colour(&more, &ray), colour);
    }
}
