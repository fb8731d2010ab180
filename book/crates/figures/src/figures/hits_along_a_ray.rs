use crate::{Drawing, Handle, Interactive, Output, Parameter, View, format_fixed};
use glam::{DVec2, DVec3, dvec2};
use step03_nearest::{Object, Ray, Sphere, nearest};

const VIEW: View = View { origin: dvec2(136.0, 100.0), scale: dvec2(46.0, 46.0) };

/// A ray and three spheres that the reader moves, one behind the start.
pub struct HitsAlongARay {
    /// The material of each is its place in the list.
    objects: Vec<Object<usize>>,
}

impl Interactive for HitsAlongARay {
    const NAME: &str = "hits-along-a-ray";
    const TITLE: &str = "A ray from S passes through two spheres in front of it, and its line through a third behind it. The six values of t are marked; the smallest above 0 is the nearest hit.";
    const CAPTION: &str = "Every $t$ on one line. Those below 0 lie behind the start. Of the others, the smallest is the hit \
                  you see. $k$ is the sphere's place in the list; here it doesn't matter. \
                  <span class='move'>Drag another sphere in front.</span>";

    fn parameters() -> Vec<Parameter> {
        [[5.3, 0.35], [-1.5, 0.2], [2.4, -0.3]]
            .into_iter()
            .flat_map(|[x, y]| {
                [
                    Parameter::coordinate(x, [-2.2, 6.2], 20.0),
                    Parameter::coordinate(y, [-1.0, 1.0], 20.0),
                ]
            })
            .collect()
    }

    fn from_values(values: &[f64]) -> Self {
        let centres = values.chunks_exact(2).map(DVec2::from_slice);
        let spheres = centres.zip([1.0, 0.7, 0.8]).enumerate();
        let objects = spheres.map(|(k, (centre, radius))| {
            let sphere = Sphere { centre: centre.extend(0.0), radius };
            Object { name: "sphere", sphere, material: k }
        });
        Self { objects: objects.collect() }
    }

    fn handles() -> Vec<Handle> {
        [0, 1, 2]
            .map(|k| Handle::of_point(&format!("the centre of sphere {k}"), 2 * k, VIEW))
            .into()
    }

    fn draw(&self) -> Output {
        let ray = Ray { start: DVec3::ZERO, direction: DVec3::X };
        let objects = &self.objects;
        let place = |t: f64| VIEW.to_drawing(ray.at(t).truncate());
        let nearest_hit = nearest(objects, &ray);
        let mut drawing = Drawing::new(480.0, 210.0);
        for Object { sphere, material: k, .. } in objects {
            let is_hit = nearest_hit.is_some_and(|hit| hit.object.material == *k);
            let class = if is_hit { "object seen" } else { "object" };
            let centre = VIEW.to_drawing(sphere.centre.truncate());
            let radius = VIEW.scale.x * sphere.radius;
            drawing.circle(class, centre, radius);
            let above = centre - dvec2(0.0, radius + 9.0);
            let label = above.max(dvec2(0.0, 14.0));
            drawing.label("quiet", label, &format!("$k$ = {k}"));
        }
        drawing.line("guide", place(-2.7), place(0.0));
        drawing.arrow("ray", place(0.0), place(7.2));
        drawing.dot("eye", place(0.0));
        drawing.label("strong", place(0.0) + dvec2(0.0, -12.0), "$S$");
        let mut roots: Vec<f64> =
            objects.iter().flat_map(|o| o.sphere.intersect(&ray).iter()).collect();
        roots.sort_by(f64::total_cmp);
        // A label that would lie on another goes below; "t =" is the first.
        let mut label_xs = vec![place(0.0).x];
        for t in roots {
            let class = match nearest_hit {
                Some(hit) if hit.t == t => "hit",
                _ if t < 0.0 => "behind",
                _ => "ray",
            };
            let DVec2 { x, y } = place(t);
            drawing.dot(class, dvec2(x, y));
            drawing.line("leader", dvec2(x, y + 8.0), dvec2(x, 172.0));
            let class = if class == "hit" { "hit" } else { "quiet" };
            let has_room = label_xs.iter().all(|label_x| 27.0 <= (x - label_x).abs());
            let y = if has_room { 190.0 } else { 206.0 };
            if has_room {
                label_xs.push(x);
            }
            drawing.label(class, dvec2(x, y), &format_fixed(t, 1));
        }
        drawing.label("", dvec2(place(0.0).x, 190.0), "$t$ =");
        drawing.into()
    }
}
