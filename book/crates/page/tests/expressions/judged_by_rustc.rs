//! A thousand made lines: what rustc refuses, or what stops in a development build, is refused,
//! and what is drawn is equal to the last bit.

use course::{Place, target_folder, workspace};
use fastrand::Rng;
use glam::dvec3;
use page::expressions::{Value, parse_expression};
use std::{collections::BTreeSet, env, fs, process::Command};

const PARAMETERS: &str = "d: f64, e: f64, n: DVec3, l: DVec3, k: i32, h: u32, yes: bool";

/// What a line may have for each type, with two blanks between them; a $ and the first letter of
/// a type, or U for usize, is a line of that type.
const PATTERNS: [(&str, &str); 6] = [
    (
        "f64",
        "d  e  2.0  1.5_f64  $f + $f  $f - $f  $f * $f  $f / $f  $f % $f  -$f  ($f)  $f.sqrt()  \
        $f.max($f)  f64::min($f, $f)  $D.x  $D.dot($D)  $D[$U]  $i as f64  f64::from($i)  \
        if $b { $f } else { $f }  { let x = $f; x * x }  [$f, $f][$U]  $f.powi($i)  &$f * $f  2  \
        $f.clamp($f, $f)  f64::from($b)  f64::INFINITY  $D.length()  { let x = 3.0; x }  *&$f",
    ),
    (
        "DVec3",
        "n  l  DVec3::Y  $D + $D  $D * $f  $f * $D  $D / $f  -$D  ($D)  DVec3::new($f, $f, $f)  \
        $D.cross($D)  $D.normalize()  $D.max($D)  DVec3::from([$f, $f, $f])  $D - $f  &$D * $f  \
        if $b { $D } else { $D }  $D.lerp($D, $f)  { let x = $D; x - $D }  DVec3::splat($f)",
    ),
    (
        "bool",
        "yes  true  false  $f < $f  $f <= $f  $i == $i  $D == $D  !$b  $b && $b  $b || $b  ($b)  \
        $u != $u  &$f < &$f  $b != $b  $f.is_nan()  $U < $U",
    ),
    (
        "i32",
        "k  3  7_i32  $i + $i  $i - $i  $i * $i  $i / $i  $i % $i  -$i  ($i)  $f as i32  $u as i32  \
        $b as i32  $i.abs()  $i.pow($u)  i32::max($i, $i)  { let x = 5; x + $i }  $i.clamp($i, $i)",
    ),
    (
        "u32",
        "h  4  9_u32  $u + $u  $u - $u  $u * $u  $u / $u  $u % $u  ($u)  $i as u32  $f as u32  \
        $u.min($u)  u32::from($b)  -$u  $i.abs_diff($i)  if $b { $u } else { 1 }",
    ),
    ("Usize", "0  1  2  $u as usize  $U + $U  $U % 2  ($U)  $f as usize"),
];

fn write_line(rng: &mut Rng, letter: &str, depth: usize) -> String {
    let is_wrong = rng.u8(..) < 5;
    let mut kinds = PATTERNS.to_vec();
    kinds.retain(|(name, _)| is_wrong || name.starts_with(letter));
    let (_, patterns) = rng.choice(kinds).expect("a type");
    let patterns = patterns.split("  ").take(if depth == 0 { 3 } else { usize::MAX });
    let pattern = rng.choice(patterns.collect::<Vec<_>>()).expect("a pattern");
    let mut parts = pattern.split('$');
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let inner = write_line(rng, &part[..1], depth.saturating_sub(1));
        let is_bare = rng.bool() || pattern.contains('(');
        text += &if is_bare { inner } else { format!("({inner})") };
        text += &part[1..];
    }
    text
}

/// What rustc makes of each line: nothing where it refuses it, "stop" where it panics.
fn ask_rustc(lines: &[(&str, String)]) -> Vec<Option<String>> {
    let folder = target_folder().join("judge");
    let path = folder.join("src/main.rs");
    fs::create_dir_all(folder.join("src")).expect("a folder");
    fs::copy(workspace().join("Cargo.lock"), folder.join("Cargo.lock")).expect("a copy");
    let manifest = "[package]\nname = \"judge\"\nedition = \"2024\"\n[workspace]\n[dependencies]\n\
        glam = { version = \"0.34\", default-features = false, features = [\"f64\", \"std\"] }\n";
    fs::write(folder.join("Cargo.toml"), manifest).expect("a file");
    let mut refused = BTreeSet::new();
    loop {
        let main = "fn main() { std::panic::set_hook(Box::new(|_| {})); for f in ALL { println!(\"{}\", \
            std::panic::catch_unwind(|| f(0.75, -3.5, DVec3::new(0.5, -0.25, 2.0), DVec3::Z, -3, 4, true))\
            .unwrap_or(\"stop\".to_owned())) } }";
        let mut source = format!("#![allow(warnings)] use glam::DVec3; {main}\n");
        let mut names = String::new();
        for (index, (kind, text)) in lines.iter().enumerate() {
            if !refused.contains(&index) {
                source += &format!(
                    "fn f{index}({PARAMETERS}) -> String {{ let value: {kind} = {text}; format!(\"{{value:?}}\") }}"
                );
                names += &format!("f{index}, ");
            }
            source += "\n";
        }
        source += &format!(
            "const ALL: &[fn(f64, f64, DVec3, DVec3, i32, u32, bool) -> String] = &[{names}];"
        );
        fs::write(&path, source).expect("a file");
        let cargo = env::var_os("CARGO").unwrap_or("cargo".into());
        let mut cargo = Command::new(cargo);
        cargo.args([
            "run",
            "-q",
            "--offline",
            "--message-format",
            "short",
            "--target-dir",
            "target",
        ]);
        let output = cargo.current_dir(&folder).output().expect("cargo");
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        let count = refused.len();
        let errors = errors.lines().filter(|line| line.contains(": error"));
        let rows = errors.filter_map(|line| line.split(':').nth(1)?.parse::<usize>().ok());
        refused.extend(rows.map(|row| row - 2));
        if output.status.success() {
            let text = String::from_utf8_lossy(&output.stdout).into_owned();
            let mut values = text.lines().map(str::to_owned);
            let all = 0..lines.len();
            return all
                .map(|index| (!refused.contains(&index)).then(|| values.next()).flatten())
                .collect();
        }
        assert!(count < refused.len(), "{}", String::from_utf8_lossy(&output.stderr));
    }
}

#[test]
#[ignore = "compiles for a minute"]
fn rustc_judges_made_lines() {
    let mut rng = Rng::with_seed(7);
    let kinds = ["f64", "DVec3", "bool"];
    let mut lines: Vec<_> = (0..3000).map(|index| (kinds[index % 3], String::new())).collect();
    lines.iter_mut().for_each(|(kind, text)| *text = write_line(&mut rng, &kind[..1], 3));
    lines.retain(|(_, text)| (12..200).contains(&text.len()));
    lines.truncate(1000);
    let values = [
        Value::F64(0.75),
        Value::F64(-3.5),
        Value::DVec3(dvec3(0.5, -0.25, 2.0)),
        Value::DVec3(dvec3(0.0, 0.0, 1.0)),
        Value::I32(-3),
        Value::U32(4),
        Value::Bool(true),
    ];
    let variables = PARAMETERS.split(", ").filter_map(|one| one.split_once(": ")).collect();
    let mut place = Place { name: "", file: "", code: "", kind: "", variables };
    let (mut wrong, mut only_here, mut equal) = (vec![], vec![], 0);
    for ((kind, text), judged) in lines.iter().zip(ask_rustc(&lines)) {
        place.kind = kind;
        let value = parse_expression(&place, text).map_err(|refusal| refusal.sentence);
        let value = value.and_then(|line| match line.evaluate(&values) {
            Ok(Value::F64(value)) => Ok(format!("{value:?}")),
            Ok(Value::DVec3(value)) => Ok(format!("{value:?}")),
            Ok(Value::Bool(value)) => Ok(format!("{value:?}")),
            Ok(value) => Ok(format!("another type: {value:?}")),
            Err((_, sentence)) => Err(sentence.to_owned()),
        });
        match (judged.as_deref(), value) {
            (None | Some("stop"), Err(_)) => {}
            (Some(right), Ok(value)) if value == right => equal += 1,
            (Some(_), Err(sentence)) => only_here.push(format!("{text}: {sentence}\n")),
            (right, value) => wrong.push(format!("{text}: {value:?}, rustc {right:?}\n")),
        }
    }
    println!("{equal} equal, {} refused here alone:\n{}", only_here.len(), only_here.concat());
    assert!(wrong.is_empty(), "{} are wrong:\n{}", wrong.len(), wrong.concat());
    assert!(300 < equal && only_here.len() < 50, "{equal} are equal");
}
