/// A text in which each piece from `begin` to the next `end` is replaced by what is inside it, as
/// `replacement` gives it.
pub fn replace_between(
    text: &str,
    begin: &str,
    end: &str,
    replacement: impl Fn(&str) -> Result<String, String>,
) -> Result<String, String> {
    let mut parts = text.split(begin);
    let mut replaced = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (inside, tail) =
            part.split_once(end).ok_or(format!("{begin} is without its {end} in the same line"))?;
        replaced += &replacement(inside)?;
        replaced += tail;
    }
    Ok(replaced)
}
