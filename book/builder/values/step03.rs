//! The numbers of chapter 3.

use super::Value;
use super::measure::{both, camera, counted, number, pixels, tenths, vector};
use glam::DVec3;
use std::sync::LazyLock;
use step02_sphere::Roots;
use step03_nearest::{Hit, OBJECTS, Object, Ray, Sphere, nearest};

pub const VALUES: &[Value] = &[
    ("step03-tests", || counted(|_| SCENE.len())),
    ("step03-hits", || counted(|ray| hits(ray).count())),
    ("step03-wins", || counted(|ray| hits(ray).count().min(1))),
    ("step03-last", || counted(|ray| is_wrong(ray, hits(ray).last()))),
    ("step03-first", || counted(|ray| is_wrong(ray, hits(ray).next()))),
    ("step03-ties", || {
        counted(|ray| {
            let t = nearest(&SCENE, ray).map(|hit| hit.t);
            hits(ray).filter(|hit| Some(hit.t) == t).count().saturating_sub(1)
        })
    }),
    ("step03-behind", || {
        counted(|ray| (sphere(4).intersect(ray) != Roots::Zero).into())
    }),
    ("step03-red", || both(sphere(0), &crowded())),
    ("step03-ground", || both(sphere(1), &crowded())),
    ("step03-blue", || both(sphere(3), &crowded())),
    ("step03-green", || both(sphere(4), &crowded())),
    ("step03-meets", || {
        let met = |object: &&Object<_>| {
            object.sphere.intersect(&crowded()) != Roots::Zero
        };
        SCENE.iter().filter(met).count().to_string()
    }),
    ("step03-nearest", || {
        nearest(&SCENE, &crowded()).map_or("none".to_string(), |hit| number(hit.t))
    }),
    ("step03-check-centre", || {
        vector(
            (1..)
                .zip(OBJECTS)
                .map(|(k, o)| f64::from(k) * o.sphere.centre)
                .sum::<DVec3>(),
        )
    }),
    ("step03-check-radius", || {
        number(
            (1..).zip(OBJECTS).map(|(k, o)| f64::from(k) * o.sphere.radius).sum(),
        )
    }),
    ("step03-check-colour", || {
        vector(
            (1..)
                .zip(OBJECTS)
                .map(|(k, o)| f64::from(k) * o.material)
                .sum::<DVec3>(),
        )
    }),
    ("step03-gap", || {
        let gap = |s: &Sphere| {
            let apart = s.centre.distance(sphere(1).centre);
            (apart - sphere(1).radius - s.radius).abs()
        };
        let gaps = [0, 2, 3, 5, 6, 7].map(|index| gap(sphere(index)));
        number(gaps.into_iter().fold(0.0, f64::max))
    }),
    ("step03-edge-left", || ground_row(0.0)),
    ("step03-edge-middle", || ground_row(320.0)),
    ("step03-phi", || tenths(cone(6).0.to_degrees())),
    ("step03-alpha", || tenths(cone(6).1.to_degrees())),
    ("step03-inner", || in_pixels(cone(6).0.tan() - (cone(6).0 - cone(6).1).tan())),
    ("step03-outer", || in_pixels((cone(6).0 + cone(6).1).tan() - cone(6).0.tan())),
    ("step03-off", || {
        let (phi, alpha) = cone(6);
        let middle = ((phi - alpha).tan() + (phi + alpha).tan()) / 2.0;
        tenths(pixels(middle - phi.tan()))
    }),
    ("step03-long", || in_pixels(oval(6).0)),
    ("step03-wide", || in_pixels(oval(6).1)),
    ("step03-red-long", || in_pixels(oval(0).0)),
    ("step03-red-wide", || in_pixels(oval(0).1)),
    ("step03-eye", || format!("{:.2}", -0.5 / camera().matrix.z_axis.x)),
];

/// The objects of the scene, each of which says its place in the list.
static SCENE: LazyLock<Vec<Object<usize>>> = LazyLock::new(|| {
    let objects = OBJECTS.into_iter().enumerate();
    objects.map(|(place, object)| object.with_material(place)).collect()
});

fn sphere(place: usize) -> &'static Sphere {
    &SCENE[place].sphere
}

/// The first hit of `ray` with each object that it meets, in their order.
fn hits(ray: &Ray) -> impl Iterator<Item = Hit<'static, usize>> {
    SCENE.iter().filter_map(|object| {
        Some(Hit { t: object.sphere.intersect(ray).first_hit()?, object })
    })
}

/// 1 where `hit` is not with the nearest object, otherwise 0.
fn is_wrong(ray: &Ray, hit: Option<Hit<usize>>) -> usize {
    let place = |hit: Hit<usize>| hit.object.material;
    (hit.map(place) != nearest(&SCENE, ray).map(place)).into()
}

/// The ray through the pixel in column 195, row 237.
fn crowded() -> Ray {
    camera().ray(195.0, 237.0)
}

/// The first row in which a column of the picture would show the ground, were it
/// alone.
fn ground_row(column: f64) -> String {
    let shows = |&j: &u32| {
        let ray = camera().ray(column, j.into());
        sphere(1).intersect(&ray).first_hit().is_some()
    };
    (0..360).find(shows).map_or("none".to_string(), |j| j.to_string())
}

/// The angles of the cone of rays that touch a sphere of the scene: φ from −z to its
/// axis, and α from its axis to its side.
fn cone(place: usize) -> (f64, f64) {
    let Sphere { centre, radius } = sphere(place);
    (DVec3::NEG_Z.angle_between(*centre), (radius / centre.length()).asin())
}

/// How long and how wide the oval is in which that cone cuts the image plane.
fn oval(place: usize) -> (f64, f64) {
    let (phi, alpha) = cone(place);
    let long = (phi + alpha).tan() - (phi - alpha).tan();
    let root = (phi.cos().powi(2) - alpha.sin().powi(2)).sqrt();
    (long, 2.0 * alpha.sin() / root)
}

fn in_pixels(length: f64) -> String {
    format!("{:.2}", pixels(length))
}
