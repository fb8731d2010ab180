//! Compares how we and rustc evaluate a thousand random lines. We must refuse any line that rustc
//! refuses, or that panics in a debug build. Every value that we compute must equal rustc's to the
//! last bit.

use crate::lines::cure_line;
use course::{Place, ValueType, cargo_command, target_folder, workspace};
use fastrand::Rng;
use glam::dvec3;
use page::expressions::{Fault, Refusal, Value, compile_line};
use std::{collections::BTreeSet, fs};

const PARAMETERS: &str = "d: f64, e: f64, n: DVec3, l: DVec3, k: i32, yes: bool";

const KIND: &str = "fn(f64, f64, DVec3, DVec3, i32, bool) -> String";

const MANIFEST: &str = "[package]\nname = \"judge\"\nedition = \"2024\"\n[workspace]\n\
    [dependencies]\nglam = { version = \"0.34\", default-features = false, features = [\"f64\", \"std\"] }\n";

/// The start of the program. After this text come a function for each line, and the list `ALL` of
/// these functions. For each function, the program prints the result, or "stop" if the function
/// panics.
const PROGRAM: &str = "#![allow(warnings)] use glam::DVec3; use std::panic::*; fn main() { \
    set_hook(Box::new(|_| {})); for f in ALL { println!(\"{}\", catch_unwind(|| f(0.75, -3.5, \
    DVec3::new(0.5, -0.25, 2.0), DVec3::Z, -3, true)).unwrap_or(\"stop\".to_owned())) } }\n";

/// Writes a random line, by filling in a pattern from patterns.txt. The name of the line's type
/// usually begins with `type_initial`. About one line in fifty may have any type. In a pattern:
///
/// - `$` followed by the initial of a type stands for an expression of that type.
/// - `;` stands for a comma.
/// - `#` stands for a semicolon.
///
/// If the name of a list of patterns ends with `?`, the list contains typical slips. Most lines
/// with a slip are refused with a cure.
fn write_random_line(rng: &mut Rng, type_initial: &str, depth: usize) -> String {
    let is_wrong = rng.u8(..) < 5;
    let is_slip = depth > 0 && "fDb".contains(type_initial) && rng.u8(..) < 20;
    let lists = include_str!("patterns.txt")
        .lines()
        .filter_map(|line| line.split_once(": "))
        .filter(|(name, _)| is_wrong || name.starts_with(type_initial))
        .filter(|(name, _)| name.ends_with('?') == is_slip);
    let patterns = lists.flat_map(|(_, list)| list.split(", "));
    let patterns: Vec<_> = patterns.take(if depth == 0 { 3 } else { usize::MAX }).collect();
    let pattern = rng.choice(patterns).expect("a pattern").replace(';', ",").replace('#', ";");
    let mut parts = pattern.split('$');
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let inner = write_random_line(rng, &part[..1], depth.saturating_sub(1));
        let is_bare = rng.bool() || pattern.contains('(');
        text += &if is_bare { inner } else { format!("({inner})") };
        text += &part[1..];
    }
    text
}

/// Compiles the lines with rustc and runs them. Returns the value of each line, `stop` if the line
/// panics, or None if rustc refuses the line.
fn evaluate_with_rustc(lines: &[(&str, String)]) -> Vec<Option<String>> {
    let folder = target_folder().join("judge");
    fs::create_dir_all(folder.join("src")).expect("the folder can be created");
    fs::copy(workspace().join("Cargo.lock"), folder.join("Cargo.lock"))
        .expect("the lock file can be copied");
    fs::write(folder.join("Cargo.toml"), MANIFEST).expect("the file can be written");
    let mut refused_lines = BTreeSet::new();
    loop {
        let is_judged = |index: &usize| !refused_lines.contains(index);
        let function = |(index, (kind, text)): (usize, &(&str, String))| match is_judged(&index) {
            true => format!(
                "fn f{index}({PARAMETERS}) -> String {{ let x: {kind} = {text}; format!(\"{{x:?}}\") }}\n"
            ),
            // An empty line stands in for the function, so that later functions keep their line
            // numbers.
            false => "\n".to_owned(),
        };
        let functions: String = lines.iter().enumerate().map(function).collect();
        let names = (0..lines.len()).filter(is_judged).map(|index| format!("f{index}, "));
        let names: String = names.collect();
        let source = format!("{PROGRAM}{functions}const ALL: &[{KIND}] = &[{names}];");
        fs::write(folder.join("src/main.rs"), source).expect("the file can be written");
        let mut cargo = cargo_command();
        cargo.args(["run", "-q", "--offline", "--message-format=short", "--target-dir=target"]);
        let output = cargo.current_dir(&folder).output().expect("cargo runs");
        let read = |bytes| String::from_utf8(bytes).expect("a text");
        let [text, errors] = [output.stdout, output.stderr].map(read);
        if output.status.success() {
            let mut values = text.lines().map(str::to_owned);
            let answer = |index| is_judged(&index).then(|| values.next()).flatten();
            return (0..lines.len()).map(answer).collect();
        }
        let count = refused_lines.len();
        let rows = errors.lines().filter(|line| line.contains(": error"));
        let rows = rows.filter_map(|line| line.split(':').nth(1)?.parse::<usize>().ok());
        refused_lines.extend(rows.map(|row| row - 2));
        assert!(count < refused_lines.len(), "{errors}");
    }
}

#[test]
#[ignore = "compiles a thousand lines"]
fn random_lines_have_the_values_that_rustc_gives_them() {
    let mut rng = Rng::with_seed(7);
    let mut lines = vec![];
    while lines.len() < 1000 {
        let (kind, depth) = (["f64", "DVec3", "bool"][rng.usize(..3)], rng.usize(2..5));
        lines.push((kind, write_random_line(&mut rng, &kind[..1], depth)));
        lines.pop_if(|(_, text)| !(12..200).contains(&text.len()));
    }
    let [n, l] = [dvec3(0.5, -0.25, 2.0), dvec3(0.0, 0.0, 1.0)].map(Value::Vector);
    let [d, e] = [0.75, -3.5].map(Value::F64);
    let values = vec![d, e, n, l, Value::I32(-3), Value::Bool(true)];
    let parse_type = |name| ValueType::from_name(name).expect("a type");
    let variables = PARAMETERS.split(", ").filter_map(|parameter| parameter.split_once(": "));
    let mut place = Place {
        index: 0,
        name: "",
        file: "step05_phong/src/phong.rs",
        has_vectors: true,
        code: "",
        value_type: ValueType::F64,
        variables: variables.map(|(name, type_name)| (name, parse_type(type_name))).collect(),
        notes: vec![],
    };
    let mut cured_lines = vec![];
    for (kind, text) in &lines {
        place.value_type = parse_type(kind);
        let cured = cure_line(&place, text);
        cured_lines.extend((cured != *text).then_some((*kind, cured)));
    }
    let cure_count = cured_lines.len();
    lines.extend(cured_lines);
    let (mut wrong, mut only_here, mut equal) = (String::new(), String::new(), 0);
    let (mut equal_cures, judged_lines) = (0, evaluate_with_rustc(&lines));
    for (index, ((kind, text), judged)) in lines.iter().zip(judged_lines).enumerate() {
        place.value_type = parse_type(kind);
        let value = compile_line(&place, text).and_then(|line| {
            let no_result = Refusal { range: 0..text.len(), fault: Fault::NoResult };
            line.evaluate(&values).ok_or(no_result)
        });
        // The program prints 0.75 for our `F64(0.75)`, so remove the variant's name and the
        // parentheses.
        let bare_value = value.map(|value| {
            let written = format!("{value:?}");
            let (_, bare) = written.split_once('(').expect("a variant");
            bare.strip_suffix(')').expect("a variant").to_owned()
        });
        match (judged.as_deref(), bare_value) {
            (None | Some("stop"), Err(_)) => {}
            (Some(right), Ok(value)) if value == right => {
                *(if index < 1000 { &mut equal } else { &mut equal_cures }) += 1;
            }
            (Some(_), Err(refusal)) => only_here += &format!("{text}: {refusal}\n"),
            (right, value) => wrong += &format!("{text}: {value:?}, rustc {right:?}\n"),
        }
    }
    println!(
        "{equal} equal, and {equal_cures} of {cure_count} cured; {} refused here alone:\n{only_here}",
        only_here.lines().count()
    );
    assert_eq!(wrong, "");
    assert!(equal_cures > 50, "only {equal_cures} cured lines have the right value");
    assert!(
        equal > 400 && only_here.lines().count() < 80,
        "{equal} lines have the value that rustc gives them"
    );
}
