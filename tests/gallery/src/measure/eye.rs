use super::look::{hit, near};
use super::{Alternative, Look, alternatives, rays};
use crate::view::scattered;
use crate::{Parts, Step, section};
use glam::{DMat3, DVec3};

/// How well the camera of a picture is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Eye {
    /// It is the right one, to the last byte of the sky.
    Right,
    /// It is another one, known to the last byte.
    Exact,
    /// It was read from the sky, about to one byte.
    Read,
    /// It is not known.
    Unknown,
}

/// A camera, and what makes a colour of its rays.
struct Guess {
    eye: Eye,
    parts: Parts,
    tint: DMat3,
    fault: Option<Alternative>,
}

/// How well a guess agrees with some pixels.
#[derive(Clone, Copy, Debug)]
struct Score {
    /// How many are sky where it has sky, or none where it has none.
    agree: usize,
    /// How many are sky in both, to one byte, and to the last.
    near: usize,
    same: usize,
}

impl Score {
    fn is_exact(&self) -> bool {
        self.near - self.same <= self.near / 100 && 8 < self.near
    }
}

impl Look<'_> {
    /// Finds the camera and the sky's colour that agree best with the picture.
    pub fn find_eye(&mut self) {
        self.choose(self.guesses());
    }

    /// Whether some camera draws the sky to the last byte; then it is taken.
    pub fn has_exact_sky(&mut self) -> bool {
        let cameras = self.cameras();
        self.choose(cameras.into_iter().filter(|g| g.eye == Eye::Exact).collect());
        self.eye == Eye::Exact && self.fault.is_none()
    }

    /// Takes the best of some guesses.
    fn choose(&mut self, guesses: Vec<Guess>) {
        let places = scattered(self.yours, 2500);
        let is_all = guesses.len() > 40;
        let rated = guesses.into_iter().map(|guess| {
            let score = self.score(&guess, &places);
            (guess, score)
        });
        let mut best: Option<(Guess, Score)> = None;
        for (guess, score) in rated {
            // A later guess has to be clearly better, and a right sky is right.
            let least = match &best {
                Some((best, _)) if best.eye == Eye::Read && score.is_exact() => 0,
                Some((best, _)) if best.eye == Eye::Right => break,
                Some((_, best)) if score.is_exact() => {
                    best.agree + places.len() / 200
                }
                Some(_) => places.len(),
                None => 0,
            };
            let is_it = match guess.eye {
                Eye::Read if guess.tint != DMat3::IDENTITY => 95,
                Eye::Read => 70,
                _ if !score.is_exact() => 101,
                Eye::Right if places.len() < 50 * score.near => 0,
                _ if score.near * 20 < places.len() => 90,
                _ => 50,
            };
            let is_it = is_it * places.len() <= 100 * score.agree;
            // Little sky is not enough: its objects have to be there, too.
            let is_little =
                score.near * 20 < places.len() && guess.eye != Eye::Right;
            let is_it = is_it && (!is_little || self.has_objects(&guess, &places));
            if is_it && 8 < score.near && least < score.agree {
                best = Some((guess, score));
            }
        }
        let Some((guess, _)) =
            best.or_else(|| self.skyless(&places).filter(|_| is_all))
        else {
            self.eye = Eye::Unknown;
            return;
        };
        self.eye = guess.eye;
        self.theirs = guess.parts;
        self.tint = guess.tint;
        self.fault = guess.fault;
    }

    /// Whether many of the objects that a guess sees have their colours.
    fn has_objects(&self, guess: &Guess, places: &[(u32, u32)]) -> bool {
        let few = places.iter().step_by(places.len() / 250 + 1);
        let is_same = |&&(i, j): &&(u32, u32)| {
            let ours = guess.parts.intensity(self.step, i, j);
            near(self.yours.get_pixel(i, j), &self.bytes.write(ours))
        };
        self.step == Step::Rays
            || 2 * few.clone().filter(is_same).count() > few.count()
    }

    /// A camera that explains a picture without sky, by its objects.
    fn skyless(&self, places: &[(u32, u32)]) -> Option<(Guess, Score)> {
        let is_open = |&&(i, j): &&(u32, u32)| {
            self.yours.get_pixel(i, j).0.iter().all(|byte| (1..255).contains(byte))
        };
        let few: Vec<_> = places.iter().filter(is_open).collect();
        let few: Vec<_> =
            few.iter().step_by(few.len() / 250 + 1).copied().collect();
        let is_same = |parts: &Parts, &(i, j): &(u32, u32)| {
            let ours = parts.intensity(self.step, i, j);
            near(self.yours.get_pixel(i, j), &self.bytes.write(ours))
        };
        let guess = |matrix: DMat3| {
            let mut parts = self.right.clone();
            parts.camera.matrix = matrix;
            let count = few.iter().filter(|p| is_same(&parts, p)).count();
            (count, parts)
        };
        let all = rays::ordinary(self).into_iter().map(guess);
        let (count, parts) = all.max_by_key(|(count, _)| *count)?;
        let is_it = 60 < few.len() && few.len() * 97 <= count * 100;
        let is_it = is_it && Step::Nearest < self.step;
        let score = Score { agree: count, near: count, same: count };
        let (eye, tint, fault) = (Eye::Exact, DMat3::IDENTITY, None);
        is_it.then_some((Guess { eye, parts, tint, fault }, score))
    }

    /// What is tried, the simplest first.
    fn guesses(&self) -> Vec<Guess> {
        let mut guesses = vec![self.guess(Eye::Right)];
        let faults = alternatives().filter(|a| {
            a.section.step == Step::Rays && a.section != section::BYTES
        });
        let faults = faults.map(|fault| {
            let mut guess = self.guess(Eye::Exact);
            (fault.change)(&mut guess.parts);
            Guess { fault: Some(fault), ..guess }
        });
        // Where the rays start, the sky does not tell.
        let moved = |guess: &Guess| guess.parts.camera.centre != DVec3::ZERO;
        guesses.extend(faults.filter(|guess| !moved(guess)));
        guesses.extend(self.cameras());
        guesses
    }

    /// The right camera, however well that is known.
    fn guess(&self, eye: Eye) -> Guess {
        let parts = self.right.clone();
        Guess { eye, parts, tint: DMat3::IDENTITY, fault: None }
    }

    /// The cameras, or the colours of the sky, that the sky tells.
    fn cameras(&self) -> Vec<Guess> {
        let Some(sky) = &self.sky else { return vec![] };
        let snapped = rays::snapped(self, sky).into_iter();
        let snapped = snapped.map(|matrix| (Eye::Exact, matrix));
        let all = snapped.chain([(Eye::Read, sky.matrix)]);
        all.flat_map(|(eye, matrix)| {
            let mut camera = self.guess(eye);
            camera.parts.camera.matrix = matrix;
            let mut tint = self.guess(eye);
            tint.tint = matrix * self.right.camera.matrix.inverse();
            // No camera here makes V_z anything but −1 or 1.
            let is_tint = sky.is_deep && 0.01 < (matrix.z_axis.z.abs() - 1.0).abs();
            if is_tint { [tint, camera] } else { [camera, tint] }
        })
        .collect()
    }

    fn score(&self, guess: &Guess, places: &[(u32, u32)]) -> Score {
        let mut score = Score { agree: 0, near: 0, same: 0 };
        for &(i, j) in places {
            let is_sky = hit(&guess.parts, self.step, i.into(), j.into()).is_none();
            let yours = self.yours.get_pixel(i, j);
            let sky = self.sky_pixel(&guess.parts, &guess.tint, i, j);
            let is_near = near(yours, &sky);
            score.agree += usize::from(is_sky == is_near);
            score.near += usize::from(is_sky && is_near);
            score.same += usize::from(is_sky && *yours == sky);
        }
        score
    }
}
