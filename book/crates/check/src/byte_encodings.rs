use crate::evidence::Evidence;
use crate::explanation::Explanation;
use crate::step_scene::{intensity_function, scene_of_step};
use std::rc::Rc;

/// Files in which intensities become bytes.
const FILES: [&str; 2] = ["step01_rays/rgb8.rs", "step01_rays/render.rs"];

/// A number that is cut off to a byte, of an intensity I.
type Encoding = fn(f64) -> f64;

/// Other encodings of an intensity I than `rgb8`, each with its words in a sentence.
const ENCODINGS: [(&str, Encoding); 22] = [
    ("255·I cut off, not rounded", |i| 255.0 * i),
    ("255.99·I cut off", |i| 255.99 * i),
    ("255.999·I cut off", |i| 255.999 * i),
    ("256·I cut off", |i| 256.0 * i),
    ("256·I cut off, with I at most 0.999", |i| 256.0 * i.min(0.999)),
    ("256·I rounded", |i| 256.0 * i + 0.5),
    ("255·I rounded up", |i| (255.0 * i).ceil()),
    ("I itself, without the factor 255", |i| i),
    ("I itself rounded, without the factor 255", |i| i + 0.5),
    ("255·I/2", |i| 127.5 * i + 0.5),
    ("255·2I", |i| 510.0 * i + 0.5),
    ("255·√I (gamma 2)", |i| 255.0 * i.sqrt() + 0.5),
    ("255·√I (gamma 2), cut off", |i| 255.0 * i.sqrt()),
    ("255.999·√I (gamma 2), cut off", |i| 255.999 * i.sqrt()),
    ("256·√I (gamma 2), with √I at most 0.999", |i| 256.0 * i.sqrt().min(0.999)),
    ("255·I^(1/2.2) (gamma)", |i| 255.0 * i.powf(1.0 / 2.2) + 0.5),
    ("255·I^(1/2.2) (gamma), cut off", |i| 255.0 * i.powf(1.0 / 2.2)),
    ("255·I^2.2, gamma the wrong way round", |i| 255.0 * i.powf(2.2) + 0.5),
    ("255·I², gamma the wrong way round", |i| 255.0 * i * i + 0.5),
    ("255·(1 − I), a negative", |i| 255.0 * (1.0 - i) + 0.5),
    ("255·I rounded, but what is above 255 begins again at 0", |i| {
        (255.0 * i + 0.5).trunc() % 256.0
    }),
    ("255·I cut off, and what is above 255 begins again at 0", |i| (255.0 * i).trunc() % 256.0),
];

/// Explanations, not yet tried, by another encoding than `rgb8`.
pub(crate) fn encoding_candidates(evidence: &Evidence) -> impl Iterator<Item = Explanation<'_>> {
    evidence.step.into_iter().flat_map(move |step| {
        let intensity = Rc::new(intensity_function(step, &scene_of_step(step)));
        ENCODINGS.into_iter().map(move |(words, encode)| {
            let intensity = intensity.clone();
            let sentence = format!("Each byte of your picture is {words}.");
            Explanation::exact(sentence, &FILES, move |pixel| {
                let intensity = intensity(&evidence.our_ray(pixel));
                intensity.to_array().map(|i| encode(i) as u8)
            })
        })
    })
}
