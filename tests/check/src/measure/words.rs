use glam::DVec3;

/// A number as the book prints it: few digits, more for small ones, and a true minus.
pub(crate) fn number(x: f64) -> String {
    let digits = match x.abs() {
        size if size < 0.02 => 5,
        size if size < 2.0 => 4,
        size if size < 20.0 => 3,
        _ => 2,
    };
    let text = format!("{x:.digits$}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    match text {
        "-0" | "" => "0".to_owned(),
        text => text.replace('-', "−"),
    }
}

/// A vector in parentheses.
pub(crate) fn vector(v: DVec3) -> String {
    format!("({})", v.to_array().map(number).join(", "))
}

/// A list in words: a, b and c.
pub(super) fn list(words: &[String]) -> String {
    match words {
        [] => String::new(),
        [one] => one.clone(),
        [rest @ .., last] => format!("{} and {last}", rest.join(", ")),
    }
}

/// A share in per cent that is 100 only where it is all, and 0 only where it is nothing.
pub(super) fn percent(part: usize, all: usize) -> String {
    match 1000 * part / all.max(1) {
        0 if 0 < part => "less than 0.1 %".to_owned(),
        1000 => "100 %".to_owned(),
        share if share % 10 == 0 => format!("{} %", share / 10),
        share => format!("{}.{} %", share / 10, share % 10),
    }
}
