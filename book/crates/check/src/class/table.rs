//! Aligns text in columns.

/// Formats rows so that each column is as wide as its longest cell.
pub(crate) fn align_columns(rows: &[Vec<String>]) -> String {
    let width = |k: usize| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0);
    let widths: Vec<_> = (0..rows.first().map_or(0, Vec::len)).map(width).collect();
    let line = |row: &Vec<String>| {
        let words = row.iter().zip(&widths).map(|(word, width)| format!("{word:width$}"));
        words.collect::<Vec<_>>().join("  ").trim_end().to_owned() + "\n"
    };
    rows.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_as_wide_as_their_longest_cells() {
        let rows = [["a", "bc", ""], ["öä", "", "d"]].map(|row| row.map(str::to_owned).to_vec());
        assert_eq!(align_columns(&rows), "a   bc\nöä      d\n");
        assert_eq!(align_columns(&[]), "");
    }
}
