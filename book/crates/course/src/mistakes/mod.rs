//! The mistakes that readers make, each as a diff, and the table with the hashes of the pictures
//! that these mistakes produce. The mistakes and the table are kept as text files in the folder
//! `mistakes` of this package.

mod files;
mod mistake;
mod table;
pub use files::{MistakeFiles, mistake_files, provide_mistake_files};
pub use mistake::{
    Mistake, MistakeListError, MistakePicture, MistakePresentation, mistakes, parse_mistake_lists,
};
pub use table::{
    MistakeTable, RightPicture, SMALL_SIZE, TableError, TableRow, find_mistakes_with_hash,
    hashes_of_right_pictures, make_small_picture, mistake_table, mistakes_and_their_rows,
    names_of_right_pictures, read_small_mistake_pictures, small_pictures_file_path,
};
