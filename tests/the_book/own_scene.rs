//! The page of one's own scene: the Rust that it writes is a program that draws what the
//! page shows.

use super::assert_none;
use super::typed::whole;
use compare::Difference;
use image::RgbImage;
use live::{Knob, LIVE, Live, Sight};
use proptest::prelude::Strategy;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// Where its reader saves it.
pub const PATH: &str = "steps/step05_phong/examples/my_scene.rs";

/// A scene: its Rust, and what the page shows of it.
struct Scene {
    rust: String,
    picture: RgbImage,
}

/// What answers in the page.
fn live() -> &'static Live {
    LIVE.iter().find(|live| live.name == "own_scene").expect("it answers")
}

/// The Rust of the scene as it is printed.
pub fn printed() -> String {
    rust(&live().values())
}

/// The Rust of the scene of these values.
fn rust(values: &[f64]) -> String {
    (live().numbers)(values).remove("rust").expect("it has Rust")
}

fn scene(values: &[f64]) -> Scene {
    let Sight::Picture(picture) = (live().sight)(values) else {
        panic!("it is a picture")
    };
    Scene { rust: rust(values), picture }
}

/// As many scenes at random, the same each time; their pictures are small.
fn random(count: usize) -> Vec<Scene> {
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let config = Config { failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, rng);
    let ranges = live().knobs.iter().map(|knob| {
        let [min, max] =
            if knob.words == "columns" { [160.0; 2] } else { knob.range };
        min..=max
    });
    let ranges: Vec<_> = ranges.collect();
    let mut values = || {
        let values = ranges.new_tree(&mut runner).expect("values").current();
        live().allowed(&values).expect("a scene")
    };
    (0..count).map(|_| scene(&values())).collect()
}

/// The printed scene, but for some of its numbers, which are 0.
fn without(is_zero: fn(&Knob) -> bool) -> Scene {
    let knobs = live().knobs.iter();
    let values = knobs.map(|knob| if is_zero(knob) { 0.0 } else { knob.value });
    scene(&values.collect::<Vec<_>>())
}

/// An example that draws one of several scenes, each of which is a module of it: so the
/// libraries are linked once.
fn example(count: usize) -> String {
    let modules: String = (0..count).map(|k| format!("mod own_{k};\n")).collect();
    let pictures: String =
        (0..count).map(|k| format!("own_{k}::picture, ")).collect();
    format!(
        "//! Scenes.\n#![allow(dead_code)]\n{modules}fn main() {{
            let pictures = [{pictures}];
            let which: usize = std::env::var(\"SCENE\").unwrap().parse().unwrap();
            step05_phong::run(env!(\"CARGO_CRATE_NAME\"), pictures[which]);
        }}"
    )
}

/// What is wrong with the programs of these scenes, typed into a workspace that holds
/// the whole book. The first is the one that the book has its reader type.
fn faults(scenes: &[Scene]) -> Vec<String> {
    let typist = whole();
    let folder = "steps/step05_phong/examples/own_scenes/";
    let rust = scenes.iter().map(|scene| scene.rust.clone()).enumerate();
    let files = rust.map(|(k, rust)| (format!("own_{k}.rs"), rust));
    for (file, text) in files.chain([("main.rs".into(), example(scenes.len()))]) {
        typist
            .save(&format!("{folder}{file}"), &text)
            .expect("a file can be written");
    }
    if let Err(what) =
        typist.build_examples("step05_phong", &["my_scene", "own_scenes"])
    {
        return vec![what.to_string()];
    }
    let drawn = scenes.iter().enumerate().filter_map(|(k, scene)| {
        // The command is in the second line; its options are after the last --.
        let command = scene.rust.lines().nth(1)?.trim_end_matches('`');
        let options = command.split_once(" -- ").map_or("", |(_, options)| options);
        let options = format!("{options} --width {}", scene.picture.width());
        let name = if k == 0 { "my_scene" } else { "own_scenes" };
        match typist.draw(name, &options, k) {
            Err(what) => Some(format!("{name} {k}: {what}")),
            Ok(drawn) => Difference::between(&scene.picture, &drawn)
                .map(|how| format!("{name} {k} draws another picture: {how}")),
        }
    });
    drawn.collect()
}

/// Fails unless the Rust that the page writes draws what it shows.
pub fn the_rust_of_a_scene_draws_it() {
    let empty = without(|knob| !knob.choices.is_empty());
    let in_a_sphere = without(|knob| {
        knob.group == "red sphere" && ["x", "y", "z"].contains(&knob.symbol)
    });
    let mut scenes = vec![scene(&live().values()), empty, in_a_sphere];
    scenes.extend(random(6));
    let locked = tests::locked("step05_phong");
    assert!(Difference::between(&locked, &scenes[0].picture).is_none());
    assert_none(&faults(&scenes));
}
