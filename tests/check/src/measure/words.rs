use glam::DVec3;

/// A number as the book prints it: few digits, more for small ones, and a true minus.
///
/// By whole numbers: what prints an f64 is 7 KB of the page's module, packed.
pub(crate) fn number(x: f64) -> String {
    let digits = match x.abs() {
        size if size < 0.02 => 5,
        size if size < 2.0 => 4,
        size if size < 20.0 => 3,
        _ => 2,
    };
    if !x.is_finite() {
        let text = if x.is_nan() { "no number" } else { "∞" };
        return text.to_owned();
    }
    let scale = 10_u64.pow(digits);
    let all = (x.abs() * scale as f64).round() as u64;
    let (whole, part) = (all / scale, all % scale);
    let part = format!("{:0width$}", part, width = digits as usize);
    let text = match part.trim_end_matches('0') {
        "" => whole.to_string(),
        part => format!("{whole}.{part}"),
    };
    if x < 0.0 && 0 < all { format!("−{text}") } else { text }
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
