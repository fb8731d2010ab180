use image::RgbImage;
use step01_rays::Camera;

/// The camera of the course, with a field of view of 60 degrees.
pub fn default_camera(width: u32, height: u32) -> Camera {
    Camera::new(width, height, 60_f64.to_radians())
}

/// One of the five steps; they are in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Step {
    /// step01_rays.
    Rays,
    /// step02_sphere.
    Sphere,
    /// step03_nearest.
    Nearest,
    /// step04_diffuse.
    Diffuse,
    /// step05_phong.
    Phong,
}

impl Step {
    /// All five.
    pub const ALL: [Self; 5] =
        [Self::Rays, Self::Sphere, Self::Nearest, Self::Diffuse, Self::Phong];

    /// Number from 1 to 5.
    pub fn number(self) -> usize {
        self as usize + 1
    }

    /// The name of its crate, its first chapter and its locked picture.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rays => "step01_rays",
            Self::Sphere => "step02_sphere",
            Self::Nearest => "step03_nearest",
            Self::Diffuse => "step04_diffuse",
            Self::Phong => "step05_phong",
        }
    }

    /// The names of its chapters, in the order of the book.
    pub fn chapters(self) -> Vec<&'static str> {
        match self {
            Self::Rays => vec![self.name(), "step01_program"],
            _ => vec![self.name()],
        }
    }

    /// The step whose name `name` is.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|step| step.name() == name)
    }

    /// The step whose folder or file a path leads to.
    pub fn from_path(path: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|step| path.contains(step.name()))
    }

    /// Draws its right picture by a camera.
    pub fn draw_picture(self, camera: &Camera, samples: u32) -> RgbImage {
        let picture: fn(&Camera, u32) -> RgbImage = match self {
            Self::Rays => step01_rays::picture,
            Self::Sphere => step02_sphere::picture,
            Self::Nearest => step03_nearest::picture,
            Self::Diffuse => step04_diffuse::picture,
            Self::Phong => step05_phong::picture,
        };
        picture(camera, samples)
    }
}
