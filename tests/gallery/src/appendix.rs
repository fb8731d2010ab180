use crate::{Mistake, Step, mistakes};
use std::fmt::Write;

const HEAD: &str = "# What went wrong?

Your picture is not ours, and you want to know why. Ask in our folder:

```console,ours
$ cargo run --bin check -- ../ray-casting/step03_nearest.png step03_nearest
```

`check` compares every pixel. It knows all the mistakes below, two of them at once, \
and each at any size and with any number of samples. Or look for your picture here. \
Each was drawn by the five steps themselves, with one thing wrong in them, and stands \
under the step in whose picture it is easiest to tell from the others. It stays in all \
pictures after that one, and a few can be seen a step earlier already. So look under the \
steps before and after yours as well.
";

/// The appendix of the book that shows the whole gallery, as Markdown.
///
/// Its pictures have the names that [`Mistake::shown`] gives.
pub fn appendix() -> String {
    let mut text = HEAD.to_owned();
    for step in Step::ALL {
        let title = match step {
            Step::Rays => "Step 1: rays and pixels",
            Step::Sphere => "Step 2: one sphere",
            Step::Nearest => "Step 3: many spheres",
            Step::Diffuse => "Step 4: ambient and diffuse light",
            Step::Phong => "Step 5: highlights and the whole sum",
        };
        let _ = write!(
            text,
            "\n## {title}\n\n![The right picture of step {}.](pictures/{}.png \
             \"What it should be.\")\n",
            step.number(),
            step.name()
        );
        mistakes().filter(|m| m.step == step).for_each(|m| text += &entry(m));
    }
    text
}

fn entry(mistake: &Mistake) -> String {
    let Mistake { when, sees, says, section, .. } = mistake;
    let mut text = format!("\n### {}\n\n", title(when));
    for (step, name) in mistake.shown() {
        let number = step.number();
        let caption = match step == mistake.step {
            true => formulas(sees),
            false => "The same mistake in step 5.".to_owned(),
        };
        let alt =
            format!("The picture of step {number} when {when}.").replace('`', "");
        let _ = writeln!(text, "![{alt}](pictures/{name}.png \"{caption}\")");
    }
    let (heading, chapter) = (section.heading, section.step.name());
    let number = section.step.number();
    let link =
        format!("[step {number}, “{heading}”]({chapter}.md#{})", section.anchor());
    let _ = writeln!(text, "\n{} Go back to {link}.", formulas(says));
    text
}

/// With a capital letter, unless it begins with a symbol.
fn title(when: &str) -> String {
    let word = when.split(' ').next().unwrap_or_default();
    let is_word = 1 < word.len() && word.chars().all(|c| c.is_ascii_lowercase());
    match when.split_at_checked(1) {
        Some((first, rest)) if is_word => first.to_uppercase() + rest,
        _ => when.to_owned(),
    }
}

/// With symbols such as D_u as formulas.
fn formulas(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let is_symbol =
        |k: usize| letters[k].is_uppercase() && letters.get(k + 1) == Some(&'_');
    let formula = |(k, letter): (usize, &char)| match *letter {
        _ if is_symbol(k) => format!("${letter}"),
        _ if 2 <= k && is_symbol(k - 2) => format!("{letter}$"),
        _ => letter.to_string(),
    };
    letters.iter().enumerate().map(formula).collect()
}
