use crate::{Locked, Mistake, Parts, Step, camera, look, mistakes};
use glam::DVec3;
use std::fmt::Write;

const HEAD: &str = "# What went wrong?

Your picture is not ours, and you want to know why.

{{#check}}

In our folder, a program says the same:

```console,ours
$ cargo run --bin check -- ../ray-casting/step05_phong.png
$ cargo run --bin check -- --in ../ray-casting
```

The first command looks at one picture, the second at all that are there. The name of a \
file tells whose picture it should be; another name may stand behind it.

## How to read the answer

A picture is a measurement of the program that drew it. Its sky holds the direction of \
every ray. Its outlines hold the spheres. Its lit pixels are a sum, and how much of each \
term is in it can be read from them. `check` reads \
this back as well as it can. Where it is at odds with your code, it may be wrong: then believe the pixel. Take \
a reader who leaves $L_s$ out of the specular term. The picture looks right; the answer \
begins so:

";

const AFTER: &str = "
Read it from the top.

1. **The first line** is the verdict. It names a mistake only where that explains every \
pixel, or all but a few, which it counts. Here it has no name.
2. **The stages** go from the ray to the byte. A stage is *right* where every pixel that \
shows it agrees, and *WRONG* where the numbers show that. Where a picture can't tell, it \
says why. Look at the first wrong stage: what comes after it is often only its consequence.
3. **The formulas** and numbers are yours, then ours, in the letters of this book. `check` \
changes one place of one formula, draws, and compares: what stands here gives your picture, \
pixel for pixel. Your code need not say it in these words. Here $L_s$ is missing at the \
end. Where several changes give the same picture, each stands on a line that begins with \
*or else*; of these, some six thousand pixels were compared.
4. **Where to look** is the line that computes the stage, and the test that has its \
numbers worked out by hand.

Below that stands one pixel in full, each term by itself, to set beside what your program \
prints there. Last comes a picture: yours, ours, and where they differ. Orange pixels are \
too bright, blue ones too dark, and a pixel that is alone has a frame.

Some mistakes are so common that they have names. All these are below, drawn by the five \
steps themselves, each under the step in whose picture it is easiest to tell from the \
others. A mistake stays in all pictures after that one, and a few can be seen a step \
earlier already. So look under the steps before and after yours as well.
";

const VIEWS: &str = "
## A mistake at any view

![The picture of step 5 with spheres that are a tenth too large, the right one, and the pixels \
that differ, which are nearly all.](pictures/mistakes.png \"What you get when {{#number mistakes:when}}; \
then the right picture, and where they differ: orange where the first is too bright, blue where \
it is too dark. \
{{#number mistakes:says}}\") {{#live}}

<span class=\"move\">Turn $\\theta$ down to 5°: the tangent of so small an angle is nearly \
the angle itself, and few pixels differ. Turn it up to 120°, and the two views have little in \
common.</span>
";

/// The appendix of the book that shows the whole gallery, as Markdown.
///
/// Its pictures have the names that [`Mistake::shown`] gives.
pub fn appendix() -> String {
    let mut text = format!("{HEAD}```text\n{}```\n{AFTER}{VIEWS}", example());
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
        let all = || mistakes().filter(|mistake| mistake.step == step);
        let small: String = all().map(small).collect();
        let count = all().count();
        text += &format!(
            "\n<div class=\"contacts\" style=\"--items: {count}\">\n\n{small}\n</div>\n"
        );
        all().for_each(|mistake| text += &entry(mistake));
    }
    text
}

/// The beginning of what `check` says of a picture of step 5 without L_s.
fn example() -> String {
    let camera = camera(640, 360);
    let name = Step::Phong.name();
    let picture = Step::Phong.picture(&camera, 1);
    let locked = [Locked { name: name.to_owned(), picture }];
    let mut parts = Parts::right(&camera);
    for light in &mut parts.scene.lights {
        light.specular = DVec3::ONE;
    }
    let text = look(&parts.picture(Step::Phong, 1), Some(name), &locked).text;
    let lines = text.lines().take_while(|line| !line.starts_with("Column "));
    lines.map(|line| format!("{line}\n")).collect()
}

/// A mistake on the contact sheet of its step: its picture, which leads to its entry.
fn small(mistake: &Mistake) -> String {
    let Mistake { name, when, sees, .. } = mistake;
    let alt = sees.replace('`', "");
    format!("- [![{alt}](pictures/mistake-{name}.png) {}](#{name})\n", title(when))
}

fn entry(mistake: &Mistake) -> String {
    let Mistake { name, when, sees, says, section, .. } = mistake;
    let mut text = format!("\n### {} {{#{name}}}\n\n", title(when));
    for (step, picture) in mistake.shown() {
        let number = step.number();
        let caption = match step == mistake.step {
            true => formulas(sees),
            false => "The same mistake in step 5.".to_owned(),
        };
        let alt =
            format!("The picture of step {number} when {when}.").replace('`', "");
        let _ = writeln!(text, "![{alt}](pictures/{picture}.png \"{caption}\")");
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
