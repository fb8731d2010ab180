//! Answers about pictures that are ours with one change: a listed mistake, a number of the
//! scene, a missing part, another camera; and about the scenes of names.

use crate::{Answers, Titled, draw, draw_changed_scene, draw_step, locked};
use check::{Answer, check_scene_png};
use course::{Step, camera, camera_with_size};
use glam::DVec3;
use image::codecs::png::PngEncoder;
use image::{Rgb, RgbImage};
use step01_rays::{Camera, render};
use step02_sphere::Sphere;
use step05_phong::{Light, Material, Scene, terms};

#[test]
fn changed_scenes_are_as_locked() {
    type Change = fn(&mut Scene<Material, Light>);
    let changes: Titled<Change, 13> = [
        ("golden lower", |scene| scene.objects[2].sphere.centre.y = -1.27),
        ("red's n is 41", |scene| scene.objects[0].material.shininess = 41),
        ("L_a has another green", |scene| scene.ambient_light.y = 0.23),
        ("another b of the warm light", |scene| scene.lights[0].point_light.attenuation.b = 0.025),
        ("a number between hundredths", |scene| scene.objects[2].sphere.radius = 0.4254321),
        ("without the cool light", |scene| scene.lights.truncate(1)),
        ("without ambient light", |scene| scene.ambient_light *= 0.0),
        ("ambient light twice", |scene| scene.ambient_light *= 2.0),
        ("without the white sphere", |scene| drop(scene.objects.drain(6..7))),
        ("the first 3 objects", |scene| scene.objects.truncate(3)),
        ("the first 4 objects, the fifth can't be seen", |scene| scene.objects.truncate(4)),
        ("the warm light gives no highlights", |scene| scene.lights[0].specular = DVec3::ZERO),
        ("two other numbers", |scene| {
            scene.lights[0].point_light.position *= 1.07;
            scene.objects[4].sphere.radius *= 1.01;
        }),
    ];
    let mut answers = Answers::new();
    for (title, change) in changes {
        answers.add_picture(title, "step05_phong", draw_changed_scene(change));
    }
    for (title, z, radius) in [
        ("nearer", -4.95, 1.0),
        ("larger", -5.0, 1.2),
        ("far larger and farther", -10.0, 2.0),
        ("nearer and larger", -4.5, 1.31),
    ] {
        let sphere = Sphere { centre: DVec3::new(0.0, 0.0, z), radius };
        let picture = draw(|ray| step02_sphere::colour(&sphere, ray));
        answers.add_picture(&format!("the ball of step 2 {title}"), "step02_sphere", picture);
    }
    answers.assert_locked("changed_scenes");
}

#[test]
fn other_cameras_are_as_locked() {
    let cameras: Titled<fn(&mut Camera), 6> = [
        ("wider", |camera| {
            camera.matrix.x_axis *= 1.1;
            camera.matrix.z_axis.x *= 1.1;
        }),
        ("slanted", |camera| camera.matrix.y_axis.x = 0.0004),
        ("higher", |camera| camera.matrix.y_axis.y *= 1.07),
        ("a third of a pixel aside", |camera| {
            camera.matrix.z_axis += camera.matrix.x_axis / 3.0;
        }),
        ("half a pixel up and left", |camera| {
            camera.matrix.z_axis -= 0.5 * (camera.matrix.x_axis + camera.matrix.y_axis);
        }),
        ("moved", |camera| camera.centre.x = 0.1),
    ];
    let mut answers = Answers::new();
    for (title, change) in cameras {
        let mut camera = camera();
        change(&mut camera);
        for step in [Step::Rays, Step::Nearest] {
            let title = format!("{title}, step {}", step.number());
            answers.add_picture(&title, step.name(), (step.picture())(&camera, 1));
        }
    }
    answers.assert_locked("other_cameras");
}

#[test]
fn listed_mistakes_are_as_locked() {
    let mut answers = Answers::new();
    let picture = || draw(|ray| ray.direction * DVec3::new(1.0, 1.0, -1.0));
    answers.add_picture("the sky without 0.7 + 0.3", "step01_rays", picture());
    answers.add_picture("the same for step 4", "step04_diffuse", picture());
    answers.add_picture("no sphere is hit", "step02_sphere", draw_step(Step::Rays));
    let scene = step05_phong::scene();
    let without_gate = draw(|ray| match terms(&scene, ray) {
        None => step01_rays::direction_colour(ray),
        Some(_) => colour_without_gate(&scene, ray),
    });
    answers.add_picture("the gate is missing", "step05_phong", without_gate);
    answers.add_picture("black", "step05_phong", RgbImage::new(640, 360));
    answers.assert_locked("listed_mistakes");
}

/// The Phong sum in which lights behind a surface give highlights.
fn colour_without_gate(scene: &Scene<Material, Light>, ray: &step01_rays::Ray) -> DVec3 {
    let Some(point) = step05_phong::visible_point(&scene.objects, ray) else {
        return step01_rays::direction_colour(ray);
    };
    let terms = step05_phong::phong(&point, ray, scene.ambient_light, &scene.lights);
    let v = -ray.direction.normalize();
    let highlights = scene.lights.iter().map(|light| {
        let (l, d) = light.point_light.direction_from(point.p);
        step05_phong::specular(step05_phong::reflect(point.n, l), v, d, point.material, light)
    });
    terms.ambient + terms.diffuse + highlights.sum::<DVec3>()
}

#[test]
fn scenes_of_names_are_as_locked() {
    let ada = course::named_scene("ada");
    let mut answers = Answers::new();
    let mut add = |title: &str, name: &str, picture: RgbImage| {
        let mut png = vec![];
        picture.write_with_encoder(PngEncoder::new(&mut png)).expect("a picture");
        let others = ["ada", "bob", "cleo"].map(str::to_owned);
        let answer = check_scene_png(&png, "scene_of_me.png", name, &others, &locked());
        let Answer { verdict, text, cause, .. } = answer;
        answers.add(title, &format!("[{}]\n{text}\n{cause:?}", verdict.words()));
    };
    let right = || draw(|ray| step05_phong::colour(&ada, ray));
    add("right", "ada", right());
    add("of ada, with a capital letter", "Ada", right());
    add("of another name", "bob", right());
    let camera = camera_with_size(320, 180);
    add("small", "ada", render(&camera, 1, |ray| step05_phong::colour(&ada, ray)));
    add(
        "4 rays per pixel",
        "ada",
        render(&course::camera(), 2, |ray| step05_phong::colour(&ada, ray)),
    );
    add("the gate is missing", "ada", draw(|ray| colour_without_gate(&ada, ray)));
    let changed = |change: &dyn Fn(&mut Scene<Material, Light>)| {
        let mut scene = ada.clone();
        change(&mut scene);
        draw(|ray| step05_phong::colour(&scene, ray))
    };
    add("one number", "ada", changed(&|scene| scene.objects[3].sphere.radius = 1.0));
    add("without the second light", "ada", changed(&|scene| scene.lights.truncate(1)));
    let darken = |light: &mut Light| light.specular = DVec3::ZERO;
    add("without highlights", "ada", changed(&|scene| scene.lights.iter_mut().for_each(darken)));
    let mut wrong = right();
    wrong.put_pixel(7, 5, Rgb([0; 3]));
    add("one pixel", "ada", wrong);
    add("the picture of step 5", "ada", draw_step(Step::Phong));
    add("another size", "ada", RgbImage::new(2, 1));
    answers.assert_locked("scenes_of_names");
}
