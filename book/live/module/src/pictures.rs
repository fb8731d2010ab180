use check::Locked;
use image::RgbImage;
use std::sync::OnceLock;
use step01_rays::{Camera, picture as step01_rays};
use step02_sphere::picture as step02_sphere;
use step03_nearest::picture as step03_nearest;
use step04_diffuse::picture as step04_diffuse;
use step05_phong::picture as step05_phong;

/// The examples of the steps that have a picture of their own.
macro_rules! exercises {
    ($($name:ident in $path:literal)*) => {
        $(
            #[path = $path]
            #[allow(dead_code, reason = "the main of an example runs as a program only")]
            mod $name;
        )*
    };
}

exercises! {
    gradient in "../../../../steps/step01_rays/examples/gradient.rs"
    graticule in "../../../../steps/step01_rays/examples/graticule.rs"
    look_at in "../../../../steps/step01_rays/examples/look_at.rs"
    panorama in "../../../../steps/step01_rays/examples/panorama.rs"
    rings in "../../../../steps/step01_rays/examples/rings.rs"
    disc in "../../../../steps/step02_sphere/examples/disc.rs"
    lens in "../../../../steps/step02_sphere/examples/lens.rs"
    plane in "../../../../steps/step02_sphere/examples/plane.rs"
    quadric in "../../../../steps/step02_sphere/examples/quadric.rs"
    all_hits in "../../../../steps/step03_nearest/examples/all_hits.rs"
    depth in "../../../../steps/step03_nearest/examples/depth.rs"
    jitter in "../../../../steps/step03_nearest/examples/jitter.rs"
    many in "../../../../steps/step03_nearest/examples/many.rs"
    my_scene in "../../../../steps/step03_nearest/examples/my_scene.rs"
    gamma in "../../../../steps/step04_diffuse/examples/gamma.rs"
    normals in "../../../../steps/step04_diffuse/examples/normals.rs"
    plaster in "../../../../steps/step04_diffuse/examples/plaster.rs"
    shadows in "../../../../steps/step04_diffuse/examples/shadows.rs"
    snowman in "../../../../steps/step04_diffuse/examples/snowman.rs"
    spot in "../../../../steps/step04_diffuse/examples/spot.rs"
    sun in "../../../../steps/step04_diffuse/examples/sun.rs"
    glass in "../../../../steps/step05_phong/examples/glass.rs"
    halfway in "../../../../steps/step05_phong/examples/halfway.rs"
    marbles in "../../../../steps/step05_phong/examples/marbles.rs"
    mirror in "../../../../steps/step05_phong/examples/mirror.rs"
}

type Picture = fn(&Camera, u32) -> RgbImage;

/// The name of each picture of the course, and what draws it, in the order of `check`.
const PICTURES: &[(&str, Picture)] = &[
    ("step01_rays", step01_rays),
    ("step02_sphere", step02_sphere),
    ("step03_nearest", step03_nearest),
    ("step04_diffuse", step04_diffuse),
    ("step05_phong", step05_phong),
    ("gradient", |_, _| gradient::picture()),
    ("graticule", graticule::picture),
    ("look_at", look_at::picture),
    ("panorama", panorama::picture),
    ("rings", rings::picture),
    ("disc", |camera, _| disc::picture(camera)),
    ("lens", lens::picture),
    ("plane", plane::picture),
    ("quadric", quadric::picture),
    ("all_hits", all_hits::picture),
    ("depth", depth::picture),
    ("jitter", jitter::picture),
    ("many", many::picture),
    ("my_scene", my_scene::picture),
    ("gamma", gamma::picture),
    ("normals", normals::picture),
    ("plaster", plaster::picture),
    ("shadows", shadows::picture),
    ("snowman", snowman::picture),
    ("spot", spot::picture),
    ("sun", sun::picture),
    ("glass", glass::picture),
    ("halfway", halfway::picture),
    ("marbles", marbles::picture),
    ("mirror", mirror::picture),
];

/// The names of the pictures, in this order.
pub fn names() -> impl Iterator<Item = &'static str> + Clone {
    PICTURES.iter().map(|(name, _)| *name)
}

/// The picture `name`, drawn by the course's own code.
pub fn drawn(name: &str) -> Option<Locked> {
    // As the programs have it: π/3 is another number in its last digit.
    let camera = Camera::new(640, 360, 60_f64.to_radians());
    let (name, picture) = PICTURES.iter().find(|(known, _)| *known == name)?;
    Some(Locked { name: (*name).to_owned(), picture: picture(&camera, 1) })
}

/// All of them, which are drawn once.
pub fn locked() -> &'static [Locked] {
    static ALL: OnceLock<Vec<Locked>> = OnceLock::new();
    ALL.get_or_init(|| names().filter_map(drawn).collect())
}
