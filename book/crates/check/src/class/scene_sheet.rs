//! Sheets: the numbers of the scene that belongs to a name, from which a student writes it in
//! Rust, and problems on paper with these numbers.

use crate::changed_number::{format_numbers, owner_names};
use crate::class::report::align;
use crate::class::student::normalize_name;
use crate::comparison::scattered_places;
use crate::drawing::{Drawing, ObjectHit};
use crate::wrong_pixel::{computed_values, format_number, format_vector};
use crate::{escape_for_terminal, read_bounded_file};
use course::{NAMED_SCENE_EXAMPLE, Owner, QUANTITIES, camera, fnv_1a};
use std::path::Path;
use std::{fs, iter};
use step05_phong::{Object, Ray};

/// The sheet of a name, in Markdown.
pub fn format_sheet(name: &str, has_answers: bool) -> String {
    let drawing = Drawing::of_name(name);
    let tables = [Owner::Object, Owner::Light, Owner::Scene];
    let numbers = tables.map(|owner| number_table(&drawing, owner)).join("\n");
    // Spellings of a name that have one scene have one pixel.
    let skipped = fnv_1a(numbers.bytes()) % 10_000;
    format!(
        "# The scene of {}\n\n{numbers}\n\
         The colour is R_a and R_d, and the camera is that of the five steps. As a program, this \
         is {NAMED_SCENE_EXAMPLE}.rs, an example of step 5.\n\n\
         Name: ______________________________  Points: _____ of 12\n\n\
         Work with six decimals, and give four.\n\n{}",
        escape_for_terminal(name.trim()),
        problems(&drawing, skipped as usize, has_answers).unwrap_or_default()
    )
}

/// A table of all numbers of the objects, the lights or the scene, indented as Markdown has code,
/// with a minus as Rust has it.
fn number_table(drawing: &Drawing, owner: Owner) -> String {
    let quantities = || QUANTITIES.iter().filter(|one| one.owner == owner && !one.needs_mirrors);
    let names = owner_names(drawing, owner).into_iter().enumerate();
    let rows = names.map(|(k, name)| {
        let numbers = quantities().map(|one| {
            format_numbers(&(one.get)(&drawing.own, k)[..one.numbers.len()]).replace('−', "-")
        });
        iter::once(name).chain(numbers).collect()
    });
    let head = iter::once("").chain(quantities().map(|one| one.name)).map(str::to_owned);
    let rows: Vec<_> = iter::once(head.collect()).chain(rows).collect();
    align(&rows).lines().map(|line| format!("    {line}\n")).collect()
}

/// Problems on a pixel that shows a ball; each number of pixels to skip chooses one.
fn problems(drawing: &Drawing, skipped: usize, has_answers: bool) -> Option<String> {
    let ((i, j), ray, hit) = find_lit_pixel(drawing, skipped)?;
    let Object { name, sphere, .. } = &drawing.own.scene.objects[hit.object];
    let mut text = format!(
        "1. What's the V of the pixel in column {i} and row {j}?\n\
         2. What are a, b and c of its ray and {name}?\n\
         3. What's D, and at which t does the ray first meet {name}?\n\
         4. What's the normal n at this point?\n\
         5. What are n·l and d there, for each of the two lights?\n\
         6. What are I_a, I_d and I_s there, in red?\n"
    );
    if has_answers {
        let (a, b, c) = sphere.coefficients(&ray);
        let [a, b, c, d] = [a, b, c, b * b - 4.0 * a * c].map(format_number);
        let v = format_vector(ray.direction);
        let values = computed_values(drawing, &ray, Some(hit));
        text += &format!("\n## Answers\n\nV = {v}; a = {a}, b = {b}, c = {c}, D = {d}{values}\n");
    }
    Some(text)
}

/// A pixel that shows a ball with some of the first light's highlight, and not its edge, where D
/// loses digits.
fn find_lit_pixel(drawing: &Drawing, skipped: usize) -> Option<((u32, u32), Ray, ObjectHit)> {
    let (camera, scene) = (camera(), &drawing.own.scene);
    let mut places = scattered_places((camera.h_res, camera.v_res)).skip(skipped);
    places.find_map(|(i, j)| {
        let ray = camera.ray(i.into(), j.into());
        let hit = drawing.visible_hit(&ray)?;
        let object = &scene.objects[hit.object];
        let (a, b, c) = object.sphere.coefficients(&ray);
        let light = drawing.light_terms_at_hit(&ray, hit, &scene.lights[0]);
        let is_lit = 0.1 < light.diffuse.x && 0.01 < light.specular.x;
        let is_found = object.name != "ground" && 1.0 < b * b - 4.0 * a * c && is_lit;
        is_found.then_some(((i, j), ray, hit))
    })
}

/// The names in a list, one a line.
pub fn read_names(list: &Path) -> Result<Vec<String>, String> {
    let text = String::from_utf8(read_bounded_file(list)?);
    let text = text.map_err(|_| format!("{} is not in UTF-8", list.display()))?;
    let names = text.trim_start_matches('\u{feff}').lines().map(str::trim);
    Ok(names.filter(|name| !name.is_empty()).map(normalize_name).collect())
}

/// Writes the sheet of each name into a file of this name, and tells where.
pub fn write_sheets(names: &[String], has_answers: bool, folder: &Path) -> Result<String, String> {
    let unwritten = |path: &Path, error| format!("{} can't be written: {error}", path.display());
    fs::create_dir_all(folder).map_err(|error| unwritten(folder, error))?;
    let sheets = names.iter().map(|name| {
        let is_odd = |c: char| c.is_control() || "./\\:*?\"<>|".contains(c);
        let file = folder.join(format!("{}.md", name.replace(is_odd, "_")));
        let written = fs::write(&file, format_sheet(name, has_answers));
        written.map_err(|error| unwritten(&file, error))?;
        let line = format!("{name}: {}", file.display());
        Ok(escape_for_terminal(&line) + "\n")
    });
    sheets.collect()
}
