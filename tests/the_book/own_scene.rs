//! Tests that the Rust program that a page writes for the reader's own scene draws the same picture
//! as the page.

use super::built_book::read_folder;
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

fn find_scene() -> (&'static Figure, &'static EditableScene) {
    let figure = find_figure("own_scene").expect("a figure");
    (figure, figure.editable_scene.as_ref().expect("a scene"))
}

/// At first, the page shows the example's file. Once a reader changes the scene, it shows the
/// program written for that scene, so the two have to agree before any change.
#[test]
fn program_of_the_unchanged_scene_is_the_example() {
    let (figure, scene) = find_scene();
    let program = (scene.program)(&figure.default_values());
    let examples = read_folder("steps/step05_phong/examples");
    let example = examples.text("own_scene.rs").expect("the example");
    let different = program.lines().zip(example.lines()).find(|(line, other)| line != other);
    assert_eq!(different, None, "a line of the program, and the line in examples/own_scene.rs");
}

#[test]
#[ignore = "takes a minute: cargo test -- --include-ignored"]
fn program_of_a_scene_draws_its_picture() {
    let ((figure, scene), reader) = (find_scene(), ReaderWorkspace::with_typed_book());
    let Content::Picture { draw } = figure.content else { panic!("a drawing") };
    for address in ADDRESSES {
        let values = parse_address(figure, address).expect("a scene");
        assert_program_draws(&reader, &(scene.program)(&values), &draw(&values, COLUMNS));
    }
}

/// Saves a program, and runs it with the command in the program's second line. The command ends
/// with the program's name.
fn assert_program_draws(reader: &ReaderWorkspace, program: &str, picture: &RgbImage) {
    let second_line = program.lines().nth(1).expect("a second line");
    let command = second_line.split('`').nth(1).expect("a command");
    let (_, example) = command.rsplit_once(' ').expect("a name");
    let path = format!("steps/step05_phong/examples/{example}.rs");
    reader.write_if_changed(&path, program).expect("a file can be written");
    let (code, text) = reader.run(&["bash", "-c", command], "1").expect("a shell");
    assert!(code == Some(0) && !text.contains("warning"), "{text} in {program}");
    let program_picture =
        image::open(reader.folder.join(format!("{example}.png"))).expect("its picture");
    assert_eq!(describe_difference(picture, &program_picture.to_rgb8()), None, "{program}");
}
