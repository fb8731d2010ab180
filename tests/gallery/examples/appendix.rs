//! Writes the gallery's appendix of the book to standard output.

fn main() {
    print!("{}", gallery::appendix());
}
