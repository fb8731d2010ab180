//! What is moved shows what the chapters say of it.

use glam::{DVec2, DVec3, dvec2};
use live::{LIVE, Live, find};

fn named(name: &str) -> &'static Live {
    find(name).expect("it answers")
}

/// The numbers of this name at these values: one, or the entries of a vector.
fn numbers(live: &Live, values: &[f64], name: &str) -> Vec<f64> {
    let all = (live.numbers)(values);
    let text = all.into_iter().find(|(known, _)| known == name).expect(name).1;
    let text = text.replace('−', "-");
    let parts = text.trim_matches(['(', ')']).split(", ");
    parts.filter_map(|part| part.parse().ok()).collect()
}

fn vector(live: &Live, values: &[f64], name: &str) -> DVec3 {
    DVec3::from_slice(&numbers(live, values, name))
}

#[test]
fn a_handle_in_a_picture_comes_where_it_is_dragged() {
    let pictures = LIVE.iter().filter(|live| live.name.starts_with("step"));
    let mut dragged = 0;
    for live in pictures {
        for handle in &live.handles {
            let to = dvec2(400.0, 150.0);
            let values = live.drag(&live.values(), handle, to).expect("allowed");
            let at = handle.place(&values);
            assert!(
                at.distance(to) < 20.0,
                "{}: {} at {at}",
                live.name,
                handle.words
            );
            dragged += 1;
        }
    }
    assert_eq!(dragged, 7);
}

#[test]
fn a_handle_leaves_no_picture_by_its_keys() {
    let live = named("step04_diffuse");
    let warm = &live.handles[1];
    let mut values = live.values();
    values[3..6].copy_from_slice(&[0.0, 0.5, -4.0]);
    for _ in 0..100 {
        values = live.step(&values, warm, dvec2(1.0, 0.0)).expect("allowed");
    }
    let at = warm.place(&values);
    assert_eq!(at, at.clamp(DVec2::ZERO, dvec2(640.0, 360.0)));
}

#[test]
fn a_lamp_behind_the_eye_has_no_place() {
    let live = named("step04_diffuse");
    let mut values = live.values();
    (values[3], values[4], values[5]) = (0.0, 0.5, -2.0);
    assert!(live.handles[1].place(&values).min_element() >= 0.0);
    for z in [0.0, 2.0] {
        values[5] = z;
        assert!(live.handles[1].place(&values).x < 0.0);
    }
}

#[test]
fn a_lamp_is_where_its_l_leads() {
    let live = named("step04_diffuse");
    let mut values = live.values();
    values[3..].copy_from_slice(&[-1.0, 2.0, -4.0, 2.5, -1.0, -13.0]);
    let p = vector(live, &values, "p");
    for (lamp, first) in [("warm", 3), ("cool", 6)] {
        let l = vector(live, &values, &format!("l {lamp}"));
        let d = numbers(live, &values, &format!("d {lamp}"))[0];
        let place = DVec3::from_slice(&values[first..]);
        assert!((p + d * l).abs_diff_eq(place, 0.01), "{lamp}: {}", p + d * l);
    }
}

#[test]
fn the_material_that_is_set_is_that_of_the_sphere_asked() {
    let live = named("step05_phong");
    for (pixel, words) in [([583.0, 215.0], "teal"), ([262.0, 132.0], "red")] {
        let mut values = live.values();
        values[..2].copy_from_slice(&pixel);
        let is_shown =
            |k: &usize| (live.knobs[*k].is_shown)(&live.knobs[*k], &values);
        let shown: Vec<usize> = (6..live.knobs.len()).filter(is_shown).collect();
        let [n, r_s] = shown[..] else { panic!("{words}: {shown:?}") };
        assert!(live.knobs[n].words.contains(words), "{}", live.knobs[n].words);
        let before = vector(live, &values, "specular");
        (values[n], values[r_s]) = (7.0, 0.0);
        assert_eq!(numbers(live, &values, "shininess"), [7.0]);
        assert_eq!(vector(live, &values, "specular"), DVec3::ZERO);
        assert_ne!(before, DVec3::ZERO, "{words} has a highlight there");
    }
}

#[test]
fn every_root_is_marked_from_above() {
    let live = named("step03_nearest");
    let (_, draw) = live.beside.expect("the scene from above");
    for (pixel, count) in [([195.0, 237.0], 7), ([600.0, 20.0], 0)] {
        let values = [pixel[0], pixel[1], 640.0];
        let ends = (0..9).flat_map(|k| [format!("near{k}"), format!("far{k}")]);
        let roots = ends.flat_map(|name| numbers(live, &values, &name));
        // The drawing ends at 13.2.
        assert_eq!(roots.filter(|t| *t < 13.2).count(), count);
        let drawing = draw(&values);
        let marked = ["\"ray dot\"", "\"behind dot\""]
            .map(|class| drawing.body().matches(class).count());
        assert_eq!(marked.iter().sum::<usize>(), count);
    }
}

#[test]
fn the_reflected_light_keeps_its_angle() {
    let live = named("phong-vectors");
    let at = |values: &[f64]| live.handles[0].place(values) - dvec2(240.0, 240.0);
    for turn in [-30.0, 0.0, 25.0, 70.0] {
        let angle = at(&[turn]).x.atan2(at(&[turn]).y).to_degrees().abs();
        let told = numbers(live, &[turn], "angle")[0].abs();
        assert!((180.0 - angle - told).abs() < 0.1, "{angle}, {told}");
    }
}

#[test]
fn an_egg_is_as_long_as_the_chapter_derives() {
    let live = named("eggs");
    let alpha = 8_f64.to_radians();
    for (theta, phi) in [(60.0, 20_f64), (100.0, 40.0), (140.0, 60.0)] {
        assert_eq!(numbers(live, &[theta], "phi"), [phi]);
        let phi = phi.to_radians();
        let long = (phi + alpha).tan() - (phi - alpha).tan();
        let wide =
            2.0 * alpha.sin() / (phi.cos().powi(2) - alpha.sin().powi(2)).sqrt();
        let times = numbers(live, &[theta], "times")[0];
        assert!((times - long / wide).abs() <= 0.051, "{times}, {}", long / wide);
    }
}
