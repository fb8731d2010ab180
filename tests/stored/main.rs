//! The module that the pages load says what this project says: to every request, the
//! same text and the same pixels.

mod check;
mod module;

use live::{Knob, LIVE, Live, Sight};
use module::{Code, Module, checked_in};
use proptest::prelude::Strategy;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use tests::is_thorough;

/// What mends a module that is not ours.
const MEND: &str = "book/wasm/*.wasm are not what our code says: `cargo run -p wasm` \
                    compiles them anew";

fn ours() -> Module {
    Code::new(&checked_in("live")).start()
}

/// How the module answers a request otherwise than we do.
fn fault(module: &mut Module, request: &str) -> Option<String> {
    let ours = live::answer(request);
    let theirs = module.answer(request, b"").unwrap_or_default();
    if ours == theirs {
        return None;
    }
    let mut both = ours.text.chars().zip(theirs.text.chars());
    let same = both.by_ref().take_while(|(our, their)| our == their).count();
    let part = |text: &str| text.chars().skip(same).take(40).collect::<String>();
    let (our, their) = (part(&ours.text), part(&theirs.text));
    Some(format!("To {request:?} it says “…{their}…” for “…{our}…”. {MEND}"))
}

/// Fails unless the module answers a request as we do.
#[track_caller]
fn assert_same(module: &mut Module, request: &str) {
    assert_eq!(fault(module, request), None);
}

#[test]
fn no_path_of_a_machine_stands_in_a_module() {
    for name in ["check", "live", "pictures"] {
        let module = checked_in(name);
        let text = String::from_utf8_lossy(&module);
        for path in [".cargo", "registry/src", "/home/", "/Users/"] {
            assert!(!text.contains(path), "{path} in {name}.wasm. {MEND}");
        }
    }
}

fn words(values: &[f64]) -> String {
    values.iter().map(|value| format!(" {value}")).collect()
}

/// The values of the printed book, but for the size of a picture: every pixel goes the
/// same way, and a browser compares all of them with the locked ones.
fn printed(live: &Live) -> Vec<f64> {
    let value =
        |knob: &Knob| if knob.words == "columns" { 64.0 } else { knob.value };
    live.knobs.iter().map(value).collect()
}

#[test]
fn the_module_says_what_we_say_as_printed() {
    let mut module = ours();
    for live in LIVE {
        assert_same(&mut module, &format!("about {}", live.name));
        let tell = format!("tell {}{}", live.name, words(&live.values()));
        assert_same(&mut module, &tell);
        assert_same(
            &mut module,
            &format!("show {}{}", live.name, words(&printed(live))),
        );
    }
}

/// The red, green and blue of every pixel of what there is to see as printed.
fn drawn(live: &Live) -> Vec<u8> {
    let Sight::Picture { pixels, .. } = (live.sight)(&live.values()) else {
        return vec![];
    };
    pixels.chunks_exact(4).flat_map(|four| four[..3].to_vec()).collect()
}

#[test]
fn a_picture_as_printed_is_that_of_its_step() {
    let camera = live::camera();
    for (name, picture) in [
        ("step01_rays", step01_rays::picture(&camera, 1)),
        ("step02_sphere", step02_sphere::picture(&camera, 1)),
        ("step03_nearest", step03_nearest::picture(&camera, 1)),
        ("step04_diffuse", step04_diffuse::picture(&camera, 1)),
        ("step05_phong", step05_phong::picture(&camera, 1)),
    ] {
        let live = live::find(name).expect("the picture answers");
        assert!(drawn(live) == *picture, "{name} as printed is another picture");
    }
}

/// Values anywhere in and around what is allowed; a picture is small.
fn values(live: &'static Live) -> impl Strategy<Value = Vec<f64>> {
    let ranges = live.knobs.iter().map(|knob| {
        let [min, max] = knob.range;
        let max = if knob.words == "columns" { 16.0 } else { max };
        min - 1.0..max + 1.0
    });
    ranges.collect::<Vec<_>>()
}

/// Shows something, drags a handle of it and steps one.
fn requests(live: &'static Live) -> impl Strategy<Value = Vec<String>> {
    let place = (-50.0..700.0, -50.0..400.0, -3_i32..=3, -3_i32..=3);
    (values(live), place).prop_map(|(values, (x, y, dx, dy))| {
        let (name, values) = (live.name, words(&values));
        let mut requests = vec![format!("show {name}{values}")];
        // Many handles are alike.
        for handle in (0..live.handles.len()).step_by(1 + live.handles.len() / 5) {
            requests.push(format!("drag {name} {handle} {x} {y}{values}"));
            requests.push(format!("step {name} {handle} {dx} {dy}{values}"));
        }
        requests
    })
}

#[test]
fn the_module_says_what_we_say_at_random() {
    let mut module = ours();
    for live in LIVE {
        // The same numbers each time: a platform's own tangent may differ from that
        // of the module in the last place.
        let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
        let config = Config { failure_persistence: None, ..Config::default() };
        let mut runner = TestRunner::new_with_rng(config, rng);
        let count = if is_thorough() { 2 } else { 1 };
        for _ in 0..count {
            let tree = requests(live).new_tree(&mut runner).expect("requests");
            for request in tree.current() {
                assert_same(&mut module, &request);
            }
        }
    }
}

#[test]
fn a_scene_of_ones_own_begins_as_that_of_step_5() {
    let live = live::find("own_scene").expect("the scene of one's own");
    assert_eq!(live::own_scene(&live.values()), step05_phong::scene());
}

#[test]
fn nonsense_gets_a_sentence() {
    let mut module = ours();
    for request in [
        "",
        "show",
        "show nowhere",
        "about nowhere",
        "show row",
        "show row 7",
        "drag row 0 1",
        "show row 7 sixty",
        "show row 7 NaN",
        "drag row 5 0 0 7 60",
        "drag row 0 inf 0 7 60",
        "show ray 0 0 0 0 1",
        "turn row 0 0 0 7 60",
        "é",
        "open nowhere",
    ] {
        let answer = live::answer(request);
        assert!(
            answer.text.contains("There is no answer to"),
            "{request}: {answer:?}"
        );
        assert_same(&mut module, request);
    }
}

#[test]
fn a_wrong_address_gets_a_sentence() {
    let mut module = ours();
    for (address, what) in [
        (
            "red-sphere-radius:0",
            "says 0 for red-sphere-radius; allowed are 0.05 to 3",
        ),
        ("camera-field-of-view:NaN", "allowed are 1 to 179"),
        (
            "red-sphere-radius:2,ground-radius:",
            "“” for ground-radius, which is no number",
        ),
        ("moon-radius:1", "speaks of “moon-radius”"),
        ("columns:7", "speaks of “columns”"),
        (&"%".repeat(99), "%…”, and nothing here is called so"),
    ] {
        let request = format!("open own_scene {address}");
        let answer = live::answer(&request);
        assert!(answer.text.contains(what), "{address}: {}", answer.text);
        assert!(answer.pixels.is_empty());
        assert_same(&mut module, &request);
    }
}

#[test]
fn an_address_leads_back_to_its_values() {
    let address = "red-sphere-radius:2,cool-light-on:0,camera-field-of-view:20";
    let all =
        [address, "", "twelfth-sphere-in-the-scene:1,ambient-light-blue:0.07"];
    for address in all {
        let answer = live::answer(&format!("open own_scene {address}"));
        let mut parts: Vec<_> = address.split(',').collect();
        parts.sort();
        let told =
            answer.text.split_once("\"address\":\"").map_or("", |(_, told)| told);
        let told = told.split('"').next().unwrap_or_default();
        let mut told: Vec<_> = told.split(',').collect();
        told.sort();
        assert_eq!(told, parts);
        assert!(!answer.pixels.is_empty());
    }
}

#[test]
fn a_module_that_is_not_ours_is_found() {
    let mut bytes = checked_in("live");
    let words = b"the tip of V";
    let at = bytes.windows(words.len()).position(|part| part == words);
    bytes[at.expect("a text of ours")] ^= 1;
    let told = fault(&mut Code::new(&bytes).start(), "about ray").expect("a fault");
    assert!(told.contains("cargo run -p wasm"), "{told}");
}
