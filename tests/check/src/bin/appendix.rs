//! Writes the gallery's appendix of the book to standard output.

fn main() {
    print!("{}", check::appendix());
}
