//! The text of an answer.

use std::fmt::Write;

/// A value in JSON, as its text.
#[derive(Debug)]
pub struct Json(String);

impl Json {
    /// A text that is JSON already.
    pub fn raw(text: String) -> Self {
        Self(text)
    }

    /// A list.
    pub fn list(items: impl IntoIterator<Item = Self>) -> Self {
        let items: Vec<_> = items.into_iter().map(|item| item.0).collect();
        Self(format!("[{}]", items.join(",")))
    }
}

impl From<f64> for Json {
    fn from(number: f64) -> Self {
        Self(number.to_string())
    }
}

/// What prints an f64 is large; a module that has none of them does without it.
impl From<u32> for Json {
    fn from(number: u32) -> Self {
        Self(number.to_string())
    }
}

impl From<bool> for Json {
    fn from(is_so: bool) -> Self {
        Self(is_so.to_string())
    }
}

impl From<&str> for Json {
    fn from(text: &str) -> Self {
        let mut quoted = String::from("\"");
        for c in text.chars() {
            match c {
                '"' | '\\' => quoted.extend(['\\', c]),
                c if c < ' ' => {
                    let _ = write!(quoted, "\\u{:04x}", c as u32);
                }
                c => quoted.push(c),
            }
        }
        Self(quoted + "\"")
    }
}

impl From<String> for Json {
    fn from(text: String) -> Self {
        text.as_str().into()
    }
}

/// An object of named values.
pub fn object(fields: impl IntoIterator<Item = (impl AsRef<str>, Json)>) -> String {
    let fields: Vec<_> = fields
        .into_iter()
        .map(|(name, value)| format!("{}:{}", Json::from(name.as_ref()).0, value.0))
        .collect();
    format!("{{{}}}", fields.join(","))
}
