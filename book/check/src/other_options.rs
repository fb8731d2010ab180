use crate::camera_from_sky::SkyCamera;
use crate::evidence::Evidence;
use crate::explanation::{Explanation, RayBudget};
use crate::step_scene::{ENCODE, intensity_function, scene_of_step};
use crate::{Picture, Step, find_mistakes_with_hash, hash_picture};
use glam::DVec3;
use image::{Rgb, RgbImage};
use step01_rays::Camera;

/// The field of view of the locked pictures, in degrees.
const FIELD_OF_VIEW: f64 = 60.0;

/// The options of a program with which a picture is drawn.
pub(crate) struct Options {
    /// In degrees.
    pub fov_degrees: f64,
    /// The side of the grid of rays.
    pub samples: u32,
    /// How many pixels were compared.
    pub compared: usize,
}

/// Our own picture in some rows.
pub(crate) fn draw_rows(step: Step, camera: &Camera, rows: &[u32]) -> RgbImage {
    if rows.len() == camera.v_res as usize {
        return step.draw_picture(camera, 1);
    }
    let intensity = intensity_function(step, &scene_of_step(step));
    RgbImage::from_fn(camera.h_res, rows.len() as u32, |i, k| {
        let ray = camera.ray(i.into(), rows[k as usize].into());
        Rgb(ENCODE(intensity(&ray)))
    })
}

/// The options with which our own step draws this very picture.
pub(crate) fn find_other_options(
    step: Step,
    yours: &Picture,
    budget: &RayBudget,
) -> Option<Options> {
    let (columns, rows) = yours.size;
    let fov_of_sky = SkyCamera::fit(&yours.with_spread_rows(1 << 16))
        .map(|sky| sky.rounded_fov_degrees(columns));
    let fov_of_sky = fov_of_sky
        .filter(|angle| 1.0 <= *angle && *angle < 180.0 && *angle != FIELD_OF_VIEW);
    [Some(FIELD_OF_VIEW), fov_of_sky].into_iter().flatten().find_map(
        |fov_degrees| {
            let camera = Camera::new(columns, rows, fov_degrees.to_radians());
            let ours = draw_rows(step, &camera, &yours.rows);
            if ours == yours.pixels {
                let compared = yours.pixels.pixels().len();
                return Some(Options { fov_degrees, samples: 1, compared });
            }
            let evidence = Evidence::new("", None, yours, ours, camera, ENCODE);
            (2..=16).find_map(|samples| {
                // Those that are wrong come first: no pixel that another one tells of is left out.
                let pixels = (RAYS / (samples * samples)) as usize;
                let compared = pixels.min(evidence.pixels.len());
                let explanation = sample_grid_candidate(&evidence, step, samples);
                let holds = evidence.wrong_pixels().len() <= compared
                    && explanation
                        .holds_in_first_pixels(&evidence, compared, budget);
                holds.then_some(Options { fov_degrees, samples, compared })
            })
        },
    )
}

/// How many rays are drawn to find out whether a picture has so many samples.
const RAYS: u32 = 3 << 20;

/// Each pixel the mean of a grid of rays.
fn sample_grid_candidate<'a>(
    evidence: &'a Evidence,
    step: Step,
    samples: u32,
) -> Explanation<'a> {
    let intensity = intensity_function(step, &scene_of_step(step));
    let side = f64::from(samples);
    let offset = move |k: u32| (f64::from(k) + 0.5) / side - 0.5;
    let mut explanation = Explanation::exact("", &[], move |pixel| {
        let mut sum = DVec3::ZERO;
        for v in (0..samples).map(offset) {
            for u in (0..samples).map(offset) {
                let (i, j) = (f64::from(pixel.i) + u, f64::from(pixel.j) + v);
                sum += intensity(&evidence.camera.ray(i, j));
            }
        }
        ENCODE(sum / (side * side))
    });
    explanation.rays = samples * samples;
    explanation
}

impl Options {
    /// Whether these are those of the locked pictures but for the size.
    pub fn are_default_but_size(&self) -> bool {
        self.fov_degrees == FIELD_OF_VIEW && self.samples == 1
    }

    /// Sentences about a picture that is right with them.
    pub fn sentences(&self, step: Step, yours: &Picture) -> String {
        let ((columns, rows), name) = (yours.size, step.name());
        let Self { fov_degrees, samples, compared } = *self;
        let all = columns as usize * rows as usize;
        let extent = match yours.has_all_rows() {
            true if compared == all => "in every pixel".to_owned(),
            true => format!("in the {compared} pixels of {all} that were compared"),
            false => format!(
                "in the {} rows of {rows} that were compared",
                yours.rows.len()
            ),
        };
        let options = format!(
            "at {columns}×{rows} pixels, {fov_degrees}° and {samples}×{samples} rays a \
             pixel."
        );
        if !yours.has_all_rows() && self.are_default_but_size() {
            return format!(
                "Right {extent}: this is the picture of {name}, {options}"
            );
        }
        let clause = format!("this is the picture of {name}, {extent}, {options}");
        let mistake =
            find_mistakes_with_hash(hash_picture(&yours.pixels)).into_iter().next();
        let mistake = mistake.filter(|_| yours.has_all_rows());
        let hint = match mistake {
            Some((mistake, _)) => format!(
                "Did you give none? Then it may be this: {} ({}).",
                mistake.title, mistake.file
            ),
            None => "Did you give none? Then compare with camera.rs, render.rs, \
                     aspect_ratio.rs and program.rs in steps/step01_rays/src."
                .to_owned(),
        };
        format!(
            "Right, but with other options: {clause}\nThe locked picture is drawn without \
             options, which is --width 640 --aspect 16:9 --fov 60 --samples 1. {hint}"
        )
    }
}
