//! Listed mistakes drawn with any scene: the Phong sum of step 5, in which one formula is
//! another.

use crate::drawing::Scene;
use glam::DVec3;
use step05_phong::{Hit, Ray, ambient, direction_colour, nearest, normal, reflect, specular};

/// The intensity that a ray gets of a scene, with the mistake of this title; with one that is
/// not here, the right intensity.
pub(crate) fn colour_with_mistake(title: &str, scene: &Scene, ray: &Ray) -> DVec3 {
    let Some(Hit { t, object }) = nearest(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let p = ray.at(t);
    let n = match (title, normal(&object.sphere, p)) {
        ("normals point into the spheres", n) => -n,
        ("n is not a unit vector", _) => p - object.sphere.centre,
        ("n is the direction of p, without the centre", _) => p.normalize(),
        (_, n) => n,
    };
    let is_made = |mistake: &str| title == mistake;
    let long_v = -ray.direction;
    let v = if is_made("v is −V and not a unit vector") { long_v } else { long_v.normalize() };
    let mut material = object.material;
    if is_made("the exponent n is left out") {
        material.shininess = 1;
    }
    let (mut diffuse_sum, mut specular_sum) = (DVec3::ZERO, DVec3::ZERO);
    for light in &scene.lights {
        let (l, d) = light.point_light.direction_from(p);
        let divisor = light.point_light.attenuation.divisor(d);
        let cosine = match (title, n.dot(l)) {
            ("n·l may be below 0", cosine) => cosine,
            ("|n·l| is taken for max(n·l, 0)", cosine) => cosine.abs(),
            (_, cosine) => cosine.max(0.0),
        };
        let fading = if is_made("light does not fade with distance") { 1.0 } else { divisor };
        diffuse_sum += material.matte.diffuse / fading * cosine * light.point_light.diffuse;
        if n.dot(l) <= 0.0 && !is_made("lights behind the surface give highlights") {
            continue;
        }
        let r = match title {
            "r points the wrong way" => -reflect(n, l),
            "r has lost its 2: (n·l)n − l" => n.dot(l) * n - l,
            "n is mirrored in l" => reflect(l, n),
            _ => reflect(n, l),
        };
        let term = specular(r, v, d, &material, light);
        let is_bright = is_made("the specular term is not divided by a + bd + cd²");
        specular_sum += if is_bright { term * divisor } else { term };
    }
    ambient(&material.matte, scene.ambient_light) + diffuse_sum + specular_sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use course::{Mistake, camera, find_mistakes_with_hash, hash_picture, mistakes};
    use step05_phong::{colour, render};

    #[test]
    fn titles_draw_the_pictures_of_their_mistakes() {
        let scene = step05_phong::scene();
        // In this row of the picture, each of them shows.
        let rays = (0..640).step_by(5).map(|i| camera().ray(i.into(), 168.0));
        let right: Vec<_> = rays.map(|ray| (ray, colour(&scene, &ray))).collect();
        let is_drawn = |mistake: &Mistake| {
            let wrong = |ray| colour_with_mistake(mistake.title, &scene, ray);
            right.iter().any(|(ray, colour)| 0.01 < wrong(ray).distance(*colour))
        };
        let drawn: Vec<_> = mistakes().into_iter().filter(is_drawn).collect();
        assert_eq!(drawn.len(), 13);
        for mistake in drawn {
            let wrong = |ray: &Ray| colour_with_mistake(mistake.title, &scene, ray);
            let same = find_mistakes_with_hash(hash_picture(&render(&camera(), 1, wrong)));
            assert!(same.iter().any(|(one, _)| *one == mistake), "{}", mistake.title);
        }
    }
}
