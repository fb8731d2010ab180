//! Tests the Rust program that the page "A scene of your own" writes for a reader's scene: the
//! program has to draw the same picture as the page.

use super::built_book::read_workspace_folder;
use super::reader_workspace::ReaderWorkspace;
use course::describe_difference;
use figures::{COLUMNS, Content, EditableScene, Figure, find_figure, parse_address};
use image::RgbImage;

/// The addresses of some scenes on the page.
const ADDRESSES: [&str; 5] = [
    "",
    "red-sphere-sideways:0,red-sphere-upwards:0,red-sphere-towards-you:0",
    "the-way-back-shadows-and-mirrors:1,ground-mirror-image:0.5",
    "camera-field-of-view:50,camera-position-sideways:6,camera-position-upwards:3.5,\
     camera-target-sideways:-0.5,camera-target-backwards:-8,camera-roll:-20",
    "the-way-back-shadows-and-mirrors:1,camera-position-upwards:3.5,camera-roll:-20",
];

/// Returns the figure of the page "A scene of your own", and the figure's editable scene.
fn own_scene_figure() -> (&'static Figure, &'static EditableScene) {
    let figure = find_figure("own_scene").expect("the figure exists");
    (figure, figure.editable_scene.as_ref().expect("the figure has an editable scene"))
}

/// The page's HTML contains the file of the example `own_scene`. A script replaces this text with
/// the program that is generated for the reader's scene. For the unchanged scene, the program has
/// to be the same as the file. Otherwise the text would change although the scene hasn't.
#[test]
fn program_of_the_unchanged_scene_is_the_example() {
    let (figure, scene) = own_scene_figure();
    let program = (scene.program)(&figure.default_values());
    let examples = read_workspace_folder("steps/step05_phong/examples");
    let example = examples.text("own_scene.rs").expect("the example exists");
    // Each text ends with None, so that a text with more lines differs from the other text.
    let expected = example.lines().map(Some).chain([None]);
    let different = program.lines().map(Some).chain([None]).zip(expected).find(|(a, b)| a != b);
    assert_eq!(different, None, "a line of the program differs from that in examples/own_scene.rs");
}

#[test]
#[ignore = "takes a minute: cargo test -- --include-ignored"]
fn program_of_a_scene_draws_its_picture() {
    let ((figure, scene), reader) = (own_scene_figure(), ReaderWorkspace::with_typed_book());
    let Content::Picture { draw } = figure.content else { panic!("the figure is not a picture") };
    for address in ADDRESSES {
        let values = parse_address(figure, address).expect("the address is valid");
        assert_program_draws(&reader, &(scene.program)(&values), &draw(&values, COLUMNS));
    }
}

/// Saves a program, runs it with the command in the program's second line, and asserts that the
/// program draws `picture`. The command ends with the program's name.
fn assert_program_draws(reader: &ReaderWorkspace, program: &str, picture: &RgbImage) {
    let second_line = program.lines().nth(1).expect("the program has a second line");
    let command = second_line.split('`').nth(1).expect("the line contains a command");
    let (_, example) = command.rsplit_once(' ').expect("the command ends with a name");
    let path = format!("steps/step05_phong/examples/{example}.rs");
    reader.write_if_changed(&path, program).expect("the file can be written");
    let (code, text) = reader.run_command(&["bash", "-c", command], "1").expect("bash can be run");
    assert!(code == Some(0) && !text.contains("warning"), "{text} in {program}");
    let program_picture = image::open(reader.folder.join(format!("{example}.png")))
        .expect("the program has drawn a picture");
    assert_eq!(describe_difference(picture, &program_picture.to_rgb8()), None, "{program}");
}
