#[cfg(feature = "pictures")]
use {
    image::RgbImage,
    live::{Answer, json},
    step01_rays::Camera,
};

/// The pictures of the course, in the order of `check`: the name of each, the file that
/// draws it where that is an example of a step, and its function.
macro_rules! pictures {
    ($($name:ident $(in $path:literal)?: $picture:expr,)*) => {
        /// The names of the pictures.
        pub const NAMES: &[&str] = &[$(stringify!($name)),*];

        $($(
            #[cfg(feature = "pictures")]
            #[path = $path]
            #[allow(dead_code, reason = "the main of an example runs as a program only")]
            mod $name;
        )?)*

        /// What draws each.
        #[cfg(feature = "pictures")]
        const PICTURES: &[fn(&Camera, u32) -> RgbImage] = &[$($picture),*];
    };
}

pictures! {
    step01_rays: step01_rays::picture,
    step02_sphere: step02_sphere::picture,
    step03_nearest: step03_nearest::picture,
    step04_diffuse: step04_diffuse::picture,
    step05_phong: step05_phong::picture,
    gradient in "../../../../steps/step01_rays/examples/gradient.rs": |_, _| gradient::picture(),
    graticule in "../../../../steps/step01_rays/examples/graticule.rs": graticule::picture,
    look_at in "../../../../steps/step01_rays/examples/look_at.rs": look_at::picture,
    panorama in "../../../../steps/step01_rays/examples/panorama.rs": panorama::picture,
    rings in "../../../../steps/step01_rays/examples/rings.rs": rings::picture,
    disc in "../../../../steps/step02_sphere/examples/disc.rs": |camera, _| disc::picture(camera),
    lens in "../../../../steps/step02_sphere/examples/lens.rs": lens::picture,
    plane in "../../../../steps/step02_sphere/examples/plane.rs": plane::picture,
    quadric in "../../../../steps/step02_sphere/examples/quadric.rs": quadric::picture,
    all_hits in "../../../../steps/step03_nearest/examples/all_hits.rs": all_hits::picture,
    depth in "../../../../steps/step03_nearest/examples/depth.rs": depth::picture,
    jitter in "../../../../steps/step03_nearest/examples/jitter.rs": jitter::picture,
    many in "../../../../steps/step03_nearest/examples/many.rs": many::picture,
    my_scene in "../../../../steps/step03_nearest/examples/my_scene.rs": my_scene::picture,
    gamma in "../../../../steps/step04_diffuse/examples/gamma.rs": gamma::picture,
    normals in "../../../../steps/step04_diffuse/examples/normals.rs": normals::picture,
    plaster in "../../../../steps/step04_diffuse/examples/plaster.rs": plaster::picture,
    shadows in "../../../../steps/step04_diffuse/examples/shadows.rs": shadows::picture,
    snowman in "../../../../steps/step04_diffuse/examples/snowman.rs": snowman::picture,
    spot in "../../../../steps/step04_diffuse/examples/spot.rs": spot::picture,
    sun in "../../../../steps/step04_diffuse/examples/sun.rs": sun::picture,
    glass in "../../../../steps/step05_phong/examples/glass.rs": glass::picture,
    halfway in "../../../../steps/step05_phong/examples/halfway.rs": halfway::picture,
    marbles in "../../../../steps/step05_phong/examples/marbles.rs": marbles::picture,
    mirror in "../../../../steps/step05_phong/examples/mirror.rs": mirror::picture,
}

/// Columns and rows of each.
pub const SIZE: [u32; 2] = [640, 360];

/// The picture `name`, drawn by the course's own code: red, green and blue of each pixel.
#[cfg(feature = "pictures")]
pub fn draw(name: &str) -> Answer {
    let Some(k) = NAMES.iter().position(|known| *known == name) else {
        return Answer::default();
    };
    let [columns, rows] = SIZE;
    // As the programs have it: π/3 is another number in its last digit.
    let camera = Camera::new(columns, rows, 60_f64.to_radians());
    let pixels = PICTURES[k](&camera, 1).into_raw();
    let size = json::Json::list(SIZE.map(|side| f64::from(side).into()));
    Answer { text: json::object([("size", size)]), pixels }
}
