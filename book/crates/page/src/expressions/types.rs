/// A type of Rust whose values a line may compute with.
#[derive(Clone, Debug, PartialEq)]
pub enum Type {
    F64,
    I32,
    U32,
    Usize,
    Bool,
    DVec3,
    Attenuation,
    /// The value of a block that ends with a semicolon.
    Unit,
    Array(Box<Type>, usize),
    Reference(Box<Type>),
    /// A number such as 2 or 2.0, whose type depends on what it meets; its index in [`Types`].
    Open(usize),
}

impl Type {
    const NAMES: [(&str, Self); 7] = [
        ("f64", Self::F64),
        ("i32", Self::I32),
        ("u32", Self::U32),
        ("usize", Self::Usize),
        ("bool", Self::Bool),
        ("DVec3", Self::DVec3),
        ("Attenuation", Self::Attenuation),
    ];

    /// The type of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::NAMES.into_iter().find(|(one, _)| *one == name).map(|(_, kind)| kind)
    }

    /// Its name in Rust, if it is one of those above.
    pub fn name(&self) -> Option<&'static str> {
        Self::NAMES.into_iter().find(|(_, kind)| kind == self).map(|(name, _)| name)
    }

    /// Itself, or what a reference to a reference … refers to.
    pub fn referent(&self) -> &Self {
        if let Self::Reference(inner) = self { inner.referent() } else { self }
    }

    /// Whether it is a number or a truth, of which Rust has no parts.
    pub fn is_plain(&self) -> bool {
        matches!(self, Self::F64 | Self::Bool) || self.is_whole()
    }

    pub fn is_whole(&self) -> bool {
        matches!(self, Self::I32 | Self::U32 | Self::Usize)
    }
}

/// Types of the numbers of a text that don't say their own. A text is read twice: first to find
/// them, then, when they are closed, to compile it.
#[derive(Default)]
pub struct Types {
    /// Whether the number has a fraction, and its type once that is known.
    numbers: Vec<(bool, Option<Type>)>,
    /// How many of them have been read.
    next: usize,
    /// Whether all are known.
    pub are_closed: bool,
}

impl Types {
    /// The type of the next number that doesn't say its own.
    pub fn next_number(&mut self, has_fraction: bool) -> Type {
        let index = self.next;
        self.next += 1;
        if index == self.numbers.len() {
            self.numbers.push((has_fraction, None));
        }
        self.resolve(&Type::Open(index))
    }

    /// The type with all that is known of it by now.
    pub fn resolve(&self, kind: &Type) -> Type {
        match kind {
            Type::Open(index) => match &self.numbers[*index].1 {
                Some(known) => self.resolve(known),
                None => kind.clone(),
            },
            Type::Array(item, length) => Type::Array(Box::new(self.resolve(item)), *length),
            Type::Reference(inner) => Type::Reference(Box::new(self.resolve(inner))),
            _ => kind.clone(),
        }
    }

    /// Makes two types the same, if they can be.
    pub fn unify(&mut self, one: &Type, other: &Type) -> bool {
        match (self.resolve(one), self.resolve(other)) {
            (Type::Array(one, length), Type::Array(other, other_length)) => {
                length == other_length && self.unify(&one, &other)
            }
            (Type::Reference(one), Type::Reference(other)) => self.unify(&one, &other),
            (one, other) if one == other => true,
            (Type::Open(index), other) | (other, Type::Open(index)) => {
                let fits = self.fits(&Type::Open(index), &other);
                if fits {
                    self.numbers[index].1 = Some(other);
                }
                fits
            }
            _ => false,
        }
    }

    /// Whether a value may stand where another type is wanted, which may make its own known.
    pub fn fits(&self, kind: &Type, wanted: &Type) -> bool {
        match (self.resolve(kind), wanted) {
            (Type::Open(index), Type::Open(other)) => {
                self.numbers[index].0 == self.numbers[*other].0
            }
            (Type::Open(index), wanted) if self.numbers[index].0 => *wanted == Type::F64,
            (Type::Open(_), wanted) => wanted.is_whole(),
            (kind, wanted) => kind == *wanted,
        }
    }

    /// Whether a type is, or will be, that of a whole number.
    pub fn is_whole(&self, kind: &Type) -> bool {
        match self.resolve(kind) {
            Type::Open(index) => !self.numbers[index].0,
            kind => kind.is_whole(),
        }
    }

    /// Gives the numbers that are still open the types that Rust gives them, and begins anew.
    pub fn close(&mut self) {
        for (has_fraction, kind) in &mut self.numbers {
            kind.get_or_insert(if *has_fraction { Type::F64 } else { Type::I32 });
        }
        (self.next, self.are_closed) = (0, true);
    }

    /// What a reader calls it.
    pub fn describe(&self, kind: &Type) -> String {
        let name = match self.resolve(kind) {
            Type::Array(_, length) => return format!("an array of {length}"),
            Type::Reference(inner) => return format!("a reference to {}", self.describe(&inner)),
            Type::F64 => "a number",
            Type::Open(index) if self.numbers[index].0 => "a number",
            Type::Open(_) | Type::I32 => "a whole number",
            Type::U32 | Type::Usize => "a whole number from 0 on",
            Type::Bool => "true or false",
            Type::DVec3 => "a vector",
            Type::Attenuation => "an attenuation",
            Type::Unit => "nothing",
        };
        name.to_owned()
    }
}
