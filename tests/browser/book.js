// The built book: its pages, and the interactive parts in them.
import { readFileSync, readdirSync } from 'node:fs';
import { join, resolve } from 'node:path';

// The variable BOOK names a different folder than the one that `cargo run` writes.
export const folder = resolve(process.env.BOOK ?? join(import.meta.dirname, '../../target/book'));

const read = name => readFileSync(join(folder, name), 'utf8');

// All pages, except 404.html, which is for a server's root, and toc.html, for browsers without scripts.
export const pages = readdirSync(folder).filter(name => /\.html$/.test(name) && !/^(404|toc)\./.test(name));

// All pages except the first page and the page for printing, which only repeat others.
export const chapters = pages.filter(name => !/^(index|print)\./.test(name));

// Finds a pattern in all chapters: [page, value of the attribute, index among the matches of that page].
const named = pattern => chapters.flatMap(page => [...read(page).matchAll(pattern)].map(([, name], k) => [page, name, k]));
export const figures = named(/<figure[^>]* data-live="([^"]+)"/g);
export const forms = named(/<form[^>]* data-check="([^"]+)"/g);

// The bytes of a picture of the book, a PNG file.
export const picture = name => readFileSync(join(folder, `generated/${name}.png`));
