//! What several figures draw with.

pub mod ball_outlines;
pub mod view_pyramid;
