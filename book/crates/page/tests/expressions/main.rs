//! Places as they stand draw the locked pictures, and what Rust would refuse is refused. That an
//! edited place draws what the compiler's program draws is tested in book/update.

mod refused;
mod unedited_places;
