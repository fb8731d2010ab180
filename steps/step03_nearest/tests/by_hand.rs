//! The numbers that chapter 3 works out or shows.

use glam::DVec3;
use step03_nearest::*;

fn camera() -> Camera {
    Camera::new(640, 360, 60_f64.to_radians())
}

fn through_the_crowd() -> Ray {
    camera().ray(195.0, 237.0)
}

#[track_caller]
fn near(found: impl Into<DVec3>, printed: [f64; 3]) {
    let found: DVec3 = found.into();
    assert!(found.abs_diff_eq(printed.into(), 5e-5), "{found} is not {printed:?}");
}

#[test]
fn objects_add_up() {
    let (mut centre, mut radius, mut colour) = (DVec3::ZERO, 0.0, DVec3::ZERO);
    for (k, Object { sphere, material, .. }) in (1..).map(f64::from).zip(OBJECTS) {
        centre += k * sphere.centre;
        radius += k * sphere.radius;
        colour += k * material;
    }
    near(centre, [-10.85, -71.43, -320.6]);
    near([radius; 3], [118.82; 3]);
    near(colour, [31.58, 34.31, 25.96]);
}

#[test]
fn hits_in_a_crowd() {
    let hit =
        |k: usize| OBJECTS[k].sphere.intersect(&through_the_crowd()).first_hit();
    near([0, 1, 3].map(|k| hit(k).unwrap()), [6.7898, 13.1862, 9.9202]);
    assert_eq!(hit(4), None);
}

#[test]
fn nearest_in_a_crowd() {
    let mut objects = OBJECTS;
    // The loop goes through a copy of the array. It only counts to nine.
    for _ in objects {
        objects.rotate_left(1);
        let hit = nearest(&objects, &through_the_crowd()).unwrap();
        near([hit.t; 3], [6.7898; 3]);
        assert_eq!(*hit.object, OBJECTS[0]);
    }
}

#[test]
fn nearest_of_three_fronts() {
    // The material is a number here, to tell the balls apart.
    let ball = |centre: f64, radius| Object {
        name: "ball",
        sphere: Sphere::new([0.0, 0.0, -centre], radius),
        material: centre,
    };
    let ahead = Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z };
    let mut balls = [ball(5.3, 1.0), ball(14.25, 10.0), ball(5.35, 1.0)];
    for _ in balls {
        balls.rotate_left(1);
        let hit = nearest(&balls, &ahead).unwrap();
        near([hit.t, hit.object.material, 0.0], [4.25, 14.25, 0.0]);
    }
}

#[test]
fn picture_of_a_crowd() {
    let picture = picture(&camera(), 1);
    assert_eq!(picture[(195, 237)].0, [232, 87, 71]);
    assert_eq!(picture[(197, 46)].0, [252, 222, 158]);
    assert_eq!(picture[(464, 238)].0, [204, 194, 209]);
    // Without the red sphere in front, the ray sees the blue one.
    near(colour(&OBJECTS[1..], &through_the_crowd()), [0.44, 0.47, 0.78]);
    let sky = camera().ray(0.0, 0.0);
    assert_eq!(colour(&OBJECTS, &sky), direction_colour(&sky));
}
