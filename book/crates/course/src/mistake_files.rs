//! The texts of the list: a program has them in it. A page's module gets them from the page, so
//! that an edit of the list compiles no module again.

use std::array;
use std::sync::OnceLock;

/// What a page has provided.
static PROVIDED: OnceLock<[&str; 6]> = OnceLock::new();

/// The list of each step, then the table; in a module they are empty until the page has provided
/// them.
pub fn mistake_texts() -> [&'static str; 6] {
    if cfg!(target_arch = "wasm32") {
        return PROVIDED.get().copied().unwrap_or_default();
    }
    [
        include_str!("../mistakes/step01_rays.txt"),
        include_str!("../mistakes/step02_sphere.txt"),
        include_str!("../mistakes/step03_nearest.txt"),
        include_str!("../mistakes/step04_diffuse.txt"),
        include_str!("../mistakes/step05_phong.txt"),
        include_str!("../mistakes/table.txt"),
    ]
}

/// Takes the texts of a module, with a zero byte between them, once.
pub fn provide_mistake_texts(joined: &str) {
    PROVIDED.get_or_init(|| {
        let mut texts = String::from(joined).leak().split('\0');
        array::from_fn(|_| texts.next().unwrap_or_default())
    });
}
