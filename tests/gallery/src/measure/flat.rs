use super::words::vector;
use super::{Look, Place, Stage, Verdict, nearest};
use crate::{Step, section};
use image::Rgb;
use std::collections::HashMap;

/// The stages after the outlines where each object has one flat colour.
pub(super) fn stages(look: &Look, places: &[Place]) -> Vec<Stage> {
    let (verdict, numbers) = colours(look, places);
    let section = match look.step {
        Step::Sphere => section::ONE_COLOUR,
        _ => section::SCENE,
    };
    let colours = Stage { name: "colours", verdict, numbers, section, test: None };
    match look.step {
        Step::Sphere => vec![colours],
        _ => vec![nearest::stage(look, places), colours],
    }
}

/// What is told of the colours of the objects.
fn colours(look: &Look, places: &[Place]) -> (Verdict, Vec<String>) {
    let objects = look.theirs.objects(look.step);
    let found =
        (0..objects.len()).filter_map(|k| Some((k, usual(look, places, k)?)));
    let found: Vec<_> = found.collect();
    let is_known = |(k, yours): &(usize, Rgb<u8>)| {
        let ours = objects[*k].material.material.surface.diffuse;
        look.bytes.write(ours) == *yours
    };
    let numbers: Vec<_> = (found.iter())
        .filter(|one| !is_known(one) && is_odd(look, places, one))
        .map(|(k, yours)| {
            format!(
                "{} is {} in your picture, {:?}; it should be {}",
                objects[*k].material.name,
                vector(look.bytes.read(yours)),
                yours.0,
                vector(objects[*k].material.material.surface.diffuse)
            )
        })
        .collect();
    match numbers.is_empty() {
        true if found.is_empty() => {
            (Verdict::Unknown("no object is seen".to_owned()), numbers)
        }
        true if found.iter().all(is_known) => match odd(look, places) {
            0 => (Verdict::Right, numbers),
            odd => {
                let why = format!("{odd} pixels of objects have another colour");
                (Verdict::Unknown(why), numbers)
            }
        },
        true => {
            (Verdict::Unknown("another object is in its place".to_owned()), numbers)
        }
        false => (Verdict::Wrong, numbers),
    }
}

/// How many pixels of objects have the colour of none.
fn odd(look: &Look, places: &[Place]) -> usize {
    let is_odd = |p: &&Place| {
        let is_mixed = look.is_loose() && look.is_edge(p.i, p.j);
        nearest::shown(look, p).is_none() && !is_mixed
    };
    places.iter().filter(|p| p.hit.is_some() && !p.is_sky).filter(is_odd).count()
}

/// The colour that most pixels of an object have, if they are many.
fn usual(look: &Look, places: &[Place], k: usize) -> Option<Rgb<u8>> {
    let mut counts = HashMap::new();
    let its = places.iter().filter(|p| p.hit == Some(k) && !p.is_sky);
    its.for_each(|p| {
        *counts.entry(*look.yours.get_pixel(p.i, p.j)).or_insert(0) += 1
    });
    let all: usize = counts.values().sum();
    let (colour, count) =
        counts.into_iter().max_by_key(|(colour, n)| (*n, colour.0))?;
    (all < 2 * count).then_some(colour)
}

/// Whether a colour is that of no object that the rays to this one meet.
fn is_odd(look: &Look, places: &[Place], (k, yours): &(usize, Rgb<u8>)) -> bool {
    let objects = look.theirs.objects(look.step);
    let Some(other) = objects.iter().find(|object| {
        look.bytes.write(object.material.material.surface.diffuse) == *yours
    }) else {
        return true;
    };
    let its = places
        .iter()
        .filter(|p| p.hit == Some(*k) && look.yours.get_pixel(p.i, p.j) == yours);
    its.take(2000).any(|p| {
        let ray = (look.theirs.ray)(look.theirs.camera.ray(p.i.into(), p.j.into()));
        other.sphere.intersect(&ray).first_hit().is_none()
    })
}
