use super::{asked, chain, picture};
use crate::figures::from_above;
use crate::live::Live;
use step03_nearest::{OBJECTS, colour};

/// The picture of step 3, with a pixel to ask.
pub const STEP03: Live = Live {
    name: "step03_nearest",
    knobs: &[asked::COLUMN, asked::ROW, asked::COLUMNS],
    handles: &[asked::PIXEL],
    is_allowed: |values| asked::camera(values[2]).is_ok(),
    sight: |values| {
        let objects = OBJECTS;
        picture(&asked::seen(values[2]), |ray| colour(&objects, ray))
    },
    numbers: |values| {
        let objects = OBJECTS;
        chain::chain(values, &objects, |_| vec![], |ray| colour(&objects, ray))
    },
    beside: Some(("from-above", from_above)),
};
