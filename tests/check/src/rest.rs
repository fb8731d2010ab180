/// How far the pixels of a picture are from those of another: what a cause leaves
/// unexplained.
#[derive(Clone, Debug)]
pub struct Rest {
    /// How many pixels are off by 0, by 1, by 2 and so on, in the channel that differs
    /// most.
    counts: [usize; 256],
    /// How many pixels there are; not all are compared where that takes very many rays.
    pub all: usize,
}

/// One in so many pixels is few.
const FEW: usize = 1000;

impl Rest {
    /// That of a picture of so many pixels, none of which is compared yet.
    pub fn new(all: usize) -> Self {
        Self { counts: [0; 256], all }
    }

    /// Counts one pixel that is off by so much.
    pub fn add(&mut self, apart: u8) {
        self.counts[usize::from(apart)] += 1;
    }

    /// How many pixels were compared.
    pub fn compared(&self) -> usize {
        self.counts.iter().sum()
    }

    /// Whether the pictures are known to be equal in every pixel.
    pub fn is_none(&self) -> bool {
        self.beyond(0) == 0 && self.compared() == self.all
    }

    /// How many pixels are farther apart than by `rounding`.
    pub fn beyond(&self, rounding: u8) -> usize {
        self.counts[usize::from(rounding) + 1..].iter().sum()
    }

    /// How far apart two pixels are at most.
    pub fn most(&self) -> u8 {
        let off = self.counts.iter().rposition(|&count| 0 < count);
        off.unwrap_or(0) as u8
    }

    /// How many of so many pixels are few.
    pub fn few_of(all: usize) -> usize {
        all / FEW
    }

    /// Whether few pixels are farther apart than by `rounding`.
    pub fn is_few(&self, rounding: u8) -> bool {
        self.beyond(rounding) <= Self::few_of(self.compared())
    }
}
