// The built book: its pages, and the interactive parts on them.
import { readFileSync, readdirSync } from 'node:fs';
import { join, resolve } from 'node:path';

// The book's folder: the value of the variable BOOK or, by default, the folder that `cargo run`
// writes.
export const folder = resolve(process.env.BOOK ?? join(import.meta.dirname, '../../target/book'));

const read = name => readFileSync(join(folder, name), 'utf8');

// All pages except 404.html and toc.html. The links in 404.html work only where the book is
// published, and toc.html is for browsers without scripts.
export const pages = readdirSync(folder).filter(name => /\.html$/.test(name) && !/^(404|toc)\./.test(name));

// All pages except the first page and the page for printing, which only repeat other pages.
export const chapters = pages.filter(name => !/^(index|print)\./.test(name));

// Finds a pattern in all chapters. For each match, returns the page, the text of the pattern's
// group, and the match's index on the page.
const named = pattern => chapters.flatMap(page => [...read(page).matchAll(pattern)].map(([, name], k) => [page, name, k]));
export const figures = named(/<figure[^>]* data-live="([^"]+)"/g);
export const forms = named(/<form[^>]* data-check="([^"]+)"/g);

// The bytes of one of the book's pictures, as a PNG file.
export const picture = name => readFileSync(join(folder, `generated/${name}.png`));
