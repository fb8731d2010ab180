use image::RgbImage;

/// Columns and rows of the locked pictures.
pub const SIZE: [u32; 2] = [640, 360];

/// A picture of the course: red, green and blue of each pixel. The words are its name and,
/// if it is to be small, its columns.
pub fn draw(words: &str) -> figures::Reply {
    let (name, columns) = words.split_once(' ').unwrap_or((words, ""));
    let columns = columns.parse().unwrap_or(SIZE[0]);
    let Some(picture) = draw_picture(name, columns) else {
        return figures::Reply::default();
    };
    let size = course::json::list([picture.width(), picture.height()]);
    figures::Reply {
        pixels: picture.into_raw(),
        ..figures::Reply::from_json_fields([("size", size)])
    }
}

/// The picture of this name with so many columns; None if there is none.
pub fn draw_picture(name: &str, columns: u32) -> Option<RgbImage> {
    let picture = course::find_picture(name)?;
    let rows = columns * SIZE[1] / SIZE[0];
    let camera = course::camera_with_size(columns, rows);
    Some(picture(&camera, 1))
}
