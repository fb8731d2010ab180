//! What a reader's expression draws is what the compiler's program draws, and what Rust would
//! refuse is refused.

mod drawn;
mod refused;
