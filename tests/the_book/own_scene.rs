//! The page of one's own scene: the Rust that it writes is a program that draws what the
//! page shows.

use super::assert_none;
use super::typed::whole;
use super::typist::Typist;
use compare::Difference;
use live::{Knob, Live, Sight, find};

/// Where its reader saves it.
pub const PATH: &str = "steps/step05_phong/examples/my_scene.rs";

/// What answers in the page.
fn live() -> &'static Live {
    find("own_scene").expect("it answers")
}

/// The Rust of the scene of these values.
fn rust(values: &[f64]) -> String {
    (live().numbers)(values).remove("rust").expect("it has Rust")
}

/// The Rust of the scene as it is printed.
pub fn printed() -> String {
    rust(&live().values())
}

/// The printed scene, but for some of its numbers, which are 0.
fn without(is_zero: fn(&Knob) -> bool) -> Vec<f64> {
    let knobs = live().knobs.iter();
    knobs.map(|knob| if is_zero(knob) { 0.0 } else { knob.value }).collect()
}

/// A scene without any pattern, the same each time; its picture is small.
fn any(seed: usize) -> Vec<f64> {
    let values = live().knobs.iter().zip(seed..).map(|(knob, k)| {
        let [min, max] = knob.range;
        let part = (1e4 * (k as f64).sin()).fract().abs();
        if knob.words == "columns" { 160.0 } else { min + part * (max - min) }
    });
    live().allowed(&values.collect::<Vec<_>>()).expect("a scene")
}

/// What is wrong with the program of a scene, typed into a workspace that holds the whole
/// book.
fn fault(typist: &Typist, values: &[f64]) -> Option<String> {
    let Sight::Picture(picture) = (live().sight)(values) else {
        panic!("it is a picture")
    };
    let rust = rust(values);
    typist.save(PATH, &rust).expect("a file can be written");
    // The command is in the second line; its options are after the last --.
    let command = rust.lines().nth(1)?.trim_end_matches('`');
    let options = command.split_once(" -- ").map_or("", |(_, options)| options);
    let options = format!("{options} --width {}", picture.width());
    match typist.draw("step05_phong", "my_scene", &options) {
        Err(what) => Some(format!("{what} in {rust}")),
        Ok(drawn) => Difference::between(&picture, &drawn)
            .map(|how| format!("It draws another picture, {how}: {rust}")),
    }
}

#[test]
#[ignore = "takes a minute: cargo test -- --include-ignored"]
fn the_rust_of_a_scene_draws_it() {
    let empty = without(|knob| !knob.choices.is_empty());
    let in_a_sphere = without(|knob| {
        knob.group == "red sphere" && ["x", "y", "z"].contains(&knob.symbol)
    });
    let (printed, typist) = (live().values(), whole());
    let Sight::Picture(picture) = live().printed() else { panic!("a picture") };
    assert!(
        Difference::between(&tests::locked("step05_phong"), &picture).is_none()
    );
    let scenes = [printed, empty, in_a_sphere, any(0), any(1000), any(2000)];
    let faults: Vec<_> =
        scenes.iter().filter_map(|values| fault(&typist, values)).collect();
    assert_none(&faults);
}
