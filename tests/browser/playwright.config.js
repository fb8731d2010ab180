// What is opened where: each project is a browser, a view and a way to come to the pages.
import { defineConfig } from '@playwright/test';
import { spawnSync } from 'node:child_process';

// The first program of these names that is installed.
function program(...names) {
  const find = name => spawnSync('which', [name], { encoding: 'utf8' }).stdout.trim();
  const path = names.map(find).find(Boolean);
  if (!path) throw new Error(`${names.join(' or ')} is missing: .ci/install installs it`);
  return path;
}

const flags = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--disable-background-networking'];
const chromium = {
  browserName: 'chromium',
  launchOptions: { executablePath: program('chromium', 'google-chrome'), args: flags },
};
// Firefox as it is installed has no command to set the colour scheme: a preference does. Playwright
// 1.65 gives that command all the same, so package.json stays with 1.64.
const firefox = isDark => ({
  browserName: 'firefox',
  channel: 'moz-firefox',
  launchOptions: {
    executablePath: program('firefox-esr', 'firefox'),
    firefoxUserPrefs: { 'layout.css.prefers-color-scheme.content-override': isDark ? 0 : 1 },
  },
});
const view = (width, colorScheme) => ({ viewport: { width, height: 900 }, colorScheme });
// One of each figure, one form and five words of the search will do.
const QUICK = process.env.THOROUGH ? {} : { grepInvert: /@thorough/ };
const ANSWERS = [
  'figures.spec.js', 'pixel.spec.js', 'check.spec.js', 'line_editor.spec.js', 'problems.spec.js', 'own_scene.spec.js',
];
const PAGES = ['pages.spec.js', 'search.spec.js'];
// By THOROUGH=1 alone: they take minutes, and find little that the others miss.
const THOROUGH = [
  { name: 'webkit', testMatch: 'webkit.spec.js' },
  {
    name: 'chromium-narrow-dark',
    testMatch: PAGES,
    use: { ...chromium, ...view(390, 'dark'), source: 'folder' },
  },
  {
    name: 'firefox-wide-dark',
    testMatch: [...PAGES, ...ANSWERS],
    use: { ...firefox(true), ...view(1280, null), source: 'server' },
  },
];

export default defineConfig({
  testDir: '.',
  outputDir: '../../target/browser-tests',
  fullyParallel: true,
  workers: 2,
  timeout: 60_000,
  use: { actionTimeout: 15_000 },
  forbidOnly: true,
  reporter: process.env.CI ? 'dot' : 'list',
  ...QUICK,
  projects: [
    {
      name: 'chromium-wide',
      testMatch: [...PAGES, ...ANSWERS, 'accessibility.spec.js', 'loading.spec.js', 'modules.spec.js'],
      use: { ...chromium, ...view(1280, 'light'), source: 'server' },
    },
    {
      name: 'firefox-narrow',
      testMatch: [...PAGES, 'line_editor.spec.js'],
      use: { ...firefox(false), ...view(390, null), source: 'folder' },
    },
    ...process.env.THOROUGH ? THOROUGH : [],
  ],
});
