//! The items of the five crates, by their names.

use crate::files::Files;
use crate::source::SOURCE;

/// Words before the name of an item.
const KINDS: [&str; 6] = ["fn", "struct", "enum", "const", "static", "type"];

/// Whether there is an item `name`: a function, a type or a constant, or as
/// `Type::member` a function, a field or a variant of a type.
pub fn is_there(source: &Files, name: &str) -> bool {
    !bodies(source, name).is_empty()
}

/// Whether the function `function` speaks of a variable `name`.
pub fn has_variable(source: &Files, function: &str, name: &str) -> bool {
    let is_letter = |c: char| c.is_alphanumeric() || c == '_';
    let bodies = bodies(source, function);
    bodies.iter().any(|body| body.split(|c| !is_letter(c)).any(|word| word == name))
}

/// The text of each item `name`, from its head to the line that closes it.
fn bodies<'a>(source: &'a Files, name: &str) -> Vec<&'a str> {
    let all = source.texts(".rs").flat_map(|(_, text)| blocks(text));
    let Some((owner, member)) = name.split_once("::") else {
        let named = all.filter(|(head, _)| is_named(head, name));
        return named.map(|(_, block)| block).collect();
    };
    let mut found = vec![];
    for (head, block) in all {
        let (_, inside) = block.split_once('\n').unwrap_or_default();
        let implements =
            head.starts_with("impl") && head.ends_with(&format!(" {owner} {{"));
        if implements || is_named(head, owner) {
            // A field or a variant of a type begins with its name.
            let is_member = |head| {
                is_named(head, member) || !implements && begins(head, member)
            };
            let members = blocks(inside).filter(|(head, _)| is_member(head));
            found.extend(members.map(|(_, member)| member));
        }
    }
    found
}

/// Whether an item that begins with `head` has this name.
fn is_named(head: &str, name: &str) -> bool {
    KINDS.iter().any(|kind| begins(head, &format!("{kind} {name}")))
}

/// Whether `head` begins with all of the words in `words`.
fn begins(head: &str, words: &str) -> bool {
    let rest = head.strip_prefix(words);
    rest.is_some_and(|rest| {
        !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_')
    })
}

/// Every line of a text that is no comment, without its `pub`, and the lines from
/// there to the one that closes what it opens.
fn blocks(text: &str) -> impl Iterator<Item = (&str, &str)> {
    let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines.map(move |line| {
        let head = line.trim().trim_start_matches("pub(crate) ");
        let head = head.trim_start_matches("pub ");
        let function = head.strip_prefix("const ").filter(|f| f.starts_with("fn "));
        let head = function.unwrap_or(head);
        // `line` is a part of `text`.
        let start = line.as_ptr().addr() - text.as_ptr().addr();
        let indent = &line[..line.len() - line.trim_start().len()];
        let close = format!("\n{indent}}}");
        let opens = !line.ends_with([',', ';', '}']);
        let length = text[start..].find(&close).filter(|_| opens);
        (head, &text[start..start + length.unwrap_or(line.len())])
    })
}

#[test]
fn items_are_found_by_their_names() {
    for name in [
        "Ray",
        "Ray::start",
        "Ray::at",
        "Roots",
        "Roots::first_hit",
        "quadratic",
        "SPHERES",
        "AMBIENT_LIGHT",
        "Phong::sum",
        "AspectRatio::width",
        "Picture",
        "shiny",
        "Surface::of",
    ] {
        assert!(is_there(&SOURCE, name), "{name}");
    }
    for name in [
        "Way",
        "Ray::end",
        "Ray::radius",
        "Sphere::start",
        "Ray::self",
        "quad",
        "first_hit::t",
    ] {
        assert!(!is_there(&SOURCE, name), "{name}");
    }
    assert!(has_variable(&SOURCE, "Row::new", "v_0"));
    assert!(
        has_variable(&SOURCE, "quadratic", "b")
            && !has_variable(&SOURCE, "quadratic", "v_0")
    );
}
