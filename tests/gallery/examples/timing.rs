//! scratch
use gallery::*;
fn main() {
    let dir = std::path::Path::new("target/try");
    for (k, m) in ["half-a-pixel", "square-view", "no-exponent", "nearer-root"]
        .into_iter()
        .enumerate()
    {
        if let Some(m) = mistakes().find(|x| x.name == m) {
            for s in [1, 2, 3] {
                let mut parts = Parts::right(&camera(320, 180));
                (m.change)(&mut parts);
                parts.scene.lights[0].specular *= 0.9;
                if k == 0 {
                    parts.scene.lights[0].point.diffuse *= 0.95;
                }
                parts
                    .picture(Step::Phong, s)
                    .save(dir.join(format!("sc-{}-{}.png", m.name, s)))
                    .unwrap();
            }
        }
    }
}
