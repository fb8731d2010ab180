//! What readers are told about lines that are refused because they don't compile or can't be drawn.
//! In the snapshot, the wrong part of a line is between ⟦ and ⟧.

use course::{Place, all_listed_places};
use page::expressions::{Fault, Refusal, compile_line, draw_step_of_first_line};
use page::{EditedLine, Request, try_reply};
use std::ops::Range;

#[test]
fn refused_lines_have_their_range_and_sentence() {
    let mut report = String::new();
    for line in include_str!("lines.txt").lines() {
        let (name, text) = line.split_once(' ').expect("a place and a text");
        report += &match try_line(name, text) {
            Ok(()) => format!("{name} {text}\n"),
            Err(Refusal { range, fault }) => {
                let Range { start, end } = range;
                let [text_before, wrong_text, text_after] =
                    [&text[..start], &text[start..end], &text[end..]];
                format!("{name} {text_before}⟦{wrong_text}⟧{text_after}\n    {fault}\n")
            }
        };
    }
    insta::assert_snapshot!(report);
}

/// Applies the cures that the refusals of a line suggest, one after the other, and returns the
/// resulting line.
///
/// # Panics
///
/// Panics if the code that a cure has inserted is itself refused for any reason except its type.
pub fn cure_line(place: &Place, text: &str) -> String {
    let mut cured_text = text.to_owned();
    let mut last_cure_range = None;
    for _ in 0..8 {
        let Err(Refusal { range, fault }) = compile_line(place, &cured_text) else { break };
        if let Some(Range { start, end }) = last_cure_range {
            let is_in_cure = start <= range.start && range.end <= end;
            // The type may be wrong through no fault of the cure, because the code around the cure
            // may require a different type.
            let is_type_mismatch =
                matches!(fault, Fault::WholeNumber { .. } | Fault::Mismatch { .. });
            assert!(!is_in_cure || is_type_mismatch, "{text}, cured: {cured_text}: {fault}");
        }
        let Some(cure) = fault.cure() else { break };
        last_cure_range = Some(range.start..range.start + cure.len());
        cured_text.replace_range(range, cure);
    }
    cured_text
}

#[test]
fn cures_are_accepted() {
    let mut cured_lines = String::new();
    for line in include_str!("lines.txt").lines() {
        let (name, text) = line.split_once(' ').expect("a place and a text");
        let place = all_listed_places().into_iter().find(|place| place.name == name);
        let cured_text = cure_line(&place.expect("a place"), text);
        if cured_text != text {
            cured_lines += &format!("{name} {text}\n  → {cured_text}\n");
        }
    }
    insta::assert_snapshot!(cured_lines);
}

/// Draws a small picture with this text at a place. Returns an error if the text is refused.
fn try_line(place_name: &str, text: &str) -> Result<(), Refusal> {
    try_line_within(place_name, text, 30_000)
}

/// Draws a small picture with this text at a place. Returns an error if the text is refused, or if
/// the whole picture takes more operations than `operations`.
fn try_line_within(place_name: &str, text: &str, operations: u64) -> Result<(), Refusal> {
    let place = all_listed_places().into_iter().find(|place| place.name == place_name);
    let line = compile_line(&place.expect("a place"), text)?;
    draw_step_of_first_line(&[line], 64, operations).map(|_| ()).map_err(|error| error.refusal)
}

#[test]
fn operations_are_counted_where_they_are_evaluated() {
    for (text, operations_per_pixel) in [
        ("DVec3::ONE", 1),
        ("2.0 * DVec3::ONE", 1),
        ("v + v", 2),
        ("{ let w = v + v; w + w }", 3),
        ("if v.x < 9.0 { v } else { v.sin().cos().exp() }", 4),
        ("DVec3::X * f64::from(v.x < 9.0 || v.y.sin().cos() < 0.0)", 6),
        ("v * (1e300 % v.x)", 44),
    ] {
        let operations = 64 * 36 * operations_per_pixel;
        assert_eq!(try_line_within("sky", text, operations), Ok(()), "{text}");
        let refusal = Refusal { range: 0..text.len(), fault: Fault::OutOfOperations };
        assert_eq!(try_line_within("sky", text, operations - 1), Err(refusal), "{text}");
    }
}

#[test]
fn long_text_and_slow_line_are_refused() {
    for (text, words) in [
        ("-".repeat(10_000), "longer than a line"),
        (format!("1.0{}", "+1e300%v.x".repeat(3)), "longer than a page"),
        (format!("1.0{}", "+v.x*v.x".repeat(20)), "longer than a page"),
    ] {
        let refusal = try_line("a", &text).expect_err("it is refused");
        assert!(refusal.to_string().contains(words), "{text}: {refusal}");
    }
}

#[test]
fn text_longer_than_250_bytes_is_refused() {
    let longest_text = format!("{:250}", "v.dot(v)");
    assert_eq!(try_line("a", &longest_text), Ok(()));
    assert!(try_line("a", &(longest_text + " ")).is_err());
}

/// Returns the text of the reply to these edited lines. Each line is a pair: the name of the line's
/// place, and the line's text.
fn reply_text(lines: &[(&str, &str)]) -> String {
    let lines = lines
        .iter()
        .map(|(place, text)| EditedLine { place: (*place).to_owned(), text: (*text).to_owned() });
    let request = Request::Edit { columns: 640, lines: lines.collect() };
    try_reply(&request, &[]).expect("a reply").text
}

#[test]
fn reply_says_what_the_edited_lines_change_or_what_is_wrong() {
    let cases: [(&[(&str, &str)], &str); 13] = [
        (&[("near", "(-b - d.sqrt()) / (2.0 * a) + 0.1")], "The picture of step 4 would show it"),
        (&[("near", "-(-b - d.sqrt()) / (2.0 * a)")], "The picture of step 3 would show it"),
        (&[("near", "(-b + d.sqrt()) / (2.0 * a)")], "The picture of step 4 would show it"),
        (&[("v", "ray.direction.normalize()")], "The picture of step 4 would show it"),
        (&[("c", "s.length_squared() - self.radius.powi(2)")], "none differs there, either"),
        (&[("b", "2.0 * v.dot(s)"), ("a", "v.length_squared()")], "none differs there, either"),
        (
            &[("b", "2.0 * s.dot(v)"), ("misses", "d <= 0.0")],
            "Not one pixel differs from the book's picture.\"",
        ),
        (
            &[("nearer", "t < best.as_ref().map_or(f64::INFINITY, |hit| hit.t)")],
            "Not one pixel differs",
        ),
        (&[("normal", "p - sphere.centre")], "n is not a unit vector"),
        (&[("normal", "p - sphere.centre"), ("byte", "255.0 * intensity + 0.5")], "\"note\":\"\""),
        (&[("byte", "intensity + 0.5")], "\"note\":\"\""),
        (
            &[("normal", "p"), ("attenuation", "(1.0")],
            "\"line\":\"attenuation\",\"from\":0,\"to\":1",
        ),
        (&[("normal", "p\u{7}")], "\"line\":\"normal\",\"from\":1,\"to\":2"),
    ];
    for (lines, words) in cases {
        let text = reply_text(lines);
        assert!(text.contains(words), "{lines:?}: {text}");
    }
}

#[test]
fn fault_in_an_unfinished_line_has_a_range_within_the_line() {
    for line in include_str!("lines.txt").lines() {
        let (name, text) = line.split_once(' ').expect("a place and a text");
        let place = all_listed_places().into_iter().find(|place| place.name == name);
        let place = place.expect("a place");
        for (end, _) in text.char_indices() {
            for typed in [&text[..end], &text[end..]] {
                if let Err(Refusal { range, fault }) = compile_line(&place, typed) {
                    assert!(
                        range.start <= range.end && range.end <= typed.len(),
                        "{typed}: {fault}"
                    );
                }
            }
        }
    }
}
