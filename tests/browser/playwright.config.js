// Playwright's settings. A project consists of a browser, a window size, and a way to open the
// pages.
import { defineConfig } from '@playwright/test';
import { spawnSync } from 'node:child_process';

// Finds the first of these programs that is installed, and returns its path.
const find = (...names) => names.map(name => spawnSync('which', [name], { encoding: 'utf8' }).stdout.trim()).find(Boolean);
const chromium = {
  browserName: 'chromium',
  launchOptions: { executablePath: find('chromium', 'google-chrome'), args: ['--no-sandbox', '--disable-gpu'] },
};
// An ordinary Firefox has no command that sets the colour scheme. Playwright 1.65 would send such a
// command anyway, so package.json stays at 1.64.
const firefox = {
  browserName: 'firefox',
  channel: 'moz-firefox',
  colorScheme: null,
  launchOptions: { executablePath: find('firefox-esr', 'firefox') },
};
const view = width => ({ viewport: { width, height: 900 } });
const isThorough = Boolean(process.env.THOROUGH);

export default defineConfig({
  testDir: '.',
  outputDir: '../../target/browser-tests',
  fullyParallel: true,
  workers: 3,
  timeout: 60_000,
  use: { actionTimeout: 15_000 },
  forbidOnly: true,
  reporter: process.env.CI ? 'dot' : 'list',
  // Without THOROUGH=1, it's enough to test one figure per page, to run axe on some of the pages,
  // and to test the search's results in one browser.
  grepInvert: isThorough ? [] : /@thorough|the figure own_scene/,
  projects: [
    { name: 'chromium-wide', testIgnore: 'webkit.spec.js', use: { ...chromium, ...view(1280) } },
    {
      name: 'firefox-narrow',
      testMatch: isThorough ? ['pages.spec.js', 'search.spec.js', 'line_editor.spec.js'] : 'line_editor.spec.js',
      grepInvert: isThorough ? [] : /@thorough|first results|has one height/,
      use: { ...firefox, ...view(390), source: 'folder' },
    },
    // These projects run only with THOROUGH=1, since they take minutes, and find little that the
    // other projects miss.
    ...isThorough ? [
      { name: 'firefox-wide', testIgnore: ['webkit.spec.js', 'loading.spec.js'], use: { ...firefox, ...view(1280) } },
      { name: 'webkit', testMatch: 'webkit.spec.js' },
    ] : [],
  ],
});
