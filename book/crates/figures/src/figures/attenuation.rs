use crate::output::collect_numbers;
use crate::parameter::array;
use crate::{Drawing, Interactive, Numbers, Output, Parameter, View, format_number};
use glam::{DVec2, dvec2};
use step04_diffuse::{Attenuation, WARM};

/// The light at the distance `d`, as a multiple of L_d.
fn light_share(attenuation: &Attenuation, d: f64) -> f64 {
    1.0 / attenuation.divisor(d)
}

/// The smallest a that the reader may set: with it, the light begins at the top.
const SMALLEST_A: f64 = 0.5;

/// The light at each distance, for an a, b and c that the reader sets.
pub struct AttenuationFigure(Attenuation);

impl Interactive for AttenuationFigure {
    const NAME: &str = "attenuation";
    const TITLE: &str = "Curves of 1 / (a + bd + cd²) over the distance d: constant for a alone, falling slowly with b, fast with c; the curve of the scene's warm light begins above them.";
    const CAPTION: &str = "What a light gives at the distance $d$, in units of its $L_d$. With $a$ \
                  alone it never fades. With $b$ it fades fastest near the light. With $c$ it hardly fades there, \
                  but far away it fades most. The curve of the warm light<span class='move'>, until you change it,</span> \
                  has some of each, and begins above 1; at $d = 6$ it gives {{#number attenuation:share}}.";

    fn parameters() -> Vec<Parameter> {
        let Attenuation { a, b, c } = WARM.attenuation;
        [("a", a, 2.0, 20.0), ("b", b, 1.0, 100.0), ("c", c, 0.5, 200.0)]
            .map(|(symbol, default, max, steps)| {
                let min = if symbol == "a" { SMALLEST_A } else { 0.0 };
                Parameter::new([symbol, "of your curve", ""], default, [min, max], steps)
            })
            .into()
    }

    fn from_values(values: &[f64]) -> Self {
        let [a, b, c] = array(values);
        Self(Attenuation { a, b, c })
    }

    fn draw(&self) -> Output {
        let Self(reader_attenuation) = self;
        let view = View { origin: dvec2(56.0, 230.0), scale: dvec2(24.0, 100.0) };
        let mut drawing = Drawing::new(480.0, 280.0);
        for share in [0.5, 1.0, 1.5, 2.0] {
            drawing.line("grid", view.xy_to_drawing(0.0, share), view.xy_to_drawing(14.0, share));
            drawing.label_ending_at(
                "quiet",
                view.xy_to_drawing(0.0, share) + dvec2(-8.0, 5.0),
                &format!("{share}"),
            );
        }
        for d in [2.0, 4.0, 6.0, 8.0, 10.0, 12.0] {
            let place = view.xy_to_drawing(d, 0.0) + dvec2(0.0, 22.0);
            drawing.label("quiet", place, &format!("{d}"));
        }
        drawing.arrow("axis", view.origin, view.xy_to_drawing(14.4, 0.0));
        drawing.arrow("axis", view.origin, view.xy_to_drawing(0.0, 2.16));
        let from_1 = |b, c| Attenuation { a: 1.0, b, c };
        let is_warm = *reader_attenuation == WARM.attenuation;
        // The name stands beside the curve, or where every curve begins.
        let (name, name_d, shift) =
            if is_warm { ("the warm light", 4.2, -10.0) } else { ("your curve", 0.3, -8.0) };
        let curves = [
            (from_1(0.0, 0.0), 9.0, -8.0, "$a$ = 1"),
            (from_1(0.2, 0.0), 6.0, -8.0, "$a$ = 1, $b$ = 0.2"),
            (from_1(0.0, 0.1), 0.4, 88.0, "$a$ = 1, $c$ = 0.1"),
            (*reader_attenuation, name_d, shift, name),
        ];
        for (k, (attenuation, d, shift, text)) in curves.into_iter().enumerate() {
            let class = &format!("curve curve-{}", k + 1);
            let share = |d: f64| light_share(&attenuation, d);
            let points: Vec<DVec2> = (0..=100)
                .map(|k| f64::from(k) * 0.14)
                .map(|d| view.xy_to_drawing(d, share(d)))
                .collect();
            drawing.path(class, &points);
            let place = view.xy_to_drawing(d, share(d)) + dvec2(0.0, shift);
            drawing.label_starting_at(class, place, text);
        }
        drawing.label("", view.xy_to_drawing(14.0, 0.0) + dvec2(4.0, 22.0), "$d$");
        drawing.into()
    }

    fn numbers(&self) -> Numbers {
        collect_numbers([("share", format_number(light_share(&self.0, 6.0)))])
    }
}
