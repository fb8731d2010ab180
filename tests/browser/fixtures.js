// Playwright's `test`, with two fixtures:
//
// - `home` is the address of the book.
// - `page` is a page of a browser. The test fails if the page requests anything from outside the
//   book, if the browser reports an error, or if the Content-Security-Policy forbids something.
import { test as base, expect } from '@playwright/test';
import { pathToFileURL } from 'node:url';
import { folder } from './book.js';
import { serve } from './server.js';

export { expect };

// Firefox reports this error if it lays out a formula before it has received the whole formula.
const HARMLESS = /Incorrect number of children for <m/;

export const test = base.extend({
  // Where the pages come from: 'server' or 'folder'.
  source: ['server', { option: true, scope: 'worker' }],

  home: [async ({ source }, use) => {
    if (source === 'folder') return use(`${pathToFileURL(folder).href}/`);
    const { server, address } = await serve();
    await use(address);
    server.close();
    return server.closeAllConnections();
  }, { scope: 'worker' }],

  page: async ({ page, home }, use) => {
    const faults = [];
    page.on('console', message => message.type() === 'error' && faults.push(message.text()));
    page.on('pageerror', error => faults.push(String(error)));
    page.on('request', request => {
      const isOurs = [home, 'data:', 'blob:'].some(start => request.url().startsWith(start));
      if (!isOurs) faults.push(`asks for ${request.url()}`);
    });
    await page.addInitScript(() => addEventListener('securitypolicyviolation', event => {
      console.error(`the policy forbids ${event.blockedURI} by ${event.effectiveDirective}`);
    }));
    await use(page);
    expect(faults.filter(fault => !HARMLESS.test(fault)), 'errors that the browser reports').toEqual([]);
  },
});

// Opens a page of the book, and waits until all of the page's scripts have been requested.
export async function open(page, address) {
  await page.goto(address);
  await page.locator('script[src$="search.js"]').waitFor({ state: 'attached' });
}

// Scrolls to a figure, and waits until the figure is interactive. If the figure is in a folded box,
// opens the box first.
export async function makeReady(figure) {
  await figure.evaluate(element => element.closest('details')?.setAttribute('open', ''));
  await figure.scrollIntoViewIfNeeded();
  await figure.and(figure.page().locator('[data-ready]')).waitFor({ timeout: 20_000 });
}

// Returns the pixels of an image or a canvas, as a data URL of a PNG file.
export const readPixels = picture => picture.evaluate(async element => {
  element.loading = 'eager';
  await element.decode?.();
  const [width, height] = [element.naturalWidth ?? element.width, element.naturalHeight ?? element.height];
  const copy = Object.assign(document.createElement('canvas'), { width, height });
  copy.getContext('2d').drawImage(element, 0, 0);
  return copy.toDataURL();
});
