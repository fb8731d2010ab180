use image::RgbImage;

/// Columns or rows in which nothing is drawn.
pub(super) struct Black {
    /// What is told of them.
    pub told: String,
    columns: Vec<bool>,
    rows: Vec<bool>,
}

impl Black {
    /// Those of a picture that are black although others are not.
    pub fn of(yours: &RgbImage) -> Option<Self> {
        let (width, height) = yours.dimensions();
        let is_black = |i: u32, j: u32| yours.get_pixel(i, j).0 == [0; 3];
        let blacks = |i: u32| (0..height).filter(|j| is_black(i, *j)).count();
        let columns: Vec<_> = (0..width).map(blacks).collect();
        let blacks = |j: u32| (0..width).filter(|i| is_black(*i, j)).count();
        let rows: Vec<_> = (0..height).map(blacks).collect();
        let [of_columns, of_rows] =
            [("column", &columns, height), ("row", &rows, width)]
                .map(|(what, counts, all)| told(what, counts, all as usize));
        let none = |lines: &[usize]| vec![false; lines.len()];
        let whole = |counts: &[usize], all: u32| -> Vec<_> {
            counts.iter().map(|count| *count == all as usize).collect()
        };
        match (of_columns, of_rows) {
            (Some(told), _) => Some(Self {
                told,
                columns: whole(&columns, height),
                rows: none(&rows),
            }),
            (None, Some(told)) => Some(Self {
                told,
                columns: none(&columns),
                rows: whole(&rows, width),
            }),
            _ => None,
        }
    }

    /// Whether a pixel is in one of them.
    pub fn has(&self, (i, j): (u32, u32)) -> bool {
        self.columns[i as usize] || self.rows[j as usize]
    }
}

/// Which of many lines are black, in words, from how many pixels of each are; only
/// where they are at one end, or every so many-th is not.
fn told(what: &str, counts: &[usize], all: usize) -> Option<String> {
    let is_drawn = |k: &usize| counts[*k] < all;
    let drawn: Vec<_> = (0..counts.len()).filter(is_drawn).collect();
    let (first, last, end) = (*drawn.first()?, *drawn.last()?, counts.len() - 1);
    let by = drawn.get(1)? - first;
    if drawn.len() == counts.len() {
        return None;
    }
    if 1 < by && drawn.windows(2).all(|two| two[1] - two[0] == by) {
        let start = format!("from {what} {first} on");
        return Some(format!("only one {what} of {by} is drawn, {start}"));
    }
    // A black sky has pixels in the next line, too.
    let is_edge = |k: usize| counts[k] * 20 < all;
    let is_whole = last - first + 1 == drawn.len();
    let nothing = "nothing is drawn there";
    let lines = |which: &str, start: usize, end: usize| match end - start {
        0 => format!("the {which} {what}, {what} {start}, is black: {nothing}"),
        more => format!(
            "the {which} {} {what}s, {start} to {end}, are black: {nothing}",
            more + 1
        ),
    };
    match (is_whole, first, last) {
        (true, 0, last) if is_edge(last) => Some(lines("last", last + 1, end)),
        (true, 1.., last) if last == end && is_edge(first) => {
            Some(lines("first", 0, first - 1))
        }
        _ => None,
    }
}
