//! A minimal JSON writer. The replies to a page need nothing more, and a full JSON library would
//! make the pages' modules a sixth larger.

use crate::is_terminal_control;

/// Quotes `text` as a JSON string, escaping every character that a terminal would act on.
pub fn quote(text: &str) -> String {
    let mut quoted_text = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted_text.extend(['\\', c]),
            c if is_terminal_control(c) => quoted_text += &format!("\\u{:04x}", c as u32),
            c => quoted_text.push(c),
        }
    }
    quoted_text + "\""
}

/// Writes a JSON array. Each item has to be a number or JSON text.
pub fn list(items: impl IntoIterator<Item = impl ToString>) -> String {
    let items: Vec<_> = items.into_iter().map(|item| item.to_string()).collect();
    format!("[{}]", items.join(","))
}

/// Writes a JSON object. The value of each field has to be JSON text.
pub fn object<'a>(fields: impl IntoIterator<Item = (&'a str, String)>) -> String {
    let members = fields.into_iter().map(|(name, value)| format!("{}:{value}", quote(name)));
    format!("{{{}}}", members.collect::<Vec<_>>().join(","))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_quoted_and_escaped() {
        assert_eq!(quote("a \"b\\\n\u{202e}"), r#""a \"b\\\u000a\u202e""#);
        assert_eq!(quote("θ = 60°"), "\"θ = 60°\"");
    }

    #[test]
    fn items_of_a_list_and_values_of_an_object_are_written_unchanged() {
        assert_eq!(list([1.5, -2.0]), "[1.5,-2]");
        assert_eq!(list([""; 0]), "[]");
        let fields = [("a", list([1])), ("b \"c", quote("d"))];
        assert_eq!(object(fields), r#"{"a":[1],"b \"c":"d"}"#);
    }
}
