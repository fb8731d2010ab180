use super::Verdict;
use super::table::Row;
use super::view::places;
use crate::formula::{Change, Context, Node, Op, Pixel, Tree, Values, batch};
use crate::{Options, each};
use image::RgbImage;

/// Right where the picture would be another one if the stage were; else it can't be
/// told.
pub(super) fn verdict(
    tree: &Tree,
    row: &Row,
    view: &Options,
    yours: &RgbImage,
) -> Verdict {
    let places = places(yours, None);
    let step = places.len() * view.samples.pow(2) as usize / 1500 + 1;
    let places: Vec<_> = places.iter().step_by(step).copied().collect();
    let changes = other(tree, row);
    let contexts = [Context::plain(tree), Context::new(tree, &changes, 0.0.into())];
    let is_shown = places.chunks(batch(view.samples)).any(|places| {
        let values = Values::at(tree, places, view.samples);
        let [ours, other] =
            contexts.each_ref().map(|its| values.changed(its).pixels());
        ours != other
    });
    match is_shown {
        false => hidden(),
        true => Verdict::Right,
    }
}

/// Whether the rays of some pixels meet something.
pub(super) fn hits(tree: &Tree, yours: &RgbImage) -> Vec<bool> {
    let context = Context::plain(tree);
    let places = places(yours, None);
    let places: Vec<_> =
        places.iter().step_by(places.len() / 8000 + 1).copied().collect();
    let hits = |places: &[Pixel]| {
        let values = Values::at(tree, places, 1);
        let values = values.changed(&context);
        let nearest = values.name(tree.nearest, 0);
        Some(
            (0..places.len()).map(|k| 0.0 <= nearest.scalar(k)).collect::<Vec<_>>(),
        )
    };
    each(places.chunks(batch(1)).collect(), hits).concat()
}

/// The picture would be the same if the stage were wrong.
pub(super) fn hidden() -> Verdict {
    Verdict::Unknown("nothing in this picture shows it".to_owned())
}

/// A stage with another formula or number.
fn other(tree: &Tree, Row { stage, light, .. }: &Row) -> Vec<Change> {
    let (names, factor): (&[&str], f64) = match (*stage, light) {
        ("rays", _) => (&["h"], 1.2),
        ("sky", _) => (&["sky"], 0.8),
        ("outlines", _) => (&["radius"], 1.1),
        ("nearest", _) => (&["order"], -1.0),
        ("point", _) => (&["n"], 0.8),
        ("colours", _) => (&["colour'"], 0.8),
        ("ambient", _) => (&["I_a"], 0.8),
        ("attenuation", _) => (&["fade"], 1.3),
        ("diffuse", _) => (&["L_d"], 0.7),
        ("specular", _) => (&["L_s"], 0.7),
        _ => (&["M"], 0.8),
    };
    let lines = names.iter().filter_map(|name| tree.find(name));
    lines
        .map(|line| match (&tree.lines[line].node, light) {
            (Some(node), _) => {
                let factor = Node::Number(factor);
                Change::Line(line, Node::of(Op::Mul, [node.clone(), factor]))
            }
            (None, light) => {
                let which = light.unwrap_or(0);
                let value = tree.lines[line].given[which].map(|x| factor * x);
                Change::Given(line, which, value)
            }
        })
        .collect()
}
