use crate::evidence::scattered_places;
use crate::explanation::RayBudget;
use crate::step_scene::{ENCODE, intensity_function, scene_of_step};
use course::{Step, find_mistakes_with_hash, hash_picture};
use glam::DVec3;
use image::RgbImage;
use step01_rays::Camera;

/// The field of view of the locked pictures, in tenths of a degree.
const FIELD_OF_VIEW: u32 = 600;

/// How many rays are drawn to find out whether a picture has some options, and to try all.
const RAYS: u32 = 3 << 20;
const ALL_RAYS: u32 = 4 * RAYS;

/// Sentences about a picture that our own step draws with other options: another size, field
/// of view or number of samples.
pub(crate) fn describe_other_options(step: Step, yours: &RgbImage) -> Option<String> {
    let (columns, rows) = yours.dimensions();
    if columns < 2 {
        return None;
    }
    let intensity = intensity_function(step, &scene_of_step(step));
    let colour = |camera: &Camera, samples: u32, (i, j): (u32, u32)| {
        let offset = |k: u32| (f64::from(k) + 0.5) / f64::from(samples) - 0.5;
        let mut sum = DVec3::ZERO;
        for v in (0..samples).map(offset) {
            for u in (0..samples).map(offset) {
                sum += intensity(&camera.ray(f64::from(i) + u, f64::from(j) + v));
            }
        }
        ENCODE(sum / f64::from(samples * samples))
    };
    let budget = RayBudget::new(ALL_RAYS);
    let mut places: Vec<_> = scattered_places(columns, rows).take(RAYS as usize).collect();
    for tenths in [FIELD_OF_VIEW].into_iter().chain(10..1800) {
        let fov_degrees = f64::from(tenths) / 10.0;
        let camera = Camera::new(columns, rows, fov_degrees.to_radians());
        // The sky in the corner hardly depends on the samples.
        let corners = [colour(&camera, 1, (0, 0)), yours.get_pixel(0, 0).0];
        if (0..3).any(|k| 1 < corners[0][k].abs_diff(corners[1][k])) {
            continue;
        }
        for samples in 1..=16 {
            let rays = samples * samples;
            let compared = places.len().min((RAYS / rays) as usize);
            let mut asked = places[..compared].iter();
            let wrong = asked.position(|(i, j)| {
                !budget.spend(rays)
                    || colour(&camera, samples, (*i, *j)) != yours.get_pixel(*i, *j).0
            });
            match wrong {
                None => {
                    return Some(sentences(step, yours, fov_degrees, samples, compared));
                }
                // A pixel that tells of one mostly tells of the next, and is asked first.
                Some(k) => places.swap(0, k),
            }
        }
    }
    None
}

/// Sentences about a picture that is right with these options, in the pixels compared.
fn sentences(
    step: Step,
    yours: &RgbImage,
    fov_degrees: f64,
    samples: u32,
    compared: usize,
) -> String {
    let ((columns, rows), name) = (yours.dimensions(), step.name());
    let extent = match columns as usize * rows as usize {
        all if compared == all => "in every pixel".to_owned(),
        all => format!("in the {compared} pixels of {all} that were compared"),
    };
    let hint = match find_mistakes_with_hash(hash_picture(yours)).first() {
        Some((mistake, _)) => {
            format!("Did you give none? Then it may be this: {} ({}).", mistake.title, mistake.file)
        }
        None => "Did you give none? Then compare with camera.rs, render.rs, aspect_ratio.rs \
                 and program.rs in steps/step01_rays/src."
            .to_owned(),
    };
    format!(
        "Right, but with other options: this is the picture of {name}, {extent}, at \
         {columns}×{rows} pixels, {fov_degrees}° and {samples}×{samples} rays a pixel.\n\
         The locked picture is drawn without options, which is --width 640 --aspect 16:9 \
         --fov 60 --samples 1. {hint}"
    )
}
