// The built book: its pages, and what answers in them.
import { readFileSync, readdirSync } from 'node:fs';
import { join, resolve } from 'node:path';

// BOOK names another folder than the one that `cargo run` writes.
export const folder = resolve(process.env.BOOK ?? join(import.meta.dirname, '../../target/book'));

const read = name => readFileSync(join(folder, name), 'utf8');

// 404.html is for a server's root, toc.html for browsers without scripts.
export const pages = readdirSync(folder).filter(name => /\.html$/.test(name) && !/^(404|toc)\./.test(name));

// All but the page for paper, which holds the others once more.
export const chapters = pages.filter(name => name !== 'print.html');

// The names in an attribute, page by page: [page, name, how many of that name come before it there].
const named = pattern => chapters.flatMap(page => {
  const names = [...read(page).matchAll(pattern)].map(([, name]) => name);
  return names.map((name, k) => [page, name, names.slice(0, k).filter(one => one === name).length]);
});
export const figures = named(/<figure[^>]* data-live="([^"]+)"/g);
export const forms = named(/<form[^>]* data-live="check"[^>]* data-name="([^"]+)"/g);
export const problems = named(/<section[^>]* id="(problem-\d+)"/g);
export const pagesWithFigures = [...new Set(figures.map(([page]) => page))];

// A picture of the book, in base 64.
export const picture = name => readFileSync(join(folder, `generated/${name}.png`), 'base64');

// The texts of the scripts and styles that stand in the pages themselves.
export const inline = tag => new Set(pages.concat('404.html').flatMap(page =>
  [...read(page).matchAll(new RegExp(`<${tag}>(.*?)</${tag}>`, 'gs'))].map(([, text]) => text)));
