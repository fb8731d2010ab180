#[cfg(feature = "pictures")]
use {
    image::RgbImage,
    live::{Answer, json},
    step01_rays::Camera,
};

/// The pictures of the course, in the order of `check`: the name of each and its
/// [`sum`](crate::sum), the file that draws it where that is an example of a step, and its
/// function.
macro_rules! pictures {
    ($($name:ident $sum:literal $(in $path:literal)?: $picture:expr,)*) => {
        /// The names of the pictures.
        pub const NAMES: &[&str] = &[$(stringify!($name)),*];

        /// The sum of each, by which it is known before it is drawn.
        #[cfg(feature = "check")]
        pub const SUMS: &[u16] = &[$($sum),*];

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
    step01_rays 62896: step01_rays::picture,
    step02_sphere 61472: step02_sphere::picture,
    step03_nearest 56342: step03_nearest::picture,
    step04_diffuse 21624: step04_diffuse::picture,
    step05_phong 63237: step05_phong::picture,
    gradient 12032 in "../../../../steps/step01_rays/examples/gradient.rs": |_, _| gradient::picture(),
    graticule 23996 in "../../../../steps/step01_rays/examples/graticule.rs": graticule::picture,
    look_at 51266 in "../../../../steps/step01_rays/examples/look_at.rs": look_at::picture,
    panorama 56096 in "../../../../steps/step01_rays/examples/panorama.rs": panorama::picture,
    rings 7474 in "../../../../steps/step01_rays/examples/rings.rs": rings::picture,
    disc 61472 in "../../../../steps/step02_sphere/examples/disc.rs": |camera, _| disc::picture(camera),
    lens 48941 in "../../../../steps/step02_sphere/examples/lens.rs": lens::picture,
    plane 18023 in "../../../../steps/step02_sphere/examples/plane.rs": plane::picture,
    quadric 681 in "../../../../steps/step02_sphere/examples/quadric.rs": quadric::picture,
    all_hits 58929 in "../../../../steps/step03_nearest/examples/all_hits.rs": all_hits::picture,
    depth 49651 in "../../../../steps/step03_nearest/examples/depth.rs": depth::picture,
    jitter 56156 in "../../../../steps/step03_nearest/examples/jitter.rs": jitter::picture,
    many 47366 in "../../../../steps/step03_nearest/examples/many.rs": many::picture,
    my_scene 36036 in "../../../../steps/step03_nearest/examples/my_scene.rs": my_scene::picture,
    gamma 31411 in "../../../../steps/step04_diffuse/examples/gamma.rs": gamma::picture,
    normals 21290 in "../../../../steps/step04_diffuse/examples/normals.rs": normals::picture,
    plaster 29051 in "../../../../steps/step04_diffuse/examples/plaster.rs": plaster::picture,
    shadows 9858 in "../../../../steps/step04_diffuse/examples/shadows.rs": shadows::picture,
    snowman 53422 in "../../../../steps/step04_diffuse/examples/snowman.rs": snowman::picture,
    spot 4092 in "../../../../steps/step04_diffuse/examples/spot.rs": spot::picture,
    sun 48637 in "../../../../steps/step04_diffuse/examples/sun.rs": sun::picture,
    glass 30622 in "../../../../steps/step05_phong/examples/glass.rs": glass::picture,
    halfway 8684 in "../../../../steps/step05_phong/examples/halfway.rs": halfway::picture,
    marbles 23630 in "../../../../steps/step05_phong/examples/marbles.rs": marbles::picture,
    mirror 37491 in "../../../../steps/step05_phong/examples/mirror.rs": mirror::picture,
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
    let size = json::Json::list(SIZE.map(json::Json::from));
    Answer { text: json::object([("size", size)]), pixels }
}
