use crate::functions::signatures;
use crate::{Kind, Place, refusal};
use glam::DVec3;
use std::ops::Range;

/// What a reader's text means: a function of the variables of its place.
pub struct Expression(Code);

type Code = Box<dyn Fn(&[DVec3]) -> DVec3 + Send + Sync>;

impl Expression {
    /// Its value where the variables have these.
    pub fn evaluate(&self, variables: &[DVec3]) -> DVec3 {
        self.0(variables)
    }
}

/// What is wrong with a text.
#[derive(Clone, Debug, PartialEq)]
pub struct Mistake {
    /// Where, in bytes.
    pub range: Range<usize>,
    /// What, in one or two sentences.
    pub sentence: String,
}

/// The most bytes of a text: that bounds the time of a picture.
const LENGTH: usize = 400;

/// The most parts inside each other.
const DEPTH: usize = 40;

/// What stands between two values, the loosest first.
const OPERATORS: [&[&str]; 5] = [
    &["||"],
    &["&&"],
    &["==", "!=", "<=", ">=", "<", ">"],
    &["+", "-"],
    &["*", "/", "%"],
];

/// The level of those that compare.
const COMPARISONS: usize = 2;

/// Reads what a reader wrote at a place.
pub fn parse(place: &Place, text: &str) -> Result<Expression, Mistake> {
    let mut parser = Parser { place, text, at: 0, depth: 0 };
    if LENGTH < text.len() {
        return parser
            .refuse(0..text.len(), "That's longer than a line should be.");
    }
    let part = parser.parse_operation(0)?;
    if !parser.skip_blanks().is_empty() {
        return parser
            .refuse_next("Something is missing before this, such as * or +.");
    }
    if !part.kind.fits(place.kind) {
        let result = &text[part.range.clone()];
        let sentence = refusal::explain_result(result, part.kind, place.kind);
        return parser.refuse(part.range, sentence);
    }
    Ok(Expression(part.code))
}

/// A part of a text that has a value.
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

type Parsed<T> = Result<T, Mistake>;

/// Whether a letter may be in a name.
pub fn is_word(c: char) -> bool {
    c.is_alphabetic() || c.is_ascii_digit() || c == '_'
}

impl<'a> Parser<'a> {
    fn refuse<T>(
        &self,
        at: Range<usize>,
        sentence: impl Into<String>,
    ) -> Parsed<T> {
        Err(Mistake { range: at, sentence: sentence.into() })
    }

    /// Refuses the word or the sign that comes next, or the end of the text.
    fn refuse_next<T>(&mut self, otherwise: &str) -> Parsed<T> {
        let rest = self.skip_blanks();
        let Some(sign) = rest.chars().next() else {
            let text = self.text.trim_end();
            let last = text.chars().next_back().map_or(0, char::len_utf8);
            let range = text.len() - last..text.len();
            return self.refuse(range, "A value is missing behind this.");
        };
        let word = &rest[..rest.find(|c| !is_word(c)).unwrap_or(rest.len())];
        let word = if word.is_empty() { &rest[..sign.len_utf8()] } else { word };
        let sentence = refusal::explain_word(word).unwrap_or(otherwise.to_owned());
        self.refuse(self.at..self.at + word.len(), sentence)
    }

    /// What is still to be read, from the next sign on.
    fn skip_blanks(&mut self) -> &'a str {
        let rest = self.text[self.at..].trim_start();
        self.at = self.text.len() - rest.len();
        rest
    }

    /// Whether `what` comes next; a word has to end there.
    fn is_next(&mut self, what: &str) -> bool {
        let rest = self.skip_blanks().strip_prefix(what);
        rest.is_some_and(|rest| {
            !(what.ends_with(is_word) && rest.starts_with(is_word))
        })
    }

    /// Reads `what`, if it comes next.
    fn read(&mut self, what: &str) -> bool {
        let is_next = self.is_next(what);
        self.at += if is_next { what.len() } else { 0 };
        is_next
    }

    /// Reads as far as letters are such, from here.
    fn read_while(&mut self, is_part: impl Fn(char) -> bool) -> &'a str {
        let rest = &self.text[self.at..];
        let word = &rest[..rest.find(|c| !is_part(c)).unwrap_or(rest.len())];
        self.at += word.len();
        word
    }

    /// Values with operators of this level between them.
    fn parse_operation(&mut self, level: usize) -> Parsed<Part> {
        let Some(operators) = OPERATORS.get(level) else {
            return self.parse_cast();
        };
        let mut left = self.parse_operation(level + 1)?;
        for count in 0.. {
            self.skip_blanks();
            let start = self.at;
            let Some(name) = operators.iter().find(|name| self.read(name)) else {
                break;
            };
            let sign = start..self.at;
            if level == COMPARISONS && 0 < count {
                return self
                    .refuse(sign, "Rust compares two at a time: a < b && b < c.");
            }
            let right = self.parse_operation(level + 1)?;
            left = self.build_call(name, sign, vec![left, right])?;
        }
        Ok(left)
    }

    /// A value, perhaps with `as` behind it.
    fn parse_cast(&mut self) -> Parsed<Part> {
        let mut part = self.parse_signed()?;
        while self.is_next("as") {
            let start = self.at;
            let Some(name) =
                ["as f64", "as i32"].into_iter().find(|name| self.read(name))
            else {
                return self.refuse(start..start + 2, "Behind as: f64 or i32.");
            };
            part = self.build_call(name, start..self.at, vec![part])?;
        }
        Ok(part)
    }

    /// A value with signs before it, and fields and methods behind it.
    fn parse_signed(&mut self) -> Parsed<Part> {
        self.skip_blanks();
        let start = self.at;
        if DEPTH < self.depth {
            return self
                .refuse(start..start + 1, "That's too many inside each other.");
        }
        self.depth += 1;
        let signs = [("-", "-value"), ("!", "!value")];
        let part = match signs.into_iter().find(|(sign, _)| self.read(sign)) {
            Some((_, name)) => {
                let value = self.parse_signed()?;
                self.build_call(name, start..start + 1, vec![value])?
            }
            None => self.parse_methods()?,
        };
        self.depth -= 1;
        Ok(part)
    }

    fn parse_methods(&mut self) -> Parsed<Part> {
        let mut part = self.parse_value()?;
        while self.skip_blanks().starts_with('.') {
            let start = self.at;
            self.at += 1;
            self.read_while(is_word);
            part = self.parse_arguments(start, vec![part])?;
        }
        Ok(part)
    }

    /// The call of the name from `start` to here, with what stands in parentheses behind it,
    /// if they come next.
    fn parse_arguments(
        &mut self,
        start: usize,
        mut arguments: Vec<Part>,
    ) -> Parsed<Part> {
        let name = &self.text[start..self.at];
        if !self.is_next("(") {
            return self.build_call(name, start..start + name.len(), arguments);
        }
        let open = self.at;
        self.at += 1;
        while !self.is_next(")") {
            arguments.push(self.parse_operation(0)?);
            if !self.read(",") {
                break;
            }
        }
        self.read_closing(open)?;
        self.build_call(&format!("{name}()"), start..start + name.len(), arguments)
    }

    /// Reads the parenthesis that closes the one at `open`.
    fn read_closing(&mut self, open: usize) -> Parsed<()> {
        match self.read(")") {
            true => Ok(()),
            false if self.skip_blanks().is_empty() => {
                self.refuse(open..open + 1, "The ) for this is missing.")
            }
            false => self.refuse_next("Something is missing before this."),
        }
    }

    /// A number, a variable, a call, or what stands in parentheses.
    fn parse_value(&mut self) -> Parsed<Part> {
        let rest = self.skip_blanks();
        let start = self.at;
        if rest.starts_with(|c: char| c.is_ascii_digit()) {
            return self.parse_number();
        }
        let variables = self.place.variables.iter().enumerate();
        let variables = variables.filter(|(_, (name, _))| self.is_next(name));
        if let Some((index, (name, kind))) =
            variables.max_by_key(|(_, (name, _))| name.len())
        {
            self.at += name.len();
            let code = Box::new(move |values: &[DVec3]| values[index]);
            return Ok(Part { code, kind: *kind, range: start..self.at });
        }
        if self.read("(") {
            let inside = self.parse_operation(0)?;
            self.read_closing(start)?;
            return Ok(Part { range: start..self.at, ..inside });
        }
        let first = self.read_while(is_word);
        if first.is_empty() || refusal::explain_word(first).is_some() {
            self.at = start;
            return self
                .refuse_next("A number, a name or a ( is missing before this.");
        }
        self.read_while(|c| is_word(c) || c == ':');
        // What is not known is named whole, but for a method behind it.
        while self.text[self.at..].starts_with('.')
            && signatures(&self.text[start..self.at]).next().is_none()
        {
            let end = self.at;
            self.at += 1;
            self.read_while(is_word);
            if self.text[self.at..].starts_with('(') {
                self.at = end;
                break;
            }
        }
        self.parse_arguments(start, vec![])
    }

    fn parse_number(&mut self) -> Parsed<Part> {
        let start = self.at;
        self.read_while(|c| c.is_ascii_digit() || c == '_');
        // A point before a name belongs to a method.
        let rest = &self.text[self.at..];
        if rest.starts_with('.')
            && !rest[1..].starts_with(|c| is_word(c) && !c.is_ascii_digit())
        {
            self.at += 1;
        }
        self.read_while(is_word);
        if self.text[start..self.at].ends_with(['e', 'E']) && self.read("-") {
            self.read_while(is_word);
        }
        let text = self.text[start..self.at].replace('_', "");
        let (digits, kind) =
            match (text.strip_suffix("f64"), text.strip_suffix("i32")) {
                (Some(digits), _) => (digits, Kind::Number),
                (_, Some(digits)) => (digits, Kind::Whole),
                _ if text.contains(['.', 'e', 'E']) => (&*text, Kind::Literal),
                _ => (&*text, Kind::Whole),
            };
        let value = match (kind, digits.parse::<f64>(), digits.parse::<i32>()) {
            (Kind::Whole, _, Ok(whole)) => whole.into(),
            (Kind::Number | Kind::Literal, Ok(value), _) => value,
            (_, Ok(_), _) => {
                let sentence =
                    "That's too large for a whole number: write .0 behind it.";
                return self.refuse(start..self.at, sentence);
            }
            _ => return self.refuse(start..self.at, "What number is this?"),
        };
        let code = Box::new(move |_: &[DVec3]| DVec3::splat(value));
        Ok(Part { code, kind, range: start..self.at })
    }

    /// The call of what is named so, by the words in `range`.
    fn build_call(
        &self,
        name: &str,
        range: Range<usize>,
        arguments: Vec<Part>,
    ) -> Parsed<Part> {
        let is =
            arguments.iter().map(|one| (one.kind, &self.text[one.range.clone()]));
        let is: Vec<_> = is.collect();
        let fits = |wanted: &[Kind]| {
            let mut pairs = is.iter().zip(wanted);
            is.len() == wanted.len()
                && pairs.all(|((kind, _), wanted)| kind.fits(*wanted))
        };
        let found = signatures(name).find(|(wanted, ..)| fits(wanted));
        let are_literals = is.iter().all(|(kind, _)| *kind == Kind::Literal);
        let kind = match &found {
            // What is computed from numbers of an open type has an open type, and no methods.
            Some((_, Kind::Number, _)) if are_literals && !name.ends_with(')') => {
                Kind::Literal
            }
            Some((_, kind, _)) => *kind,
            None => Kind::Number,
        };
        let is_open = name.starts_with('.') && is[0].0 == Kind::Literal;
        let Some((.., apply)) = found.filter(|_| !is_open) else {
            let (at, sentence) = refusal::explain_call(name, &is, self.place);
            return self.refuse(
                at.map_or(range, |at| arguments[at].range.clone()),
                sentence,
            );
        };
        let start = arguments.first().map_or(range.start, |one| one.range.start);
        let end = self.text[..self.at].trim_end().len();
        let mut codes = arguments.into_iter().map(|one| one.code);
        let code: Code = match (codes.next(), codes.next(), codes.next()) {
            (Some(a), Some(b), Some(c)) => {
                Box::new(move |v| apply([a(v), b(v), c(v)]))
            }
            (Some(a), Some(b), None) => {
                Box::new(move |v| apply([a(v), b(v), DVec3::ZERO]))
            }
            (Some(a), ..) => {
                Box::new(move |v| apply([a(v), DVec3::ZERO, DVec3::ZERO]))
            }
            _ => Box::new(move |_| apply([DVec3::ZERO; 3])),
        };
        Ok(Part { code, kind, range: start.min(range.start)..end })
    }
}
