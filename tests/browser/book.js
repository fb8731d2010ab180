// The built book: its pages, and what is interactive on them.
import { readFileSync, readdirSync } from 'node:fs';
import { join, resolve } from 'node:path';

// BOOK names another folder than the one that `cargo run` writes.
export const folder = resolve(process.env.BOOK ?? join(import.meta.dirname, '../../target/book'));

const read = name => readFileSync(join(folder, name), 'utf8');

// 404.html is for a server's root, toc.html for browsers without scripts.
export const pages = readdirSync(folder).filter(name => /\.html$/.test(name) && !/^(404|toc)\./.test(name));

// All but the first page and the page for paper, which are others once more.
export const chapters = pages.filter(name => !/^(index|print)\./.test(name));

// [page, what the attribute is, which of its kind on the page it is].
const named = pattern => chapters.flatMap(page => [...read(page).matchAll(pattern)].map(([, name], k) => [page, name, k]));
export const figures = named(/<figure[^>]* data-live="([^"]+)"/g);
export const forms = named(/<form[^>]* data-check="([^"]+)"/g);

// The file of a picture of the book.
export const picture = name => readFileSync(join(folder, `generated/${name}.png`));
