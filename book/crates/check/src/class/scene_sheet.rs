//! Sheets: the numbers of the scene that belongs to a name, from which a student writes it in
//! Rust, and problems on paper with these numbers.

use crate::changed_number::{format_quantity, owner_names};
use crate::class::table::align;
use crate::class::write_folder::{NewFile, write_new_folder};
use crate::comparison::scattered_places;
use crate::drawing::{Drawing, ObjectHit};
use crate::escape_for_terminal;
use crate::wrong_pixel::{format_number, format_vector};
use course::{Owner, QUANTITIES, Quantity, camera, fnv_1a, is_obeyed_by_terminals};
use std::collections::HashMap;
use std::fmt::Write;
use std::iter;
use std::path::Path;
use step05_phong::{Ray, Terms};

/// The files of all sheets on one page each, and of all answers.
const SHEETS_FILE: &str = "sheets.html";
const ANSWERS_FILE: &str = "answers.html";

const STYLE: &str = "body { font-family: sans-serif; font-size: 10pt; margin: 1.5cm }
table { border-collapse: collapse; margin: 0.8em 0 }
th, td { padding: 0.1em 0.8em 0.1em 0; text-align: left; font-weight: normal }
li { margin: 0.4em 0 }
.sheets section { break-after: page }
.answers section { break-inside: avoid }
";

/// What a sheet says.
struct Sheet {
    name: String,
    /// The numbers of the balls, the lights and the scene, each with a row of heads.
    tables: Vec<Vec<Vec<String>>>,
    instructions: Vec<String>,
    problems: Vec<String>,
    answers: Vec<String>,
}

/// A pixel to ask about.
struct Spot {
    place: (u32, u32),
    ray: Ray,
    /// The balls that the ray meets, in the order of their numbers.
    balls: Vec<ObjectHit>,
    /// The hit that the pixel shows.
    visible: ObjectHit,
}

/// The sheet of a name, in Markdown. A secret word chooses another scene of the name.
pub fn format_sheet(name: &str, secret: Option<&str>) -> String {
    Sheet::new(name, secret).to_markdown()
}

/// Writes the sheets of a class into a folder that doesn't exist yet: each into a file of its
/// name, and all into one for printing. All are written, or none.
pub fn write_sheets(
    names: &[String],
    secret: Option<&str>,
    has_answers: bool,
    folder: &Path,
) -> Result<String, String> {
    let mut files = vec![];
    let mut names_of_files = HashMap::new();
    let sheets: Vec<_> = names.iter().map(|name| Sheet::new(name, secret)).collect();
    for (name, sheet) in iter::zip(names, &sheets) {
        let file = file_name(name);
        // Some file systems don't distinguish capitals.
        if let Some(other) = names_of_files.insert(file.to_lowercase(), name) {
            let [name, other] = [name, other].map(|name| escape_for_terminal(name));
            return Err(match name == other {
                true => format!("{name} is in the list twice, and each name has one sheet"),
                false => format!("the sheets of {other} and {name} would have one file, {file}"),
            });
        }
        files.push(NewFile { name: file, text: sheet.to_markdown() });
    }
    let text = html_page("sheets", sheets.iter().map(Sheet::to_html));
    files.push(NewFile { name: SHEETS_FILE.to_owned(), text });
    if has_answers {
        let text = html_page("answers", sheets.iter().map(Sheet::answers_to_html));
        files.push(NewFile { name: ANSWERS_FILE.to_owned(), text });
    }
    write_new_folder(folder, &files)
}

/// The name of a sheet's file, without what file systems refuse and terminals obey.
fn file_name(name: &str) -> String {
    let is_refused = |c: char| is_obeyed_by_terminals(c) || "./\\:*?\"<>|".contains(c);
    format!("{}.md", name.replace(is_refused, "_"))
}

impl Sheet {
    fn new(name: &str, secret: Option<&str>) -> Self {
        let scene_name = match secret {
            Some(secret) => format!("{name} {secret}"),
            None => name.to_owned(),
        };
        let drawing = Drawing::of_name(&scene_name);
        let tables = [Owner::Object, Owner::Light, Owner::Scene];
        let tables: Vec<_> = tables.iter().map(|owner| number_table(&drawing, *owner)).collect();
        let (columns, rows) = (camera().h_res, camera().v_res);
        let instructions = [
            format!(
                "The colour is R_a and R_d. The picture has {columns} columns and {rows} rows, and \
                 θ is 60°, as in the five steps. To draw it, copy the program of the book's page \
                 \"A scene of your own\", and type these numbers."
            ),
            "Name: ______________________________  Points: _____ of 12".to_owned(),
            "Work with six decimals, and give four.".to_owned(),
        ];
        // Spellings of a name that have one scene have one pixel.
        let skipped = fnv_1a(tables.concat().concat().concat().bytes()) % 10_000;
        let spot = find_spot(&drawing, skipped as usize);
        let (problems, answers) = spot.map(|spot| spot.problems(&drawing)).unwrap_or_default();
        Self {
            name: escape_for_terminal(name.trim()),
            tables,
            instructions: instructions.to_vec(),
            problems,
            answers,
        }
    }

    fn to_markdown(&self) -> String {
        let mut markdown = format!("# The scene of {}\n\n", self.name);
        for table in &self.tables {
            // Indented, it is code.
            let lines = align(table);
            markdown.extend(lines.lines().flat_map(|line| ["    ", line, "\n"]));
            markdown += "\n";
        }
        markdown.extend(self.instructions.iter().flat_map(|text| [text, "\n\n"]));
        for (number, problem) in (1..).zip(&self.problems) {
            let _ = writeln!(markdown, "{number}. {problem}");
        }
        markdown
    }

    fn to_html(&self) -> String {
        let mut html = format!("<h1>The scene of <bdi>{}</bdi></h1>\n", escape_html(&self.name));
        for table in &self.tables {
            html += "<table>\n";
            for (number, row) in table.iter().enumerate() {
                let tag = if number == 0 { "th" } else { "td" };
                let cells = row.iter().map(|cell| format!("<{tag}>{}</{tag}>", escape_html(cell)));
                let _ = writeln!(html, "<tr>{}</tr>", cells.collect::<String>());
            }
            html += "</table>\n";
        }
        for text in &self.instructions {
            let _ = writeln!(html, "<p>{}</p>", escape_html(text));
        }
        html + &html_list(&self.problems)
    }

    fn answers_to_html(&self) -> String {
        let name = escape_html(&self.name);
        format!("<h2><bdi>{name}</bdi></h2>\n{}", html_list(&self.answers))
    }
}

/// A table of all numbers of the objects, the lights or the scene, with a minus as Rust has it.
fn number_table(drawing: &Drawing, owner: Owner) -> Vec<Vec<String>> {
    let is_seen = |one: &&Quantity| !one.scalars.iter().any(|scalar| scalar.needs_mirrors);
    let quantities = || QUANTITIES.iter().filter(|one| one.owner == owner).filter(is_seen);
    let names = owner_names(drawing, owner).into_iter().enumerate();
    let rows = names.map(|(k, name)| {
        let numbers =
            quantities().map(|one| format_quantity(one, &drawing.own, k).replace('−', "-"));
        iter::once(name).chain(numbers).collect()
    });
    let head = iter::once("").chain(quantities().map(|one| one.name)).map(str::to_owned);
    iter::once(head.collect()).chain(rows).collect()
}

/// A pixel that shows a ball in the light of both lights, with a highlight, and another ball behind
/// it. If there is none, one ball is enough, and then one light. Each number of pixels to skip
/// chooses one.
fn find_spot(drawing: &Drawing, skipped: usize) -> Option<Spot> {
    let find = |ball_count: usize, light_count: usize| {
        let camera = camera();
        let places = scattered_places((camera.h_res, camera.v_res));
        let mut spots = places.skip(skipped).filter_map(|(i, j)| {
            let ray = camera.ray(i.into(), j.into());
            spot_of_ray(drawing, (i, j), ray)
        });
        spots.find(|spot| {
            spot.balls.len() == ball_count && spot.is_lit_by_first(light_count, drawing)
        })
    };
    find(2, 2).or_else(|| find(1, 2)).or_else(|| find(1, 1))
}

/// The balls on a ray; None if it shows none, or nearly touches one, where D loses digits.
fn spot_of_ray(drawing: &Drawing, place: (u32, u32), ray: Ray) -> Option<Spot> {
    let objects = &drawing.own.scene.objects;
    let is_ball = |hit: &ObjectHit| objects[hit.object].name != "ground";
    let visible = drawing.visible_hit(&ray).filter(is_ball)?;
    let balls: Vec<_> = drawing.object_hits(&ray).filter(is_ball).collect();
    let is_clear = |hit: &ObjectHit| {
        let (a, b, c) = objects[hit.object].sphere.coefficients(&ray);
        b * b - 4.0 * a * c > 0.5
    };
    balls.iter().all(is_clear).then_some(Spot { place, ray, balls, visible })
}

impl Spot {
    /// Whether each of the first lights is bright here, and one has a highlight.
    fn is_lit_by_first(&self, light_count: usize, drawing: &Drawing) -> bool {
        let mut sum = Terms::default();
        for light in &drawing.own.scene.lights[..light_count] {
            let terms = drawing.light_terms_at_hit(&self.ray, self.visible, light);
            if terms.diffuse.x <= 0.05 {
                return false;
            }
            sum += terms;
        }
        sum.specular.x > 0.02
    }

    /// The problems, and the answer to each.
    fn problems(&self, drawing: &Drawing) -> (Vec<String>, Vec<String>) {
        let (objects, lights) = (&drawing.own.scene.objects, &drawing.own.scene.lights);
        let Self { place: (i, j), ray, balls, visible } = self;
        let name = |hit: &ObjectHit| objects[hit.object].name;
        let names: Vec<_> = balls.iter().map(name).collect();
        let nearest = match names.len() {
            1 => format!("At which t does the ray first meet {}?", names[0]),
            _ => "At which t does the ray first meet each of them, and which does the pixel show?"
                .to_owned(),
        };
        let p = ray.at(visible.t);
        let normal = step05_phong::normal(&objects[visible.object].sphere, p);
        let terms = drawing.terms_at_hit(ray, *visible);
        let coefficients = balls.iter().map(|hit| {
            let (a, b, c) = objects[hit.object].sphere.coefficients(ray);
            let [a, b, c, d] = [a, b, c, b * b - 4.0 * a * c].map(format_number);
            format!("{}: a = {a}, b = {b}, c = {c}, D = {d}", name(hit))
        });
        let hits = balls.iter().map(|hit| format!("{}: t = {}", name(hit), format_number(hit.t)));
        let directions = iter::zip(lights, drawing.light_names).map(|(light, name)| {
            let (l, d) = light.point_light.direction_from(p);
            format!("{name}: n·l = {}, d = {}", format_number(normal.dot(l)), format_number(d))
        });
        let [i_a, i_d, i_s] =
            [terms.ambient, terms.diffuse, terms.specular].map(|term| format_number(term.x));
        let visible = match names.len() {
            1 => String::new(),
            _ => format!(". The pixel shows {}", name(visible)),
        };
        let problems_and_answers = [
            (
                format!("What's the V of the pixel in column {i} and row {j}?"),
                format!("V = {}", format_vector(ray.direction)),
            ),
            (
                format!(
                    "What are a, b, c and D of its ray and {}?",
                    names.join(", and of it and ")
                ),
                join(coefficients),
            ),
            (nearest, join(hits) + &visible),
            (
                "What's the normal n at the point that the pixel shows?".to_owned(),
                format!("n = {}", format_vector(normal)),
            ),
            ("What are n·l and d there, for each of the two lights?".to_owned(), join(directions)),
            (
                "What are I_a, and the sums of I_d and of I_s over both lights, there and in red?"
                    .to_owned(),
                format!("I_a = {i_a}, I_d = {i_d}, I_s = {i_s}"),
            ),
        ];
        problems_and_answers.into_iter().unzip()
    }
}

fn join(clauses: impl Iterator<Item = String>) -> String {
    clauses.collect::<Vec<_>>().join("; ")
}

/// A page to print, of a kind that its style knows.
fn html_page(kind: &str, sections: impl Iterator<Item = String>) -> String {
    let sections: String = sections.map(|html| format!("<section>\n{html}</section>\n")).collect();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>{kind}</title>\n\
         <style>\n{STYLE}</style>\n<body class=\"{kind}\">\n{sections}</body>\n</html>\n"
    )
}

fn html_list(items: &[String]) -> String {
    let items: String =
        items.iter().map(|item| format!("<li>{}</li>\n", escape_html(item))).collect();
    format!("<ol>\n{items}</ol>\n")
}

fn escape_html(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
