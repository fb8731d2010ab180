use crate::Step;
use crate::scene::Scene;
use step05_phong::Matte;

/// One or three numbers of each object or of each light, which stand in one place of a
/// file.
pub(crate) struct Quantity {
    /// What it is of its owner; nothing where it is the owner's place.
    pub name: &'static str,
    /// Whose it is.
    pub owner: Owner,
    /// The first step that has it.
    pub since: Step,
    /// Such as `step03_nearest/objects.rs`.
    pub file: &'static str,
    /// How many numbers of the three it has.
    pub count: usize,
    /// What a reader may have typed: multiples of 1 / the last number, from the first
    /// number to the second.
    pub range: (i32, i32, i32),
    /// Reads that of owner k.
    pub get: fn(&Scene, usize) -> [f64; 3],
    /// Changes it.
    pub set: fn(&mut Scene, usize, [f64; 3]),
}

/// Who has a quantity.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Owner {
    Object,
    Light,
    Scene,
}

/// As most of them are: a colour of an object.
const COLOUR: Quantity = Quantity {
    name: "the colour of ",
    owner: Owner::Object,
    since: Step::Nearest,
    file: "step03_nearest/objects.rs",
    count: 3,
    range: (0, 5, 100),
    get: |scene, k| scene.objects[k].material.matte.diffuse.into(),
    set: |scene, k, v| {
        scene.objects[k].material.matte = Matte::of(v.into());
    },
};

/// All numbers of the scenes.
pub(crate) const QUANTITIES: [Quantity; 10] = [
    Quantity {
        name: "",
        since: Step::Sphere,
        range: (-50, 50, 100),
        get: |scene, k| scene.objects[k].sphere.centre.into(),
        set: |scene, k, v| scene.objects[k].sphere.centre = v.into(),
        ..COLOUR
    },
    Quantity {
        name: "the radius of ",
        since: Step::Sphere,
        count: 1,
        range: (0, 60, 100),
        get: |scene, k| [scene.objects[k].sphere.radius; 3],
        set: |scene, k, [r, ..]| scene.objects[k].sphere.radius = r,
        ..COLOUR
    },
    COLOUR,
    Quantity {
        name: "R_s of ",
        since: Step::Phong,
        file: "step05_phong/scene.rs",
        count: 1,
        get: |scene, k| scene.objects[k].material.specular.into(),
        set: |scene, k, v| scene.objects[k].material.specular = v.into(),
        ..COLOUR
    },
    Quantity {
        name: "n of ",
        since: Step::Phong,
        file: "step05_phong/scene.rs",
        count: 1,
        range: (0, 1000, 1),
        get: |scene, k| [scene.objects[k].material.shininess.into(); 3],
        set: |scene, k, [n, ..]| scene.objects[k].material.shininess = n as i32,
        ..COLOUR
    },
    Quantity {
        name: "L_a of ",
        owner: Owner::Scene,
        get: |scene, _| scene.ambient_light.into(),
        set: |scene, _, v| scene.ambient_light = v.into(),
        ..DIFFUSE
    },
    Quantity {
        name: "",
        range: (-20, 20, 100),
        get: |scene, k| scene.lights[k].point_light.position.into(),
        set: |scene, k, v| scene.lights[k].point_light.position = v.into(),
        ..DIFFUSE
    },
    DIFFUSE,
    Quantity {
        name: "(a, b, c) of ",
        range: (0, 20, 1000),
        get: |scene, k| {
            let attenuation = scene.lights[k].point_light.attenuation;
            [attenuation.a, attenuation.b, attenuation.c]
        },
        set: |scene, k, [a, b, c]| {
            scene.lights[k].point_light.attenuation =
                step05_phong::Attenuation { a, b, c };
        },
        ..DIFFUSE
    },
    Quantity {
        name: "L_s of ",
        since: Step::Phong,
        file: "step05_phong/scene.rs",
        get: |scene, k| scene.lights[k].specular.into(),
        set: |scene, k, v| scene.lights[k].specular = v.into(),
        ..DIFFUSE
    },
];

/// As most of a light's are.
const DIFFUSE: Quantity = Quantity {
    name: "L_d of ",
    owner: Owner::Light,
    since: Step::Diffuse,
    file: "step04_diffuse/scene.rs",
    get: |scene, k| scene.lights[k].point_light.diffuse.into(),
    set: |scene, k, v| scene.lights[k].point_light.diffuse = v.into(),
    ..COLOUR
};
