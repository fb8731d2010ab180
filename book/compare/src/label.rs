use image::{GenericImage, Rgb, RgbImage};

/// How many columns and rows a letter takes, with the space around it.
pub(crate) const SIZE: (u32, u32) = (12, 20);

/// Letters of five columns and eight rows, a number for each row: its bits are the
/// pixels, the leftmost first. There are only those that the labels have.
const LETTERS: &[(char, [u8; 8])] = &[
    ('a', [0, 0, 14, 1, 15, 17, 15, 0]),
    ('b', [16, 16, 30, 17, 17, 17, 30, 0]),
    ('c', [0, 0, 14, 17, 16, 17, 14, 0]),
    ('d', [1, 1, 15, 17, 17, 17, 15, 0]),
    ('e', [0, 0, 14, 17, 31, 16, 14, 0]),
    ('g', [0, 0, 15, 17, 17, 15, 1, 14]),
    ('h', [16, 16, 30, 17, 17, 17, 17, 0]),
    ('i', [4, 0, 12, 4, 4, 4, 14, 0]),
    ('k', [16, 16, 18, 20, 24, 20, 18, 0]),
    ('l', [12, 4, 4, 4, 4, 4, 14, 0]),
    ('n', [0, 0, 30, 17, 17, 17, 17, 0]),
    ('o', [0, 0, 14, 17, 17, 17, 14, 0]),
    ('r', [0, 0, 22, 25, 16, 16, 16, 0]),
    ('s', [0, 0, 15, 16, 14, 1, 30, 0]),
    ('t', [8, 8, 30, 8, 8, 9, 6, 0]),
    ('u', [0, 0, 17, 17, 17, 17, 15, 0]),
    ('w', [0, 0, 17, 17, 21, 21, 10, 0]),
    ('y', [0, 0, 17, 17, 17, 15, 1, 14]),
];

/// Writes a word in the top row of a picture, from column `x` on; each bit is a square
/// of two by two pixels. Returns the column after it.
pub(crate) fn write(
    picture: &mut RgbImage,
    x: u32,
    word: &str,
    colour: Rgb<u8>,
) -> u32 {
    for (letter, k) in word.chars().zip(0..) {
        let known = LETTERS.iter().find(|(known, _)| *known == letter);
        let rows = known.map_or([0; 8], |(_, rows)| *rows);
        for (row, j) in rows.into_iter().zip(0..) {
            for i in (0..5).filter(|i| row >> (4 - i) & 1 == 1) {
                let dot = RgbImage::from_pixel(2, 2, colour);
                // What does not fit is left out.
                let _ = picture.copy_from(&dot, x + SIZE.0 * k + 2 * i, 2 + 2 * j);
            }
        }
    }
    x + SIZE.0 * (word.chars().count() as u32 + 1)
}
