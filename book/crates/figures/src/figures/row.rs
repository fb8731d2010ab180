use crate::{
    Drawing, Handle, Interactive, Numbers, Output, Parameter, View, array, collect_numbers,
    format_number,
};
use course::examples::row::Row;
use glam::{DVec2, dvec2};

/// The place of C in the drawing.
const ORIGIN: DVec2 = dvec2(240.0, 294.0);

/// A row of rays in 2D, with V_0 and D.
pub struct RowFigure {
    row: Row,
    rays: f64,
    /// The field of view in degrees.
    degrees: f64,
}

impl RowFigure {
    /// The map to the drawing; a wide row is drawn smaller.
    fn view(&self) -> View {
        let tan = self.row.direction(0.0).x.abs();
        View { origin: ORIGIN, scale: DVec2::splat(205.0 * (0.84 / tan).min(1.0)) }
    }
}

impl Interactive for RowFigure {
    const NAME: &str = "row";
    const TITLE: &str = "Seven rays fan out from the point C through a line at distance 1. An arrow V0 goes from C to the leftmost point on the line, and arrows D step along the line from each point to the next.";
    const CAPTION: &str = "Follow $V_0$ to the first pixel; from there, every step $D$ leads to the next ray. \
                  Here, $\\mathit{hRes} = {{#number row:hRes}}$, $\\theta = {{#number row:angle}}°$ and $D = ({{#number row:D}}, 0)$. \
                  <span class='move'>Drag the tip of $V_0$ to make the view wider, and add rays.</span>";

    fn parameters() -> Vec<Parameter> {
        vec![
            Parameter::new(["hRes", "rays", ""], 7.0, [2.0, 25.0], 1.0),
            Parameter::new(["θ", "field of view", "°"], 60.0, [10.0, 150.0], 1.0),
            Parameter::switch("divide the width by hRes, not by hRes − 1", false),
        ]
    }

    fn from_values(values: &[f64]) -> Self {
        let [rays, degrees, divisor] = array(values);
        let mut row = Row::new(rays as u32, degrees.to_radians());
        // D divides by hRes − 1 if `divisor` is 0, and by hRes if it is 1.
        row.matrix.x_axis *= (rays - 1.0) / (rays - 1.0 + divisor);
        Self { row, rays, degrees }
    }

    fn handles() -> Vec<Handle> {
        let words = "the tip of V0, which opens the field of view";
        let tip = |figure: &Self| figure.view().to_drawing(figure.row.direction(0.0));
        let fov_at = |figure: &Self, place| 2.0 * figure.view().degrees_left_of_up(place);
        vec![Self::handle_of_one(words, 1, tip, fov_at)]
    }

    fn draw(&self) -> Output {
        let (row, view) = (&self.row, self.view());
        let last = self.rays as usize - 1;
        let c = ORIGIN;
        let directions: Vec<DVec2> = (0..=last).map(|i| row.direction(i as f64)).collect();
        let tips: Vec<DVec2> = directions.iter().map(|&v| view.to_drawing(v)).collect();
        let mut drawing = Drawing::new(480.0, 332.0);
        let tan = -directions[0].x;
        let side = (1.02 * tan).max(0.86);
        drawing.line("plane", view.xy_to_drawing(-side, 1.0), view.xy_to_drawing(side, 1.0));
        drawing.line("guide", c, view.xy_to_drawing(0.0, 1.0));
        for &v in &directions[1..] {
            drawing.line("ray faint", c, view.to_drawing(1.28 * v));
        }
        let v_0 = directions[0];
        drawing.line("ray faint", tips[0], view.to_drawing(1.28 * v_0));
        for tip in &tips {
            drawing.dot("ray", *tip);
        }
        drawing.arc("angle", c, 54.0, [directions[last].to_angle(), v_0.to_angle()]);
        drawing.label("", c + dvec2(13.0, -64.0), "$θ$");
        drawing.arrow("vector", c, tips[0]);
        let steps = || tips.windows(2).take(2);
        for step in steps() {
            drawing.arrow("accent", step[0], step[1]);
        }
        let middle = steps().next_back().map_or(c, |step| (step[0] + step[1]) / 2.0);
        drawing.label("accent over", middle + dvec2(0.0, -10.0), "$D$");
        let middle = view.to_drawing(0.55 * v_0);
        drawing.label_ending_at("strong", middle + dvec2(-14.0, 4.0), "$V_0$");
        let has_room = 36.0 < tips[1].x - tips[0].x;
        for i in (0..=last).filter(|i| [0, last].contains(i) || *i < 3 && has_room) {
            let end = view.to_drawing(1.28 * directions[i]);
            drawing.label("quiet", end + dvec2(0.0, -8.0), &format!("$i$ = {i}"));
        }
        if self.degrees <= 75.0 {
            let right = view.xy_to_drawing(side, 1.0) + dvec2(-14.0, 20.0);
            drawing.label_starting_at("quiet", right, "image plane");
        }
        drawing.dot("eye", c);
        drawing.label("strong", c + dvec2(0.0, 26.0), "$C$");
        let corner = view.xy_to_drawing(tan, 0.0);
        drawing.line("guide", view.xy_to_drawing(tan, 1.0), corner);
        drawing.line("guide", c, corner);
        let label = view.xy_to_drawing(tan, 0.5) + dvec2(10.0, 5.0);
        drawing.label_starting_at("quiet", label, "1");
        let label = view.xy_to_drawing(tan / 2.0, 0.0) + dvec2(6.0, 22.0);
        drawing.label("quiet", label.max(c + dvec2(46.0, 0.0)), "tan($θ$/2)");
        Output::Drawing(drawing)
    }

    fn numbers(&self) -> Numbers {
        let Self { row, rays, degrees } = self;
        collect_numbers([
            ("hRes", format_number(*rays)),
            ("angle", format_number(*degrees)),
            ("D", format_number(row.matrix.x_axis.x)),
        ])
    }
}
