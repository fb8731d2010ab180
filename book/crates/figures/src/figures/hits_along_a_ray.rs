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
                  you see. $k$ is the sphere's place in the list, counted from 0; here it doesn't matter. \
                  <span class='move'>Drag another sphere in front.</span>";

    fn parameters() -> Vec<Parameter> {
        let centres = [[5.3, 0.35], [-1.5, 0.2], [2.4, -0.3]];
        let ranges = [[-2.2, 6.2], [-1.0, 1.0]];
        centres.map(|centre| Parameter::point(centre, ranges, 20.0)).concat()
    }

    fn from_values(values: &[f64]) -> Self {
        let centres = values.chunks_exact(2).map(|centre| DVec2::from_slice(centre).extend(0.0));
        let objects = centres.zip([1.0, 0.7, 0.8]).zip(0..).map(|((centre, radius), material)| {
            Object { name: "sphere", sphere: Sphere { centre, radius }, material }
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
        let mut drawing = Drawing::new(480.0, 226.0);
        for Object { sphere, material: k, .. } in objects {
            let is_hit = nearest_hit.is_some_and(|hit| hit.object.material == *k);
            let class = if is_hit { "object seen" } else { "object" };
            let centre = VIEW.to_drawing(sphere.centre.truncate());
            let radius = VIEW.scale.x * sphere.radius;
            drawing.circle(class, centre, radius);
            let label = (centre - dvec2(0.0, radius + 9.0)).max(dvec2(0.0, 14.0));
            drawing.label("quiet", label, &format!("$k$ = {k}"));
        }
        drawing.line("guide", place(-2.7), place(0.0));
        drawing.arrow("ray", place(0.0), place(7.2));
        drawing.dot("eye", place(0.0));
        drawing.label("strong", place(0.0) + dvec2(0.0, -12.0), "$S$");
        let roots = objects.iter().flat_map(|object| object.sphere.intersect(&ray).iter());
        let mut roots: Vec<f64> = roots.collect();
        roots.sort_by(f64::total_cmp);
        // A label that would lie on another goes a row below; "t =" is the first.
        let mut labels = vec![(place(0.0).x, 0)];
        for t in roots {
            let class = match nearest_hit {
                Some(hit) if hit.t == t => "hit",
                _ if t < 0.0 => "behind",
                _ => "ray",
            };
            let root = place(t);
            drawing.dot(class, root);
            drawing.line("leader", root + dvec2(0.0, 8.0), root.with_y(172.0));
            let class = if class == "hit" { "hit" } else { "quiet" };
            let is_near = |x: f64| (root.x - x).abs() < 27.0;
            let is_free = |row: &i32| labels.iter().all(|(x, known)| known != row || !is_near(*x));
            let row = (0..).find(is_free).unwrap_or_default();
            labels.push((root.x, row));
            let label = root.with_y(190.0 + 16.0 * f64::from(row));
            drawing.label(class, label, &format_fixed(t, 1));
        }
        drawing.label("", place(0.0).with_y(190.0), "$t$ =");
        Output::Drawing(drawing)
    }
}
