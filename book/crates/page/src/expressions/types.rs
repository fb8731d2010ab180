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
    /// A number such as 2.0, or a sum of such, which has no methods yet.
    OpenF64,
    /// The same of i32, such as 2 + 3.
    OpenI32,
    /// A number such as 2, which becomes an i32, a u32 or a usize by what it meets.
    OpenWhole,
    /// The value of a block that ends with a semicolon.
    Unit,
    Array(Box<Type>, usize),
    Reference(Box<Type>),
}

/// The types that have a name, each with that name.
const NAMES: [(Type, &str); 7] = [
    (Type::F64, "f64"),
    (Type::I32, "i32"),
    (Type::U32, "u32"),
    (Type::Usize, "usize"),
    (Type::Bool, "bool"),
    (Type::DVec3, "DVec3"),
    (Type::Attenuation, "Attenuation"),
];

impl Type {
    /// The type of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        NAMES.into_iter().find(|row| row.1 == name).map(|row| row.0)
    }

    /// The name of a type that has one; otherwise empty.
    pub fn name(&self) -> &'static str {
        NAMES.into_iter().find(|row| row.0 == *self).map_or("", |row| row.1)
    }

    /// Itself, or what a reference to a reference … refers to.
    pub fn referent(&self) -> &Self {
        if let Self::Reference(inner) = self { inner.referent() } else { self }
    }

    pub fn is_whole(&self) -> bool {
        matches!(self, Self::I32 | Self::U32 | Self::Usize | Self::OpenI32 | Self::OpenWhole)
    }

    /// Whether it is a number, but no whole one.
    pub fn is_real(&self) -> bool {
        matches!(self, Self::F64 | Self::OpenF64)
    }

    /// Whether Rust has operators between two of this type, and no other of these.
    pub fn is_plain(&self) -> bool {
        self.is_whole() || self.is_real() || *self == Self::Bool
    }

    /// Whether a value of this type may stand where another is wanted.
    pub fn fits(&self, wanted: &Self) -> bool {
        match (self, wanted) {
            (Self::OpenF64, wanted) => wanted.is_real(),
            (Self::OpenI32, wanted) => matches!(wanted, Self::I32 | Self::OpenI32),
            (Self::OpenWhole, wanted) => wanted.is_whole(),
            (Self::Array(one, length), Self::Array(other, other_length)) => {
                length == other_length && one.fits(other)
            }
            (Self::Reference(one), Self::Reference(other)) => one.fits(other),
            _ => self == wanted,
        }
    }

    /// The type that all these have together, if they have one.
    pub fn join<'a>(mut kinds: impl Iterator<Item = &'a Self>) -> Option<Self> {
        let mut all = kinds.next()?;
        for kind in kinds {
            all = if all.fits(kind) { Some(kind) } else { kind.fits(all).then_some(all) }?;
        }
        Some(if *all == Self::OpenWhole { Self::OpenI32 } else { all.clone() })
    }

    /// Words for it that a reader knows.
    pub fn describe(&self) -> String {
        let words = match self {
            Self::F64 | Self::OpenF64 => "a number",
            Self::I32 | Self::OpenI32 | Self::OpenWhole => "a whole number",
            Self::U32 => "a u32",
            Self::Usize => "a usize",
            Self::Bool => "true or false",
            Self::DVec3 => "a vector",
            Self::Attenuation => "an attenuation",
            Self::Unit => "nothing",
            Self::Array(_, length) => return format!("an array of {length}"),
            Self::Reference(inner) => return format!("a reference to {}", inner.describe()),
        };
        words.to_owned()
    }
}
