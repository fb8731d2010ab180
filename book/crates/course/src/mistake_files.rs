//! The texts of the list: a program has them in it. A page's module gets them from the page, so
//! that an edit of the list compiles no module again.

/// The list of each step, then the table.
#[cfg(not(target_arch = "wasm32"))]
pub fn mistake_texts() -> [&'static str; 6] {
    [
        include_str!("../mistakes/step01_rays.txt"),
        include_str!("../mistakes/step02_sphere.txt"),
        include_str!("../mistakes/step03_nearest.txt"),
        include_str!("../mistakes/step04_diffuse.txt"),
        include_str!("../mistakes/step05_phong.txt"),
        include_str!("../mistakes/table.txt"),
    ]
}

/// Does nothing: a program has the texts.
#[cfg(not(target_arch = "wasm32"))]
pub fn provide_mistake_texts(_joined: &str) {}

#[cfg(target_arch = "wasm32")]
static TEXTS: std::sync::OnceLock<[&str; 6]> = std::sync::OnceLock::new();

/// The list of each step, then the table; empty until the page has provided them.
#[cfg(target_arch = "wasm32")]
pub fn mistake_texts() -> [&'static str; 6] {
    TEXTS.get().copied().unwrap_or_default()
}

/// Takes the texts, with a zero byte between them, once.
#[cfg(target_arch = "wasm32")]
pub fn provide_mistake_texts(joined: &str) {
    TEXTS.get_or_init(|| {
        let mut texts = String::from(joined).leak().split('\0');
        std::array::from_fn(|_| texts.next().unwrap_or_default())
    });
}
