use anyhow::{Context, Result};
use std::fs;
use std::path::Path;

/// The modules: what answers in the pages, what looks at a reader's picture, and what
/// draws those that it compares with.
const MODULES: [&str; 3] = ["live", "check", "pictures"];

/// Writes the modules of the pages into `folder`, each as a script: a page that was opened
/// from the file system may load scripts, and nothing else. Returns the scripts' names.
pub fn write(workspace: &Path, folder: &Path) -> Result<Vec<String>> {
    let script = |name: &str| {
        let module = workspace.join(format!("book/wasm/{name}.wasm"));
        let bytes = fs::read(&module)
            .with_context(|| format!("{} can't be read", module.display()))?;
        let script =
            format!("liveModule.come(\"{name}\", \"{}\");\n", base64(&bytes));
        let file = format!("{name}-module.js");
        let path = folder.join(&file);
        if fs::read_to_string(&path).ok().as_ref() != Some(&script) {
            fs::write(path, script).with_context(|| file.clone())?;
        }
        Ok(file)
    };
    MODULES.into_iter().map(script).collect()
}

/// Bytes as letters: three of the ones make four of the others.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] =
        b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let byte = |k| u32::from(three.get(k).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for k in 0..4 {
            let letter = LETTERS[(bits >> (18 - 6 * k) & 63) as usize] as char;
            text.push(if k <= three.len() { letter } else { '=' });
        }
    }
    text
}

#[test]
fn bytes_are_letters() {
    for (bytes, text) in [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v")]
    {
        assert_eq!(base64(bytes.as_bytes()), text);
    }
    assert_eq!(base64(&[0, 255, 190, 62]), "AP++Pg==");
}
