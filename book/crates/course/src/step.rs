use glam::DVec3;
use step01_rays::{AspectRatio, Camera, Ray, direction_colour};
use step05_phong::{Light, Material, Scene, SurfacePoint, phong, visible_point};

/// The camera of the course's pictures: 640 columns, 16:9, 60 degrees.
pub fn camera() -> Camera {
    camera_with_size(640, 360)
}

/// The rays of that camera through all its pixels, row by row.
pub fn primary_rays() -> impl Iterator<Item = Ray> {
    let pixels = (0..360).flat_map(|j| (0..640).map(move |i| (i, j)));
    pixels.map(|(i, j)| camera().ray(i.into(), j.into()))
}

/// The camera of the course with so many columns and rows. Its angle is turned into radians as by
/// the programs: π/3 is another number in its last digit.
pub fn camera_with_size(columns: u32, rows: u32) -> Camera {
    Camera::new(columns, rows, 60_f64.to_radians())
}

/// The camera with this field of view, in degrees, and so many columns, 16:9.
pub fn camera_with_fov(fov_degrees: f64, columns: f64) -> Camera {
    let h_res = columns as u32;
    let aspect_ratio = AspectRatio { width: 16.0, height: 9.0 };
    Camera::new(h_res, aspect_ratio.v_res(h_res), fov_degrees.to_radians())
}

/// The camera whose matrix is that of the slide "A Basic 3D Camera Matrix", to the letter.
pub fn slide_matrix() -> Camera {
    let mut camera = camera();
    let tan = -camera.matrix.z_axis.x;
    let upright = f64::from(camera.v_res) * tan / f64::from(camera.h_res - 1);
    camera.matrix.y_axis.y = -2.0 * upright;
    camera.matrix.z_axis.y = upright;
    camera
}

/// The colour of a scene of step 5 without the test of n·l: with each highlight twice, before and
/// behind the surface, as r is the same for n and −n and one of the two passes the gate.
pub fn ungated_colour(scene: &Scene<Material, Light>, ray: &Ray) -> DVec3 {
    let Some(outside) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let inside = SurfacePoint { n: -outside.n, ..outside };
    let [outside, inside] =
        [outside, inside].map(|point| phong(&point, ray, scene.ambient_light, &scene.lights));
    outside.sum() + inside.specular
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

    /// The names of all five.
    pub const NAMES: [&str; 5] =
        ["step01_rays", "step02_sphere", "step03_nearest", "step04_diffuse", "step05_phong"];

    /// Number from 1 to 5.
    pub fn number(self) -> usize {
        self as usize + 1
    }

    /// The name of its crate, its first chapter and its locked picture.
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }

    /// The step whose name `name` is.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|step| step.name() == name)
    }
}
