//! A worksheet about the scene that is generated from a name. The sheet lists the scene's numbers,
//! so that a student can type these numbers in Rust. The sheet also sets problems about the scene,
//! to be solved on paper.

use crate::changed_number::{format_quantity, owner_names};
use crate::class::table::align_columns;
use crate::class::write_folder::{NewFile, WriteFolderError, write_new_folder};
use crate::comparison::scattered_positions;
use crate::escape_for_terminal;
use crate::number_format::{format_four_decimals, format_vector_four_decimals};
use crate::step_scene::{ObjectHit, StepScene};
use course::{
    GROUND, Owner, QUANTITIES, Quantity, camera, discriminant, escape_html, fnv_1a,
    is_terminal_control,
};
use std::collections::HashMap;
use std::fmt::Write;
use std::iter;
use std::path::Path;
use step05_phong::{Ray, Terms};
use thiserror::Error;

/// The file with all sheets, one per page.
const SHEETS_FILE: &str = "sheets.html";

/// The file with the answers to the problems of all sheets.
const ANSWERS_FILE: &str = "answers.html";

const STYLE: &str = "body { font-family: sans-serif; font-size: 10pt; margin: 1.5cm }
table { border-collapse: collapse; margin: 0.8em 0 }
th, td { padding: 0.1em 0.8em 0.1em 0; text-align: left; font-weight: normal }
li { margin: 0.4em 0 }
.sheets section { break-after: page }
.answers section { break-inside: avoid }
";

/// Why no sheets were written. The names are escaped for a terminal.
#[derive(Debug, Error)]
pub enum SheetError {
    /// A name is in the list twice.
    #[error("{0} is in the list twice, and each name has one sheet")]
    Twice(String),
    /// The sheets of two names would have the same file name.
    #[error("the sheets of {first} and {second} would both be written to {file}")]
    SameFile {
        /// The name that comes first in the list.
        first: String,
        /// The name that comes second in the list.
        second: String,
        /// The file name.
        file: String,
    },
    /// The folder can't be written.
    #[error(transparent)]
    Write(#[from] WriteFolderError),
}

/// The contents of the sheet for one name.
struct SceneSheet {
    name: String,
    /// Three tables: for the objects, for the lights and for the scene. The first row of each table
    /// consists of the headings.
    tables: Vec<Vec<Vec<String>>>,
    instructions: Vec<String>,
    problems: Vec<String>,
    answers: Vec<String>,
}

/// The pixel that a sheet's problems ask about.
struct ProblemPixel {
    position: (u32, u32),
    ray: Ray,
    /// The first hit on each ball that the ray meets, in the order of the scene's objects.
    balls: Vec<ObjectHit>,
    /// The hit that the pixel shows.
    visible: ObjectHit,
}

/// Formats the sheet for a name as Markdown. If there is a secret word, the scene is generated from
/// the name and this word, so nobody can generate the scene from the name alone.
pub fn format_sheet(name: &str, secret: Option<&str>) -> String {
    SceneSheet::new(name, secret).to_markdown()
}

/// Writes the sheets for a class to a folder that doesn't exist yet. There is one file for each
/// name, and one file with all sheets, for printing. `with_answers` adds a file with the answers.
/// If any file can't be written, the folder isn't created. Returns lines that list the files.
pub fn write_sheets(
    names: &[String],
    secret: Option<&str>,
    with_answers: bool,
    folder: &Path,
) -> Result<String, SheetError> {
    let mut files = vec![];
    let mut names_of_files = HashMap::new();
    let sheets: Vec<_> = names.iter().map(|name| SceneSheet::new(name, secret)).collect();
    for (name, sheet) in iter::zip(names, &sheets) {
        let file = file_name(name);
        // Some file systems ignore case.
        if let Some(earlier_name) = names_of_files.insert(file.to_lowercase(), name) {
            let [first, second] = [earlier_name, name].map(|name| escape_for_terminal(name));
            return Err(match first == second {
                true => SheetError::Twice(first),
                false => SheetError::SameFile { first, second, file },
            });
        }
        files.push(NewFile { name: file, text: sheet.to_markdown() });
    }
    let text = html_page("sheets", sheets.iter().map(SceneSheet::to_html));
    files.push(NewFile { name: SHEETS_FILE.to_owned(), text });
    if with_answers {
        let text = html_page("answers", sheets.iter().map(SceneSheet::answers_to_html));
        files.push(NewFile { name: ANSWERS_FILE.to_owned(), text });
    }
    Ok(write_new_folder(folder, &files)?)
}

/// Returns the file name of a sheet, with `_` in place of characters that file systems reject or
/// terminals interpret.
fn file_name(name: &str) -> String {
    let is_refused = |c: char| is_terminal_control(c) || "./\\:*?\"<>|".contains(c);
    format!("{}.md", name.replace(is_refused, "_"))
}

impl SceneSheet {
    fn new(name: &str, secret: Option<&str>) -> Self {
        let scene_name = match secret {
            Some(secret) => format!("{name} {secret}"),
            None => name.to_owned(),
        };
        let scene = StepScene::of_generated_scene(&scene_name);
        let tables = [Owner::Object, Owner::Light, Owner::Scene]
            .map(|owner| number_table(&scene, owner))
            .to_vec();
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
        // Derive the pixel from the numbers instead of the name. Then, if two spellings of a name
        // give the same scene, they also give the same pixel.
        let pixels_to_skip = fnv_1a(tables.concat().concat().concat().bytes()) % 10_000;
        let pixel = find_problem_pixel(&scene, pixels_to_skip as usize);
        let (problems, answers) =
            pixel.map(|pixel| pixel.problems_and_answers(&scene)).unwrap_or_default();
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
            // Indent the lines. Indented lines are code in Markdown, so the columns stay aligned.
            let lines = align_columns(table);
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
        html + &numbered_list_html(&self.problems)
    }

    fn answers_to_html(&self) -> String {
        let name = escape_html(&self.name);
        format!("<h2><bdi>{name}</bdi></h2>\n{}", numbered_list_html(&self.answers))
    }
}

/// Builds the table for one kind of owner. For [`Owner::Object`], the table has one row for each
/// object. The numbers have hyphens as minus signs, as in Rust. Leaves out the numbers that matter
/// only if the scene has mirrors.
fn number_table(scene: &StepScene, owner: Owner) -> Vec<Vec<String>> {
    let is_seen =
        |quantity: &&Quantity| !quantity.scalars.iter().any(|scalar| scalar.needs_mirrors);
    let quantities =
        || QUANTITIES.iter().filter(|quantity| quantity.owner == owner).filter(is_seen);
    let names = owner_names(scene, owner).into_iter().enumerate();
    let rows = names.map(|(k, name)| {
        let numbers = quantities().map(|quantity| format_quantity(quantity, &scene.own_scene, k));
        iter::once(name).chain(numbers).collect()
    });
    let head = iter::once("").chain(quantities().map(|quantity| quantity.name)).map(str::to_owned);
    iter::once(head.collect()).chain(rows).collect()
}

/// Finds a pixel that shows a ball with a highlight. Looks for a pixel of kind 1 first, then of
/// kind 2, then of kind 3:
///
/// 1. Both lights are bright on the visible ball, and the ray meets a second ball.
/// 2. Both lights are bright on the visible ball, and the ray meets no other ball.
/// 3. The first light is bright on the visible ball, and the ray meets no other ball.
///
/// The search skips the first `pixels_to_skip` pixels, so that not all sheets ask about the same
/// pixel.
fn find_problem_pixel(scene: &StepScene, pixels_to_skip: usize) -> Option<ProblemPixel> {
    let find = |ball_count: usize, light_count: usize| {
        let camera = camera();
        let pixels = scattered_positions((camera.h_res, camera.v_res));
        let mut pixels_with_balls = pixels.skip(pixels_to_skip).filter_map(|(i, j)| {
            let ray = camera.ray(i.into(), j.into());
            problem_pixel_of_ray(scene, (i, j), ray)
        });
        pixels_with_balls.find(|candidate| {
            candidate.balls.len() == ball_count
                && candidate.is_bright_with_highlight(light_count, scene)
        })
    };
    find(2, 2).or_else(|| find(1, 2)).or_else(|| find(1, 1))
}

/// Returns the pixel at `position` together with all balls that its ray meets. Returns None if the
/// pixel doesn't show a ball. Also returns None if the ray grazes a ball: then the discriminant D
/// is small and has fewer significant digits, so that rounding on paper would spoil the answer.
fn problem_pixel_of_ray(scene: &StepScene, position: (u32, u32), ray: Ray) -> Option<ProblemPixel> {
    let objects = &scene.own_scene.scene.objects;
    let is_ball = |hit: &ObjectHit| hit.object != GROUND;
    let visible = scene.visible_hit(&ray).filter(is_ball)?;
    let balls: Vec<_> = scene.first_hits_on_objects(&ray).filter(is_ball).collect();
    let is_clear = |hit: &ObjectHit| discriminant(&objects[hit.object].sphere, &ray) > 0.5;
    balls.iter().all(is_clear).then_some(ProblemPixel { position, ray, balls, visible })
}

impl ProblemPixel {
    /// Whether each of the first `light_count` lights is bright at the visible point, and whether
    /// these lights together make a highlight at this point.
    fn is_bright_with_highlight(&self, light_count: usize, scene: &StepScene) -> bool {
        let mut sum = Terms::default();
        for light in &scene.own_scene.scene.lights[..light_count] {
            let terms = scene.light_terms_at_hit(&self.ray, self.visible, light);
            if terms.diffuse.x <= 0.05 {
                return false;
            }
            sum += terms;
        }
        sum.specular.x > 0.02
    }

    /// Returns the problems, and their answers in the same order.
    fn problems_and_answers(&self, scene: &StepScene) -> (Vec<String>, Vec<String>) {
        let (objects, lights) = (&scene.own_scene.scene.objects, &scene.own_scene.scene.lights);
        let Self { position: (i, j), ray, balls, visible } = self;
        let name = |hit: &ObjectHit| objects[hit.object].name;
        let names: Vec<_> = balls.iter().map(name).collect();
        let hit_question = match names.len() {
            1 => format!("At which t does the ray first meet {}?", names[0]),
            _ => "At which t does the ray first meet each of them, and which does the pixel show?"
                .to_owned(),
        };
        let p = ray.at(visible.t);
        let normal = step05_phong::normal(&objects[visible.object].sphere, p);
        let terms = scene.terms_at_hit(ray, *visible);
        let coefficients = balls.iter().map(|hit| {
            let sphere = &objects[hit.object].sphere;
            let (a, b, c) = sphere.coefficients(ray);
            let d = discriminant(sphere, ray);
            let [a, b, c, d] = [a, b, c, d].map(format_four_decimals);
            format!("{}: a = {a}, b = {b}, c = {c}, D = {d}", name(hit))
        });
        let hits =
            balls.iter().map(|hit| format!("{}: t = {}", name(hit), format_four_decimals(hit.t)));
        let directions = iter::zip(lights, scene.light_names).map(|(light, name)| {
            let (l, d) = light.point_light.direction_from(p);
            format!(
                "{name}: n·l = {}, d = {}",
                format_four_decimals(normal.dot(l)),
                format_four_decimals(d)
            )
        });
        let [i_a, i_d, i_s] =
            [terms.ambient, terms.diffuse, terms.specular].map(|term| format_four_decimals(term.x));
        let visible_clause = match names.len() {
            1 => String::new(),
            _ => format!(". The pixel shows {}", name(visible)),
        };
        let problems_and_answers = [
            (
                format!("What's the V of the pixel in column {i} and row {j}?"),
                format!("V = {}", format_vector_four_decimals(ray.direction)),
            ),
            (
                format!(
                    "What are a, b, c and D of the pixel's ray and {}?",
                    names.join(", and of the ray and ")
                ),
                join_with_semicolons(coefficients),
            ),
            (hit_question, join_with_semicolons(hits) + &visible_clause),
            (
                "What's the normal n at the point that the pixel shows?".to_owned(),
                format!("n = {}", format_vector_four_decimals(normal)),
            ),
            (
                "What are n·l and d there, for each of the two lights?".to_owned(),
                join_with_semicolons(directions),
            ),
            (
                "What are I_a, and the sums of I_d and of I_s over both lights, at this point and in red?"
                    .to_owned(),
                format!("I_a = {i_a}, I_d = {i_d}, I_s = {i_s}"),
            ),
        ];
        problems_and_answers.into_iter().unzip()
    }
}

fn join_with_semicolons(clauses: impl Iterator<Item = String>) -> String {
    clauses.collect::<Vec<_>>().join("; ")
}

/// Builds a page for printing. `kind` is the title of the page, and selects its style.
fn html_page(kind: &str, sections: impl Iterator<Item = String>) -> String {
    let sections: String = sections.map(|html| format!("<section>\n{html}</section>\n")).collect();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>{kind}</title>\n\
         <style>\n{STYLE}</style>\n<body class=\"{kind}\">\n{sections}</body>\n</html>\n"
    )
}

fn numbered_list_html(items: &[String]) -> String {
    let items: String =
        items.iter().map(|item| format!("<li>{}</li>\n", escape_html(item))).collect();
    format!("<ol>\n{items}</ol>\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn file_name_has_no_characters_that_file_systems_reject() {
        assert_eq!(file_name("Ada Lövelace"), "Ada Lövelace.md");
        assert_eq!(file_name("../a\\b:c\n?"), "___a_b_c__.md");
    }

    #[test]
    fn list_items_are_escaped_for_html() {
        assert_eq!(numbered_list_html(&["<b>".to_owned()]), "<ol>\n<li>&lt;b&gt;</li>\n</ol>\n");
    }

    #[test]
    fn table_has_headings_and_numbers_as_typed_in_rust() {
        let table = number_table(&StepScene::of_generated_scene("ada"), Owner::Object);
        assert_eq!(table[0], ["", "the position", "the radius", "R_s", "n", "the colour"]);
        assert_eq!(table[1][..3], ["ball 1", "(0.65, -0.3, -7.4)", "1.06"]);
    }
}
