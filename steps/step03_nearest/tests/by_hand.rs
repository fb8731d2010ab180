//! The numbers that chapter 3 works out by hand.

use std::f64::consts::FRAC_PI_3;
use step03_nearest::{Camera, OBJECTS, Ray, nearest};

fn through_the_crowd() -> Ray {
    Camera::new(640, 360, FRAC_PI_3).ray(195.0, 237.0)
}

#[test]
fn hits_in_a_crowd() {
    let [red, ground, _, blue, green, ..] = OBJECTS;
    for (object, printed) in [(red, 6.7898), (ground, 13.1862), (blue, 9.9202)] {
        let t = object.sphere.intersect(&through_the_crowd()).first_hit().unwrap();
        assert!((t - printed).abs() < 5e-5, "{t} is not {printed}");
    }
    let behind = green.sphere.intersect(&through_the_crowd());
    assert_eq!(behind.first_hit(), None);
}

#[test]
fn nearest_in_a_crowd() {
    let (objects, ray) = (OBJECTS, through_the_crowd());
    let hit = nearest(&objects, &ray).unwrap();
    assert!((hit.t - 6.7898).abs() < 5e-5, "{}", hit.t);
    assert_eq!(*hit.object, objects[0]);
}
