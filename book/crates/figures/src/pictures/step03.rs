//! The picture of step 3, with a probe.

use super::pixel_trace::trace_pixel;
use crate::Figure;
use crate::probe::{draw_picture, probed_picture};
use step03_nearest::{OBJECTS, colour};

/// The picture of step 3, with a probe.
pub fn figure() -> Figure {
    Figure {
        readouts: |values| trace_pixel(values, &OBJECTS, |ray| colour(&OBJECTS, ray)),
        row_count: OBJECTS.len(),
        ..probed_picture("step03_nearest", [195.0, 237.0], [], |_, columns| {
            draw_picture(columns, |ray| colour(&OBJECTS, ray))
        })
    }
}
