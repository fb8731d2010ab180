//! `check`: what it says of every picture that a reader may bring. Answers are snapshots, to be
//! read as a reader does.

mod changed_scenes;
mod files;
mod laws;
mod list;
mod program;
mod whole_pictures;
mod wrong_programs;

use check::{Answer, LockedPictures, check_picture};
use course::{Step, camera};
use glam::DVec3;
use image::{Rgb, RgbImage};
use insta::{Settings, assert_snapshot};
use std::path::PathBuf;
use std::{fs, rc::Rc};
use step01_rays::{Ray, render};
use step05_phong::{Light, Material, Scene};

thread_local! {
    static LOCKED: Rc<LockedPictures> = Rc::new(LockedPictures::in_workspace());
}

/// The pictures to compare with.
fn locked() -> Rc<LockedPictures> {
    LOCKED.with(Rc::clone)
}

/// The locked picture `name`.
fn locked_picture(name: &str) -> RgbImage {
    let picture = locked().get(name);
    RgbImage::clone(&picture.expect("a locked picture"))
}

/// The locked picture `name` with each pixel made from its place and colour.
fn map_locked(name: &str, change: impl Fn(u32, u32, [u8; 3]) -> [u8; 3]) -> RgbImage {
    let ours = locked_picture(name);
    RgbImage::from_fn(640, 360, |i, j| Rgb(change(i, j, ours.get_pixel(i, j).0)))
}

/// The picture of a function from rays, by the camera of the course.
fn draw(colour: impl Fn(&Ray) -> DVec3 + Sync) -> RgbImage {
    render(&camera(), 1, colour)
}

/// The picture of step 5 with another scene.
fn draw_changed_scene(change: impl Fn(&mut Scene<Material, Light>)) -> RgbImage {
    let mut scene = step05_phong::scene();
    change(&mut scene);
    draw(|ray| step05_phong::colour(&scene, ray))
}

/// The picture of a step, by the camera of the course.
fn draw_step(step: Step) -> RgbImage {
    (step.picture())(&camera(), 1)
}

fn check(picture: RgbImage, name: &str) -> Answer {
    check_picture(&picture.into(), Some(name), &locked())
}

/// So many things with a title each.
type Titled<T, const COUNT: usize> = [(&'static str, T); COUNT];

/// Answers below their titles, compared with the snapshot of this name.
struct Answers(String);

impl Answers {
    fn new() -> Self {
        Self(String::new())
    }

    fn add(&mut self, title: &str, text: &str) {
        self.0 += &format!("## {title}\n{}\n\n", text.trim_end());
    }

    /// Adds the answer about a picture that should be the one of `name`.
    fn add_picture(&mut self, title: &str, name: &str, picture: RgbImage) {
        let Answer { verdict, text, cause, .. } = check(picture, name);
        assert!(text.lines().count() <= 14, "{text}");
        let cause = [cause.step.map(Step::name), cause.file.as_deref(), cause.mistake.as_deref()];
        let cause: Vec<_> = cause.into_iter().flatten().collect();
        let end = match cause.is_empty() {
            true => String::new(),
            false => format!("\n[cause: {}]", cause.join("; ")),
        };
        self.add(title, &format!("[{}]\n{text}{end}", verdict.words()));
    }

    #[track_caller]
    fn assert_locked(self, name: &str) {
        let mut settings = Settings::clone_current();
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        settings.bind(|| assert_snapshot!(name, self.0));
    }
}

/// An empty folder of this test.
fn create_empty_folder(test: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder in the target folder");
    folder
}
