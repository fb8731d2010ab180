//! Prints the table of stages of a picture.

use check::{Verdict, stages};
use gallery::Step;
use std::env;
use std::time::Instant;

fn main() {
    let words: Vec<_> = env::args().skip(1).collect();
    let step = Step::named(&words[1]).expect("the name of a step");
    let picture = image::open(&words[0]).expect("a picture").to_rgb8();
    let start = Instant::now();
    let stages = stages(&picture, step);
    println!("{:.0?}", start.elapsed());
    for stage in stages {
        match &stage.verdict {
            Verdict::Unknown(why) => println!("{:18} ?      {why}", stage.name),
            verdict => println!("{:18} {verdict:?}", stage.name),
        }
        stage.numbers.iter().for_each(|line| println!("    {line}"));
    }
}
