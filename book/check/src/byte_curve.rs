use crate::Step;
use crate::evidence::{Evidence, Pixel};
use crate::explanation::Explanation;
use crate::step_scene::{ENCODE, Encode, intensity_function, scene_of_step};
use glam::DVec3;
use std::rc::Rc;

/// File in which intensities become bytes.
const RGB8: &str = "step01_rays/rgb8.rs";
const RENDER: &str = "step01_rays/render.rs";
const SKY: &str = "step01_rays/picture.rs";

fn map_channels_to_u8(intensity: DVec3, byte: fn(f64) -> f64) -> [u8; 3] {
    intensity.to_array().map(|c| byte(c) as u8)
}

fn encode_rounded(intensity: DVec3, curve: fn(f64) -> f64) -> [u8; 3] {
    intensity.to_array().map(|c| (255.0 * curve(c.clamp(0.0, 1.0)) + 0.5) as u8)
}

/// Encodes as many small tracers do: a curve, cut at 0.999, times 256.
fn encode_by_256(intensity: DVec3, curve: fn(f64) -> f64) -> [u8; 3] {
    intensity
        .to_array()
        .map(|c| (256.0 * curve(c.max(0.0)).clamp(0.0, 0.999)) as u8)
}

fn encode_srgb(c: f64) -> f64 {
    if c <= 0.0031308 { 12.92 * c } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 }
}

fn decode_srgb(c: f64) -> f64 {
    if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
}

/// Other encodings of an intensity I than `rgb8`, each with its words in a sentence.
pub(crate) const ENCODES: [(&str, Encode); 45] = [
    ("255·I cut off, not rounded", |i| map_channels_to_u8(i, |c| 255.0 * c)),
    ("255.99·I cut off", |i| map_channels_to_u8(i, |c| 255.99 * c)),
    ("255.999·I cut off", |i| map_channels_to_u8(i, |c| 255.999 * c)),
    ("256·I cut off", |i| map_channels_to_u8(i, |c| 256.0 * c)),
    ("256·I cut off, with I at most 0.999", |i| encode_by_256(i, |c| c)),
    ("256·I rounded", |i| map_channels_to_u8(i, |c| 256.0 * c + 0.5)),
    ("254·I rounded", |i| map_channels_to_u8(i, |c| 254.0 * c + 0.5)),
    ("255·I rounded up", |i| map_channels_to_u8(i, |c| (255.0 * c).ceil())),
    ("255·I + 1, cut off", |i| map_channels_to_u8(i, |c| 255.0 * c + 1.0)),
    ("128·I, so that all is half as bright", |i| {
        map_channels_to_u8(i, |c| 128.0 * c)
    }),
    ("127·I, so that all is half as bright", |i| {
        map_channels_to_u8(i, |c| 127.0 * c)
    }),
    ("127·I rounded, so that all is half as bright", |i| {
        map_channels_to_u8(i, |c| 127.0 * c + 0.5)
    }),
    ("100·I", |i| map_channels_to_u8(i, |c| 100.0 * c)),
    ("I itself, without the factor 255", |i| map_channels_to_u8(i, |c| c)),
    ("I itself rounded, without the factor 255", |i| {
        map_channels_to_u8(i, |c| c + 0.5)
    }),
    ("255·I/2", |i| map_channels_to_u8(i, |c| 127.5 * c + 0.5)),
    ("255·2I", |i| map_channels_to_u8(i, |c| 510.0 * c + 0.5)),
    ("255·√I (gamma 2)", |i| encode_rounded(i, f64::sqrt)),
    ("255·√I (gamma 2), cut off", |i| {
        map_channels_to_u8(i, |c| 255.0 * c.clamp(0.0, 1.0).sqrt())
    }),
    ("255.99·√I (gamma 2), cut off", |i| {
        map_channels_to_u8(i, |c| 255.99 * c.clamp(0.0, 1.0).sqrt())
    }),
    ("256·√I (gamma 2), with √I at most 0.999", |i| {
        encode_by_256(i, f64::sqrt)
    }),
    ("255·I^(1/2.2) (gamma)", |i| encode_rounded(i, |c| c.powf(1.0 / 2.2))),
    ("255·I^(1/2.2) (gamma), cut off", |i| {
        map_channels_to_u8(i, |c| 255.0 * c.clamp(0.0, 1.0).powf(1.0 / 2.2))
    }),
    ("256·I^(1/2.2) (gamma), cut at 0.999", |i| {
        encode_by_256(i, |c| c.powf(1.0 / 2.2))
    }),
    ("255·I^(1/1.8) (gamma)", |i| encode_rounded(i, |c| c.powf(1.0 / 1.8))),
    ("255·I^(1/2.4) (gamma)", |i| encode_rounded(i, |c| c.powf(1.0 / 2.4))),
    ("255·I^2.2, gamma the wrong way round", |i| {
        encode_rounded(i, |c| c.powf(2.2))
    }),
    ("255·I², gamma the wrong way round", |i| encode_rounded(i, |c| c * c)),
    ("I encoded as sRGB", |i| encode_rounded(i, encode_srgb)),
    ("I decoded as if it were sRGB", |i| encode_rounded(i, decode_srgb)),
    ("255·(1 − e^−I)", |i| {
        map_channels_to_u8(i, |c| 255.0 * (1.0 - (-c).exp()) + 0.5)
    }),
    ("255·(1 − e^−I), cut off", |i| {
        map_channels_to_u8(i, |c| 255.0 * (1.0 - (-c).exp()))
    }),
    ("255·I/(1 + I)", |i| map_channels_to_u8(i, |c| 255.0 * c / (1.0 + c) + 0.5)),
    ("255·I/(1 + I), cut off", |i| {
        map_channels_to_u8(i, |c| 255.0 * c / (1.0 + c))
    }),
    ("255·(1 − I), a negative", |i| {
        map_channels_to_u8(i, |c| 255.0 * (1.0 - c) + 0.5)
    }),
    ("255·I rounded, but what is above 255 begins again at 0", |i| {
        i.to_array().map(|c| (255.0 * c + 0.5) as i64 as u8)
    }),
    ("255·I cut off, and what is above 255 begins again at 0", |i| {
        i.to_array().map(|c| (255.0 * c) as i64 as u8)
    }),
    ("255·I rounded, but what is above 1 becomes 0", |i| {
        map_channels_to_u8(i, |c| if c > 1.0 { 0.0 } else { 255.0 * c + 0.5 })
    }),
    ("255·I rounded, but black where a channel is above 1", |i| {
        match i.max_element() {
            1.0.. if i.max_element() > 1.0 => [0; 3],
            _ => ENCODE(i),
        }
    }),
    ("255·I rounded, but white where a channel is above 1", |i| {
        if i.max_element() > 1.0 { [255; 3] } else { ENCODE(i) }
    }),
    ("255·I rounded, but what is above 1 begins again at 0", |i| {
        map_channels_to_u8(i, |c| 255.0 * if c > 1.0 { c.fract() } else { c } + 0.5)
    }),
    ("255·I divided by its largest channel where that is above 1", |i| {
        ENCODE(i / i.max_element().max(1.0))
    }),
    ("255·I divided by its largest channel", |i| {
        ENCODE(i / i.max_element().max(1e-9))
    }),
    ("255·I divided by its length where that is above 1", |i| {
        ENCODE(i / i.length().max(1.0))
    }),
    ("255·I divided by its length, so that all colours are equally bright", |i| {
        ENCODE(i.normalize_or_zero())
    }),
];

/// Ways to make a colour grey: words, and the weights of red, green and blue.
const GREYS: [(&str, [f64; 3]); 3] = [
    ("the mean of red, green and blue", [1.0 / 3.0; 3]),
    ("0.299 red + 0.587 green + 0.114 blue", [0.299, 0.587, 0.114]),
    ("0.2126 red + 0.7152 green + 0.0722 blue", [0.2126, 0.7152, 0.0722]),
];

/// Explanations, not yet tried, by another encoding than `rgb8`.
pub(crate) fn encode_candidates<'a>(
    evidence: &'a Evidence,
) -> impl Iterator<Item = Explanation<'a>> {
    let step = evidence.step;
    let exact = step.into_iter().flat_map(move |step| {
        ENCODES.map(|(words, encode)| {
            let sentence = format!("Each byte of your picture is {words}.");
            encode_candidate(evidence, step, sentence, encode)
        })
    });
    exact.chain(grey_candidates(evidence))
}

fn encode_candidate<'a>(
    evidence: &'a Evidence,
    step: Step,
    sentence: String,
    encode: Encode,
) -> Explanation<'a> {
    let intensity = intensity_function(step, &scene_of_step(step));
    Explanation::exact(sentence, &[RGB8, RENDER], move |pixel| {
        encode(intensity(&evidence.our_ray(pixel)))
    })
}

/// Words and function by which the sky alone was turned into bytes, if not by ours, and
/// the same in every pixel of the sky.
pub(crate) fn find_other_encode_of_sky(
    evidence: &Evidence,
    budget: &crate::explanation::RayBudget,
) -> Option<(&'static str, Encode)> {
    let is_sky = |pixel: &Pixel| pixel.region.object.is_none();
    let (wrong, all) = evidence.count_wrong_and_all(is_sky);
    if wrong == 0 || all < 1000 {
        return None;
    }
    let step = evidence.step?;
    ENCODES.into_iter().find(|(words, encode)| {
        let explanation =
            encode_candidate(evidence, step, (*words).to_owned(), *encode);
        explanation.holds_in_region(evidence, is_sky, budget)
    })
}

fn grey_candidates<'a>(
    evidence: &'a Evidence,
) -> impl Iterator<Item = Explanation<'a>> {
    let is_grey = |colour: [u8; 3]| colour == [colour[0]; 3];
    let pixels = &evidence.pixels;
    let is_new = pixels.iter().all(|pixel| is_grey(pixel.yours))
        && !pixels.iter().all(|pixel| is_grey(pixel.ours));
    let mut greys: Vec<Explanation> = vec![];
    if is_new {
        greys.extend(GREYS.map(|(words, weights)| {
            let sentence = format!("Your picture is grey in every pixel: {words}.");
            Explanation::within_one(sentence, curve_files(evidence), move |pixel| {
                let grey: f64 =
                    (0..3).map(|k| weights[k] * f64::from(pixel.ours[k])).sum();
                [grey.round() as u8; 3]
            })
        }));
        greys.extend([0, 1, 2].map(|k| {
            let name = ["red", "green", "blue"][k];
            let sentence =
                format!("Your picture is grey in every pixel: {name} three times.");
            Explanation::exact(sentence, curve_files(evidence), move |pixel| {
                [pixel.ours[k]; 3]
            })
        }));
        greys.push(Explanation::exact(
            "Your picture is grey in every pixel.",
            &[],
            |pixel| pixel.yours,
        ));
    }
    greys.into_iter()
}

/// Explanations, not yet tried: bytes that follow from ours by a factor or by a power.
pub(crate) fn factor_and_power_candidates<'a>(
    evidence: &'a Evidence,
) -> impl Iterator<Item = Explanation<'a>> {
    let table = ByteTable::read_if_consistent(evidence);
    let curves = table.map(|table| {
        let (our_byte, their_byte) = table.changed_byte_near_128();
        let factor = table.fitted_factor_unless_1().map(|factor| {
            let sentence = format!(
                "Each byte of your picture is about {factor:.3} times ours: {our_byte} is {their_byte}."
            );
            (sentence, Box::new(move |c: f64| factor * c) as Curve)
        });
        let power = table.fitted_power_unless_1().map(|power| {
            let sentence = format!(
                "Each byte of your picture is ours to the power {} (gamma): {our_byte} is {their_byte}.",
                format_exponent(power)
            );
            (sentence, Box::new(move |c: f64| c.max(0.0).powf(power)) as Curve)
        });
        [factor, power]
    });
    let intensity =
        evidence.step.map(|step| intensity_function(step, &scene_of_step(step)));
    let intensity = intensity.map(Rc::new);
    curves.into_iter().flatten().flatten().flat_map(move |(sentence, curve)| {
        let curve = Rc::new(curve);
        let of_bytes = curve.clone();
        let bytes = Explanation::within_one(
            sentence.clone(),
            curve_files(evidence),
            move |pixel| {
                let ours =
                    DVec3::from_array(pixel.ours.map(|c| f64::from(c) / 255.0));
                ENCODE(ours.map(of_bytes.as_ref()))
            },
        );
        let exact = intensity.clone().map(|intensity| {
            Explanation::within_one(sentence, curve_files(evidence), move |pixel| {
                ENCODE(intensity(&evidence.our_ray(pixel)).map(curve.as_ref()))
            })
        });
        [bytes].into_iter().chain(exact)
    })
}

/// A function of an intensity.
type Curve = Box<dyn Fn(f64) -> f64>;

/// Files in which a curve may be: in step 1, where all is sky, that of its colour as well.
fn curve_files(evidence: &Evidence) -> &'static [&'static str] {
    match evidence.step {
        Some(Step::Rays) => &[RGB8, RENDER, SKY],
        _ => &[RGB8, RENDER],
    }
}

/// Bytes that follow from ours alone, whatever they show, by a table that is read from the
/// picture.
pub(crate) fn byte_table_candidate<'a>(
    evidence: &'a Evidence,
) -> Option<Explanation<'a>> {
    let table = ByteTable::read_if_consistent(evidence)
        .filter(|table| table.largest_width() < 4)?;
    let (our_byte, their_byte) = table.changed_byte_near_128();
    let words = if table.is_common { "" } else { ", each channel in its own way" };
    let sentence = format!(
        "The bytes of your picture follow from ours, whatever they show{words}: {our_byte} is \
         about {their_byte}."
    );
    Some(Explanation::within_range(sentence, curve_files(evidence), move |pixel| {
        table.range_of_colour(pixel.ours)
    }))
}

fn format_exponent(exponent: f64) -> String {
    if exponent < 1.0 {
        format!("1/{:.1}", 1.0 / exponent)
    } else {
        format!("{exponent:.1}")
    }
}

/// The widest range that a curve of the intensities may give a byte of ours.
const WIDEST: u8 = 12;

/// The width of the widest range. What was clamped may be anything.
fn largest_width_below_255(ranges: &[(u8, u8); 256]) -> u8 {
    let widths = ranges[..255].iter().map(|(low, high)| high.saturating_sub(*low));
    widths.max().unwrap_or(0)
}

/// Whether a byte of ours is never itself in the picture.
fn excludes_byte((our_byte, (low, high)): &(u8, (u8, u8))) -> bool {
    our_byte < low || high < our_byte
}

/// The range of bytes in the picture for each byte of ours, of each channel.
struct ByteTable {
    ranges: [[(u8, u8); 256]; 3],
    is_common: bool,
}

impl ByteTable {
    /// Reads it; None where a byte of ours is not about the same wherever it is.
    fn read_if_consistent(evidence: &Evidence) -> Option<Self> {
        let mut ranges = [[(255, 0); 256]; 3];
        for pixel in &evidence.pixels {
            for (k, ranges) in ranges.iter_mut().enumerate() {
                let (low, high): &mut (u8, u8) =
                    &mut ranges[usize::from(pixel.ours[k])];
                *low = pixel.yours[k].min(*low);
                *high = pixel.yours[k].max(*high);
            }
        }
        let mut common = ranges[0];
        for channel_ranges in &ranges[1..] {
            for (range, channel_ranges) in common.iter_mut().zip(channel_ranges) {
                *range =
                    (range.0.min(channel_ranges.0), range.1.max(channel_ranges.1));
            }
        }
        let is_common = largest_width_below_255(&common) < WIDEST;
        let ranges = if is_common { [common; 3] } else { ranges };
        let table = Self { ranges, is_common };
        let is_read = table.largest_width() < WIDEST
            && 48 <= table.met_bytes_with_ranges().count();
        // Where only the sky is wrong, it is the sky's colour and not that of all bytes.
        let (wrong_objects, objects) =
            evidence.count_wrong_and_all(|pixel| pixel.region.object.is_some());
        let is_everywhere = objects == 0 || 0 < wrong_objects;
        (is_read && is_everywhere && table.is_a_third_changed()).then_some(table)
    }

    /// Each byte that ours has, with the range of the picture there.
    fn met_bytes_with_ranges(&self) -> impl Iterator<Item = (u8, (u8, u8))> {
        let ranges = self.ranges.iter().flat_map(|ranges| (0..=255).zip(*ranges));
        ranges.filter(|(_, (low, high))| low <= high)
    }

    /// The width of the widest range.
    fn largest_width(&self) -> u8 {
        self.ranges.iter().map(largest_width_below_255).max().unwrap_or(0)
    }

    fn is_a_third_changed(&self) -> bool {
        let changed = self.met_bytes_with_ranges().filter(excludes_byte).count();
        self.met_bytes_with_ranges().count() < 3 * changed + 3
    }

    /// The changed byte of ours nearest to 128, and its lowest value in the picture.
    fn changed_byte_near_128(&self) -> (u8, u8) {
        let byte_ranges = self.met_bytes_with_ranges().filter(excludes_byte);
        let byte_ranges =
            byte_ranges.min_by_key(|(our_byte, _)| our_byte.abs_diff(128));
        byte_ranges
            .map_or((0, 0), |(our_byte, (their_byte, _))| (our_byte, their_byte))
    }

    /// The mean over every second byte, so that the others are asked.
    fn mean_over_every_second_byte(
        &self,
        ratio: impl Fn(f64, f64) -> f64,
    ) -> Option<f64> {
        let inner = |c: u8| 8 < c && c < 248;
        let byte_ranges =
            self.met_bytes_with_ranges().filter(|(our_byte, (their_byte, _))| {
                inner(*our_byte) && inner(*their_byte)
            });
        let numbers = byte_ranges.step_by(2).map(|(our_byte, (low, high))| {
            ratio(f64::from(our_byte), (f64::from(low) + f64::from(high)) / 2.0)
        });
        let (count, sum) =
            numbers.fold((0.0, 0.0), |(count, sum), n| (count + 1.0, sum + n));
        (1.0 < count).then(|| sum / count)
    }

    fn fitted_factor_unless_1(&self) -> Option<f64> {
        self.mean_over_every_second_byte(|our_byte, their_byte| {
            their_byte / our_byte
        })
        .filter(|factor| (factor - 1.0).abs() > 0.01)
    }

    fn fitted_power_unless_1(&self) -> Option<f64> {
        let power = self.mean_over_every_second_byte(|our_byte, their_byte| {
            (their_byte / 255.0).ln() / (our_byte / 255.0).ln()
        });
        power.filter(|power| (power - 1.0).abs() > 0.04)
    }

    fn range_of_colour(&self, ours: [u8; 3]) -> [[u8; 3]; 2] {
        let ranges = [0, 1, 2].map(|k| self.ranges[k][usize::from(ours[k])]);
        [ranges.map(|range| range.0), ranges.map(|range| range.1)]
    }
}
