// Playwright's `test`, whose page knows where the book is and fails with every fault that a browser
// tells: an error, a request that leaves the book, something that the policy forbids.
import { test as base, expect } from '@playwright/test';
import { pathToFileURL } from 'node:url';
import { folder } from './book.js';
import { policy } from './policy.js';
import { serve } from './server.js';

export { expect };

const local = `${pathToFileURL(folder).href}/`;

// Firefox says so of a formula that is drawn before all of it has come.
const HARMLESS = /Incorrect number of children for <m/;

export const test = base.extend({
  // 'server' or 'folder'.
  source: ['server', { option: true, scope: 'worker' }],

  served: [async ({}, use) => {
    const { server, address } = await serve(policy);
    await use(address);
    server.close();
    server.closeAllConnections();
  }, { scope: 'worker' }],

  home: [async ({ source, served }, use) => {
    await use(source === 'server' ? served : local);
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
    expect(faults.filter(fault => !HARMLESS.test(fault)), 'what the browser tells').toEqual([]);
  },
});

// Opens a page of the book; its scripts have come when it returns.
export async function open(page, address) {
  await page.goto(address);
  await page.locator('script[src$="search.js"]').waitFor({ state: 'attached' });
}
