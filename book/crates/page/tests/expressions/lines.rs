//! What is said of lines that are refused, where they are read or while they draw: of the part
//! between ⟦ and ⟧.

use course::all_listed_places;
use page::expressions::{Refusal, draw_edited, parse_expression};
use std::ops::Range;

#[test]
fn refused_lines_have_their_range_and_sentence() {
    let mut report = String::new();
    for line in include_str!("lines.txt").lines() {
        let (name, text) = line.split_once(' ').expect("a place and a text");
        report += &match draw(name, text) {
            Ok(()) => format!("{name} {text}\n"),
            Err(Refusal { range: Range { start, end }, sentence }) => {
                let end = text.ceil_char_boundary(end);
                let [before, wrong, after] = [&text[..start], &text[start..end], &text[end..]];
                format!("{name} {before}⟦{wrong}⟧{after}\n    {sentence}\n")
            }
        };
    }
    insta::assert_snapshot!(report);
}

fn draw(name: &str, text: &str) -> Result<(), Refusal> {
    let place = all_listed_places().into_iter().find(|place| place.name == name);
    let line = parse_expression(&place.expect("a place"), text)?;
    draw_edited(&[line], 64, 30_000).map(|_| ()).map_err(|(_, refusal)| refusal)
}

#[test]
fn too_long_text_is_refused() {
    for (text, words) in [
        ("-".repeat(10_000), "longer than a line"),
        (format!("1.0{}", "+1e300%v.x".repeat(3)), "longer than a page"),
        (format!("1.0{}", "+v.x*v.x".repeat(20)), "longer than a page"),
    ] {
        let refusal = draw("a", &text).expect_err("it is refused");
        assert!(refusal.sentence.contains(words), "{text}: {}", refusal.sentence);
    }
}

#[test]
fn text_is_too_long_from_251_bytes_on() {
    let longest = format!("{:250}", "v.dot(v)");
    assert_eq!(draw("a", &longest).err().map(|refusal| refusal.sentence), None);
    assert!(draw("a", &(longest + " ")).is_err());
}

#[test]
fn more_lines_than_there_are_places_are_not_drawn() {
    let lines = ["normal p"; 1000].join("\u{1f}");
    assert_eq!(page::reply(&format!("edit 640 {lines}"), &[]).text, "");
}

#[test]
fn answer_is_about_the_lines_and_no_others() {
    for (lines, words) in [
        ("near (-b - d.sqrt()) / (2.0 * a) + 0.1", "This picture can't show"),
        ("nearer t < best.as_ref().map_or(f64::INFINITY, |hit| hit.t)", "Not one pixel differs"),
        ("normal p - sphere.centre", "n is not a unit vector"),
        ("normal p - sphere.centre\u{1f}byte 255.0 * intensity + 0.5", "\"known\":\"\""),
        ("byte intensity + 0.5", "\"known\":\"\""),
        ("normal p\u{1f}attenuation (1.0", "\"line\":\"attenuation\",\"from\":0,\"to\":1"),
        ("normal p\u{7}", "\"line\":\"normal\",\"from\":1,\"to\":2"),
    ] {
        let text = page::reply(&format!("edit 640 {lines}"), &[]).text;
        assert!(text.contains(words), "{lines}: {text}");
    }
}
