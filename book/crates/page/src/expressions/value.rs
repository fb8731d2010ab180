use crate::expressions::steps::step04_diffuse::Attenuation;
use glam::DVec3;

/// A type of the steps whose values an expression computes with. Each is packed into a vector:
/// a number is one three times, and true is 1.
pub trait Value {
    /// The vector that stands for it.
    fn pack(self) -> DVec3;
    /// The value that a vector stands for.
    fn unpack(vector: DVec3) -> Self;
}

/// The vector that stands for a value.
pub fn pack(value: impl Value) -> DVec3 {
    value.pack()
}

macro_rules! value {
    ($type:ty, $pack:expr, $unpack:expr) => {
        impl Value for $type {
            fn pack(self) -> DVec3 {
                $pack(self)
            }
            fn unpack(vector: DVec3) -> Self {
                $unpack(vector)
            }
        }
    };
}

value!(DVec3, |vector| vector, |vector| vector);
value!(f64, DVec3::splat, |vector: DVec3| vector.x);
value!(i32, |whole| DVec3::splat(f64::from(whole)), |vector: DVec3| vector.x as i32);
value!(u32, |whole| DVec3::splat(f64::from(whole)), |vector: DVec3| vector.x as u32);
value!(bool, |truth| DVec3::splat(f64::from(truth)), |vector: DVec3| vector.x != 0.0);
value!(Attenuation, |Attenuation { a, b, c }| DVec3::new(a, b, c), |DVec3 { x: a, y: b, z: c }| {
    Attenuation { a, b, c }
});
