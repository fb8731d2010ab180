use crate::camera_from_sky::Sky;
use crate::evidence::Evidence;
use crate::explanation::{Explanation, Work};
use crate::step_scene::{ENCODE, intensity, scene};
use crate::{Picture, Step, known, sum};
use glam::DVec3;
use image::{Rgb, RgbImage};
use step01_rays::Camera;

/// The field of view of the locked pictures, in degrees.
const FIELD_OF_VIEW: f64 = 60.0;

/// The options of a program with which a picture is drawn.
pub(crate) struct Options {
    /// In degrees.
    pub field_of_view: f64,
    /// The side of the grid of rays.
    pub samples: u32,
    /// How many pixels were compared.
    pub compared: usize,
}

/// Our own picture in some rows.
pub(crate) fn draw_rows(step: Step, camera: &Camera, rows: &[u32]) -> RgbImage {
    if rows.len() == camera.v_res as usize {
        return step.picture(camera, 1);
    }
    let intensity = intensity(step, &scene(step));
    RgbImage::from_fn(camera.h_res, rows.len() as u32, |i, k| {
        let ray = camera.ray(i.into(), rows[k as usize].into());
        Rgb(ENCODE(intensity(&ray)))
    })
}

/// The options with which our own step draws this very picture.
pub(crate) fn other_options(
    step: Step,
    yours: &Picture,
    work: &Work,
) -> Option<Options> {
    let (columns, rows) = yours.size;
    let read =
        Sky::read(&yours.thinned(1 << 16)).map(|sky| sky.field_of_view(columns));
    let read = read
        .filter(|angle| 1.0 <= *angle && *angle < 180.0 && *angle != FIELD_OF_VIEW);
    [Some(FIELD_OF_VIEW), read].into_iter().flatten().find_map(|field_of_view| {
        let camera = Camera::new(columns, rows, field_of_view.to_radians());
        let ours = draw_rows(step, &camera, &yours.rows);
        if ours == yours.pixels {
            let compared = yours.pixels.pixels().len();
            return Some(Options { field_of_view, samples: 1, compared });
        }
        let evidence = Evidence::new("", None, yours, ours, camera, ENCODE);
        (2..=16).find_map(|samples| {
            // Those that are wrong come first: no pixel that another one tells of is left out.
            let pixels = (RAYS / (samples * samples)) as usize;
            let compared = pixels.min(evidence.pixels.len());
            let explanation = with_samples(&evidence, step, samples);
            let holds = evidence.wrong().len() <= compared
                && explanation.holds_in_first(&evidence, compared, work);
            holds.then_some(Options { field_of_view, samples, compared })
        })
    })
}

/// How many rays are drawn to find out whether a picture has so many samples.
const RAYS: u32 = 3 << 20;

/// Each pixel the mean of a grid of rays.
fn with_samples<'a>(
    evidence: &'a Evidence,
    step: Step,
    samples: u32,
) -> Explanation<'a> {
    let intensity = intensity(step, &scene(step));
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
    pub fn are_default(&self) -> bool {
        self.field_of_view == FIELD_OF_VIEW && self.samples == 1
    }

    /// What is told of a picture that is right with them.
    pub fn sentence(&self, step: Step, yours: &Picture) -> String {
        let ((columns, rows), name) = (yours.size, step.name());
        let Self { field_of_view, samples, compared } = *self;
        let all = columns as usize * rows as usize;
        let extent = match yours.is_whole() {
            true if compared == all => "in every pixel".to_owned(),
            true => format!("in the {compared} pixels of {all} that were compared"),
            false => format!(
                "in the {} rows of {rows} that were compared",
                yours.rows.len()
            ),
        };
        let options = format!(
            "at {columns}×{rows} pixels, {field_of_view}° and {samples}×{samples} rays a \
             pixel."
        );
        if !yours.is_whole() && self.are_default() {
            return format!(
                "Right {extent}: this is the picture of {name}, {options}"
            );
        }
        let told = format!("this is the picture of {name}, {extent}, {options}");
        let listed = known(sum(&yours.pixels)).into_iter().next();
        let listed = listed.filter(|_| yours.is_whole());
        let hint = match listed {
            Some((mistake, _)) => format!(
                "Did you give none? Then it may be this: {} ({}).",
                mistake.title, mistake.file
            ),
            None => "Did you give none? Then compare with camera.rs, render.rs, \
                     aspect_ratio.rs and program.rs in steps/step01_rays/src."
                .to_owned(),
        };
        format!(
            "Right, but with other options: {told}\nThe locked picture is drawn without \
             options, which is --width 640 --aspect 16:9 --fov 60 --samples 1. {hint}"
        )
    }
}
