use crate::expressions::functions::signatures_of;
use crate::expressions::refusal;
use course::{Kind, Place};
use glam::DVec3;
use std::ops::Range;

/// Meaning of a reader's text: a function of the variables of its place.
pub struct Expression(Code);

type Code = Box<dyn Fn(&[DVec3]) -> DVec3 + Send + Sync>;

impl Expression {
    /// Computes its value for these values of the variables.
    pub fn evaluate(&self, variables: &[DVec3]) -> DVec3 {
        self.0(variables)
    }
}

/// Fault in a text.
#[derive(Clone, Debug, PartialEq)]
pub struct ParseError {
    /// Bytes of the text that are wrong.
    pub range: Range<usize>,
    /// One or two sentences for the reader.
    pub sentence: String,
}

/// The most bytes of a text: that bounds the time of a picture.
const LENGTH: usize = 400;

/// The most parts inside each other.
const DEPTH: usize = 40;

/// Operators between two values, by level, the loosest first.
const OPERATORS: [&[&str]; 5] =
    [&["||"], &["&&"], &["==", "!=", "<=", ">=", "<", ">"], &["+", "-"], &["*", "/", "%"]];

/// The precedence level of the comparisons.
const COMPARISONS: usize = 2;

/// Reads what a reader wrote at a place.
pub fn parse_expression(place: &Place, text: &str) -> Result<Expression, ParseError> {
    let mut parser = Parser { place, text, at: 0, depth: 0 };
    if LENGTH < text.len() {
        return parser.refuse(0..text.len(), "That's longer than a line should be.");
    }
    let part = parser.parse_operations_of_level(0)?;
    if !parser.skip_blanks_and_peek().is_empty() {
        return parser.refuse_next_word("Something is missing before this, such as * or +.");
    }
    if !part.kind.is_accepted_as(place.kind) {
        let result = &text[part.range.clone()];
        let sentence = refusal::explain_wrong_kind_of_result(result, part.kind, place.kind);
        return parser.refuse(part.range, sentence);
    }
    Ok(Expression(part.code))
}

/// A subexpression.
struct Part {
    code: Code,
    kind: Kind,
    range: Range<usize>,
}

/// Reads a text from its start.
struct Parser<'a> {
    place: &'a Place,
    text: &'a str,
    at: usize,
    depth: usize,
}

type Parsed<T> = Result<T, ParseError>;

/// Whether a letter may be in a name.
pub fn is_word_char(c: char) -> bool {
    c.is_alphabetic() || c.is_ascii_digit() || c == '_'
}

impl<'a> Parser<'a> {
    fn refuse<T>(&self, range: Range<usize>, sentence: impl Into<String>) -> Parsed<T> {
        Err(ParseError { range, sentence: sentence.into() })
    }

    /// Refuses the word or the sign that comes next, or the end of the text.
    fn refuse_next_word<T>(&mut self, default_sentence: &str) -> Parsed<T> {
        let remaining = self.skip_blanks_and_peek();
        let Some(sign) = remaining.chars().next() else {
            let text = self.text.trim_end();
            let last = text.chars().next_back().map_or(0, char::len_utf8);
            let range = text.len() - last..text.len();
            return self.refuse(range, "A value is missing behind this.");
        };
        let word = &remaining[..remaining.find(|c| !is_word_char(c)).unwrap_or(remaining.len())];
        let word = if word.is_empty() { &remaining[..sign.len_utf8()] } else { word };
        let sentence =
            refusal::explain_unexpected_token(word).unwrap_or(default_sentence.to_owned());
        self.refuse(self.at..self.at + word.len(), sentence)
    }

    /// Skips blanks; gives the text that is still to be read.
    fn skip_blanks_and_peek(&mut self) -> &'a str {
        let remaining = self.text[self.at..].trim_start();
        self.at = self.text.len() - remaining.len();
        remaining
    }

    /// Whether `word` comes next; a word has to end there.
    fn has_next(&mut self, word: &str) -> bool {
        let remaining = self.skip_blanks_and_peek().strip_prefix(word);
        remaining.is_some_and(|remaining| {
            !(word.ends_with(is_word_char) && remaining.starts_with(is_word_char))
        })
    }

    /// Reads `word`, if it comes next.
    fn skip_if_next(&mut self, word: &str) -> bool {
        let is_next = self.has_next(word);
        self.at += if is_next { word.len() } else { 0 };
        is_next
    }

    /// Reads on while `is_part` holds of the letters.
    fn take_while(&mut self, is_part: impl Fn(char) -> bool) -> &'a str {
        let remaining = &self.text[self.at..];
        let word = &remaining[..remaining.find(|c| !is_part(c)).unwrap_or(remaining.len())];
        self.at += word.len();
        word
    }

    /// Values with operators of this level between them.
    fn parse_operations_of_level(&mut self, level: usize) -> Parsed<Part> {
        let Some(operators) = OPERATORS.get(level) else {
            return self.parse_cast();
        };
        let mut left_value = self.parse_operations_of_level(level + 1)?;
        for count in 0.. {
            self.skip_blanks_and_peek();
            let start = self.at;
            let Some(name) = operators.iter().find(|name| self.skip_if_next(name)) else {
                break;
            };
            let sign = start..self.at;
            if level == COMPARISONS && 0 < count {
                return self.refuse(sign, "Rust compares two at a time: a < b && b < c.");
            }
            let right = self.parse_operations_of_level(level + 1)?;
            left_value = self.build_call(name, sign, vec![left_value, right])?;
        }
        Ok(left_value)
    }

    /// A value, perhaps with `as` behind it.
    fn parse_cast(&mut self) -> Parsed<Part> {
        let mut part = self.parse_value_with_signs_and_methods()?;
        while self.has_next("as") {
            let start = self.at;
            let Some(name) = ["as f64", "as i32"].into_iter().find(|name| self.skip_if_next(name))
            else {
                return self.refuse(start..start + 2, "Behind as: f64 or i32.");
            };
            part = self.build_call(name, start..self.at, vec![part])?;
        }
        Ok(part)
    }

    /// A value with signs before it, and fields and methods behind it.
    fn parse_value_with_signs_and_methods(&mut self) -> Parsed<Part> {
        self.skip_blanks_and_peek();
        let start = self.at;
        if DEPTH < self.depth {
            return self.refuse(start..start + 1, "That's too many inside each other.");
        }
        self.depth += 1;
        let signs = [("-", "-value"), ("!", "!value")];
        let part = match signs.into_iter().find(|(sign, _)| self.skip_if_next(sign)) {
            Some((_, name)) => {
                let value = self.parse_value_with_signs_and_methods()?;
                self.build_call(name, start..start + 1, vec![value])?
            }
            None => self.parse_value_with_methods()?,
        };
        self.depth -= 1;
        Ok(part)
    }

    fn parse_value_with_methods(&mut self) -> Parsed<Part> {
        let mut part = self.parse_atom()?;
        while self.skip_blanks_and_peek().starts_with('.') {
            let start = self.at;
            self.at += 1;
            self.take_while(is_word_char);
            part = self.parse_call_from(start, vec![part])?;
        }
        Ok(part)
    }

    /// The call of the name from `start` to here, with what stands in parentheses behind it,
    /// if they come next.
    fn parse_call_from(&mut self, start: usize, mut arguments: Vec<Part>) -> Parsed<Part> {
        let name = &self.text[start..self.at];
        if !self.has_next("(") {
            return self.build_call(name, start..start + name.len(), arguments);
        }
        let open = self.at;
        self.at += 1;
        while !self.has_next(")") {
            arguments.push(self.parse_operations_of_level(0)?);
            if !self.skip_if_next(",") {
                break;
            }
        }
        self.expect_closing(open)?;
        self.build_call(&format!("{name}()"), start..start + name.len(), arguments)
    }

    /// Reads the parenthesis that closes the one at `open`.
    fn expect_closing(&mut self, open: usize) -> Parsed<()> {
        match self.skip_if_next(")") {
            true => Ok(()),
            false if self.skip_blanks_and_peek().is_empty() => {
                self.refuse(open..open + 1, "The ) for this is missing.")
            }
            false => self.refuse_next_word("Something is missing before this."),
        }
    }

    /// A number, a variable, a call, or what stands in parentheses.
    fn parse_atom(&mut self) -> Parsed<Part> {
        let remaining = self.skip_blanks_and_peek();
        let start = self.at;
        if remaining.starts_with(|c: char| c.is_ascii_digit()) {
            return self.parse_number();
        }
        let variables = self.place.variables.iter().enumerate();
        let variables = variables.filter(|(_, (name, _))| self.has_next(name));
        if let Some((index, (name, kind))) = variables.max_by_key(|(_, (name, _))| name.len()) {
            self.at += name.len();
            let code = Box::new(move |values: &[DVec3]| values[index]);
            return Ok(Part { code, kind: *kind, range: start..self.at });
        }
        if self.skip_if_next("(") {
            let inside = self.parse_operations_of_level(0)?;
            self.expect_closing(start)?;
            return Ok(Part { range: start..self.at, ..inside });
        }
        let first = self.take_while(is_word_char);
        if first.is_empty() || refusal::explain_unexpected_token(first).is_some() {
            self.at = start;
            return self.refuse_next_word("A number, a name or a ( is missing before this.");
        }
        self.take_while(|c| is_word_char(c) || c == ':');
        // What is not known is named whole, but for a method behind it.
        while self.text[self.at..].starts_with('.')
            && signatures_of(&self.text[start..self.at]).next().is_none()
        {
            let end = self.at;
            self.at += 1;
            self.take_while(is_word_char);
            if self.text[self.at..].starts_with('(') {
                self.at = end;
                break;
            }
        }
        self.parse_call_from(start, vec![])
    }

    fn parse_number(&mut self) -> Parsed<Part> {
        let start = self.at;
        self.take_while(|c| c.is_ascii_digit() || c == '_');
        // A point before a name belongs to a method.
        let remaining = &self.text[self.at..];
        if remaining.starts_with('.')
            && !remaining[1..].starts_with(|c| is_word_char(c) && !c.is_ascii_digit())
        {
            self.at += 1;
        }
        self.take_while(is_word_char);
        if self.text[start..self.at].ends_with(['e', 'E']) && self.skip_if_next("-") {
            self.take_while(is_word_char);
        }
        let text = self.text[start..self.at].replace('_', "");
        let (digits, kind) = match (text.strip_suffix("f64"), text.strip_suffix("i32")) {
            (Some(digits), _) => (digits, Kind::Number),
            (_, Some(digits)) => (digits, Kind::Whole),
            _ if text.contains(['.', 'e', 'E']) => (&*text, Kind::Literal),
            _ => (&*text, Kind::Whole),
        };
        let value = match (kind, digits.parse::<f64>(), digits.parse::<i32>()) {
            (Kind::Whole, _, Ok(whole)) => whole.into(),
            (Kind::Number | Kind::Literal, Ok(value), _) => value,
            (_, Ok(_), _) => {
                let sentence = "That's too large for a whole number: write .0 behind it.";
                return self.refuse(start..self.at, sentence);
            }
            _ => return self.refuse(start..self.at, "What number is this?"),
        };
        let code = Box::new(move |_: &[DVec3]| DVec3::splat(value));
        Ok(Part { code, kind, range: start..self.at })
    }

    /// The call of the function `name`, which the words in `range` are.
    fn build_call(&self, name: &str, range: Range<usize>, arguments: Vec<Part>) -> Parsed<Part> {
        let argument_kinds = arguments.iter().map(|one| (one.kind, &self.text[one.range.clone()]));
        let argument_kinds: Vec<_> = argument_kinds.collect();
        let fits = |wanted: &[Kind]| {
            let mut pairs = argument_kinds.iter().zip(wanted);
            argument_kinds.len() == wanted.len()
                && pairs.all(|((kind, _), wanted)| kind.is_accepted_as(*wanted))
        };
        let signature = signatures_of(name).find(|(wanted, ..)| fits(wanted));
        let are_literals = argument_kinds.iter().all(|(kind, _)| *kind == Kind::Literal);
        let kind = match &signature {
            // What is computed from numbers of an open type has an open type, and no methods.
            Some((_, Kind::Number, _)) if are_literals && !name.ends_with(')') => Kind::Literal,
            Some((_, kind, _)) => *kind,
            None => Kind::Number,
        };
        let is_open = name.starts_with('.') && argument_kinds[0].0 == Kind::Literal;
        let Some((.., apply)) = signature.filter(|_| !is_open) else {
            let (argument_index, sentence) =
                refusal::explain_refused_call(name, &argument_kinds, self.place);
            return self.refuse(
                argument_index
                    .map_or(range, |argument_index| arguments[argument_index].range.clone()),
                sentence,
            );
        };
        let start = arguments.first().map_or(range.start, |one| one.range.start);
        let end = self.text[..self.at].trim_end().len();
        let mut codes = arguments.into_iter().map(|one| one.code);
        let code: Code = match (codes.next(), codes.next(), codes.next()) {
            (Some(a), Some(b), Some(c)) => Box::new(move |v| apply([a(v), b(v), c(v)])),
            (Some(a), Some(b), None) => Box::new(move |v| apply([a(v), b(v), DVec3::ZERO])),
            (Some(a), ..) => Box::new(move |v| apply([a(v), DVec3::ZERO, DVec3::ZERO])),
            _ => Box::new(move |_| apply([DVec3::ZERO; 3])),
        };
        Ok(Part { code, kind, range: start.min(range.start)..end })
    }
}
