use crate::files::{CHAPTERS, Files};
use crate::markdown::inline;
use crate::module;
use crate::{chain, gallery};
use anyhow::{Context, Result};
use image::{ColorType, ImageFormat, write_buffer_with_format};
use live::{Live, Sight, escape};
use std::collections::BTreeMap;
use std::fs;
use std::io::Cursor;
use std::path::Path;

/// What makes a picture load when it comes into view.
pub const LAZY: &str = r#" loading="lazy""#;

/// A picture as a chapter asks for it: `![what it shows](pictures/name.png
/// "Caption")`.
#[derive(Debug)]
pub struct Picture {
    alt: String,
    source: String,
    caption: String,
}

impl Picture {
    /// Takes the alt text from the Markdown of the picture.
    pub fn new(markdown: &str, source: &str, caption: &str) -> Self {
        // The caption may hold links of its own; the alt text ends before the first.
        let end = format!("]({source}");
        let alt = markdown.trim_start_matches("![").split(&end);
        let alt: Vec<_> = alt.take(1).flat_map(str::split_whitespace).collect();
        let (source, caption) = (source.to_string(), caption.to_string());
        Self { alt: alt.join(" "), source, caption }
    }

    /// What answers where this picture is: what is called `name`, or has the name of
    /// its file.
    fn live(&self, name: &str) -> Result<&'static Live, String> {
        let file =
            Path::new(&self.source).file_stem().and_then(|name| name.to_str());
        let name = if name.is_empty() { file } else { Some(name) };
        name.and_then(live::find)
            .ok_or(format!("nothing answers for the picture {}", self.source))
    }

    /// The picture alone, in its size; it loads when it comes into view.
    pub fn html(&self, workspace: &Path) -> Result<String, String> {
        let Self { alt, source, .. } = self;
        if alt.is_empty() {
            return Err(format!(
                "the picture {source} has no alt text: say what it shows"
            ));
        }
        let bytes = fs::read(workspace.join(CHAPTERS).join(source))
            .map_err(|_| format!("there is no picture {source}"))?;
        let (width, height) = size(&bytes)
            .ok_or_else(|| format!("the picture {source} is not a PNG file"))?;
        Ok(format!(
            r#"<img src="{}" alt="{}" width="{width}" height="{height}"{LAZY}>"#,
            escape(source),
            escape(alt)
        ))
    }
}

/// A figure of the pictures of a paragraph, side by side if there are several. Where
/// they are `live`, by a name or by that of their files, what is said of a pixel stands
/// below each.
pub fn figure(
    pictures: &[Picture],
    live: Option<&str>,
    workspace: &Path,
) -> Result<String, String> {
    let mut figures = String::new();
    for picture in pictures {
        let image = picture.html(workspace)?;
        let (mut data, mut below) = Default::default();
        if let Some(name) = live {
            let answers = picture.live(name)?;
            data = format!(" data-live=\"{}\"", answers.name);
            if answers.is_asked() {
                below = chain::html(answers, workspace)?;
            }
        }
        let caption = match picture.caption.as_str() {
            "" => String::new(),
            markdown => {
                format!("<figcaption>{}</figcaption>", inline(markdown)?)
            }
        };
        figures += &format!(
            "<figure class=\"picture\"{data}>{image}{caption}</figure>\n{below}"
        );
    }
    Ok(match pictures {
        [_] => figures,
        _ => format!("<div class=\"pictures\">\n{figures}</div>\n"),
    })
}

/// Width and height, which stand at a fixed place in a PNG file.
fn size(png: &[u8]) -> Option<(u32, u32)> {
    let number =
        |at: usize| Some(u32::from_be_bytes(png.get(at..at + 4)?.try_into().ok()?));
    png.starts_with(b"\x89PNG").then_some(())?;
    Some((number(16)?, number(20)?))
}

/// Copies the locked snapshots beside the chapters, draws the gallery of mistakes
/// and what answers with a picture of its own there, adds the modules for the pages, and removes what is neither.
///
/// A file that is right already is left alone, so that a watching program is not
/// woken.
pub fn copy_snapshots(workspace: &Path) -> Result<()> {
    let folder = workspace.join(CHAPTERS).join("pictures");
    fs::create_dir_all(&folder)
        .with_context(|| format!("{} can't be made", folder.display()))?;
    let mut names = gallery::draw(&folder)?;
    let old = Files::read(&folder)?.0;
    let mut pictures = BTreeMap::new();
    for live in live::LIVE {
        if let Sight::Picture { size, pixels } = (live.sight)(&live.values()) {
            pictures.insert(format!("{}.png", live.name), encoded(size, &pixels)?);
        }
    }
    for (name, bytes) in Files::read(&workspace.join("tests/snapshots"))?.0 {
        let Some(name) = name.strip_suffix(".snap.png") else { continue };
        pictures.insert(format!("{name}.png"), bytes);
    }
    for (name, bytes) in pictures {
        if old.get(&name) != Some(&bytes) {
            fs::write(folder.join(&name), bytes).with_context(|| name.clone())?;
        }
        names.push(name);
    }
    names.extend(module::write(workspace, &folder)?);
    for stale in old.keys().filter(|name| !names.contains(name)) {
        fs::remove_file(folder.join(stale)).with_context(|| stale.clone())?;
    }
    Ok(())
}

/// A PNG file of these pixels, of four bytes each.
fn encoded([width, height]: [u32; 2], pixels: &[u8]) -> Result<Vec<u8>> {
    let mut png = Cursor::new(vec![]);
    write_buffer_with_format(
        &mut png,
        pixels,
        width,
        height,
        ColorType::Rgba8,
        ImageFormat::Png,
    )?;
    Ok(png.into_inner())
}
