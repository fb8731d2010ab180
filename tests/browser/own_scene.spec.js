// A reader makes a scene, undoes changes, shares the scene, and downloads its picture.
import { expect, open, test } from './fixtures.js';

test('each object has its own controls, with their limits and values', async ({ page, home }) => {
  await open(page, `${home}own_scene.html`);
  await page.locator('figure[data-live=own_scene][data-ready]').waitFor({ timeout: 20_000 });
  const sliders = page.locator('.controls .range:visible');
  for (const [object, count, upwards] of [['red sphere', 9, '-0.16'], ['ground', 9, '-41.2'], ['cool light', 12, '2.2'], ['camera', 8]]) {
    await page.getByRole('combobox').selectOption(object);
    await expect(sliders, object).toHaveCount(count);
    // A slider clamps its value to its limits. With a sphere's limits, the ground's slider would
    // have another value.
    if (upwards) await expect(sliders.nth(1).locator('[type=range]')).toHaveValue(upwards);
  }
});

test('a reader drags and colours a ball, undoes and redoes changes, adds a sphere, and downloads the picture', async ({ page, home }) => {
  await open(page, `${home}own_scene.html`);
  await page.locator('figure[data-live=own_scene][data-ready]').waitFor({ timeout: 20_000 });
  // Firefox doesn't report a download to its driver, so record the file's name instead.
  await page.evaluate(() => { HTMLAnchorElement.prototype.click = function () { window.kept = this.download; }; });
  const press = name => page.getByRole('button', { name }).click();
  const { x, y, width } = await page.locator('.stage').boundingBox();
  const move = (i, j) => page.mouse.move(x + i / 640 * width, y + j / 640 * width, { steps: 3 });
  await move(250, 240); // A point on the red ball, outside the ball's handle.
  await page.mouse.down();
  await move(250, 220);
  await page.waitForTimeout(400);
  await expect(page, 'a drag that pauses is not over').not.toHaveURL(/#scene/);
  await move(250, 200);
  await page.mouse.up();
  await page.keyboard.press('ControlOrMeta+z'); // Undo works even before the address is written.
  await expect(page).not.toHaveURL(/#scene/);
  await press('Redo');
  await expect(page.locator('.handle.covered')).toHaveCount(0);
  await page.locator('.tools input').fill('#00ff00');
  await expect(page).toHaveURL(/#scene=red-sphere-upwards:.*red-sphere-red:0,red-sphere-green:1,red-sphere-blue:0$/);
  // The line that changed is marked in the program.
  const changed = await page.evaluate(() => [...CSS.highlights.get('changed')].map(String));
  expect(changed).toEqual([expect.stringMatching(/^ {12}ball\("red sphere".*\[0.0, 1.0, 0.0\], 0.7, 40\),$/)]);
  const select = page.getByRole('combobox');
  await press('+ Sphere');
  await expect(page).toHaveURL(/tenth-sphere-in-the-scene:1$/);
  await expect(select).toHaveValue('tenth sphere');
  // After Undo has removed the sphere, the menu selects the first object that is in the scene.
  await press('Undo');
  await expect(select).toHaveValue('red sphere');
  await press('Redo');
  await expect(page).toHaveURL(/tenth-sphere-in-the-scene:1$/);
  await press('Download PNG');
  await page.waitForFunction(() => window.kept === 'own_scene.png', null, { timeout: 30_000 });

  // Reset asks for confirmation, and Undo brings the scene back.
  page.once('dialog', dialog => dialog.dismiss());
  await press('Reset');
  await expect(page).toHaveURL(/tenth-sphere/);
  page.once('dialog', dialog => dialog.accept());
  await press('Reset');
  await expect(page).not.toHaveURL(/#scene/);
  await press('Undo');
  await expect(page).toHaveURL(/tenth-sphere/);

  // A link to a ready-made scene draws that scene.
  await page.locator('main a[href^="#scene="]').first().click();
  await expect(page).not.toHaveURL(/tenth-sphere/);
  await expect(page.locator('.refused')).toBeHidden();
});

test('the handle of a ball behind another ball is marked', async ({ page, home }) => {
  await open(page, `${home}own_scene.html#scene=red-sphere-sideways:-2.1`);
  await page.locator('figure[data-live=own_scene][data-ready]').waitFor({ timeout: 20_000 });
  await expect(page.locator('.handle.covered')).toHaveAccessibleName('blue sphere');
});

test('Ctrl+Z undoes, Ctrl+Y and Ctrl+Shift+Z redo', async ({ page, home }) => {
  await open(page, `${home}own_scene.html`);
  await page.locator('figure[data-live=own_scene][data-ready]').waitFor({ timeout: 20_000 });
  await page.locator('.handle').first().press('ArrowUp');
  await expect(page).toHaveURL(/#scene=red-sphere-upwards/);
  for (const redo of ['Control+y', 'ControlOrMeta+Shift+z']) {
    await page.keyboard.press('ControlOrMeta+z');
    await expect(page).not.toHaveURL(/#scene/);
    await page.keyboard.press(redo);
    await expect(page).toHaveURL(/#scene=red-sphere-upwards/);
  }
});

for (const [width, height] of [[1440, 900], [1280, 720], [1100, 720]]) {
  test(`picture and controls are in view beside each other at ${width}×${height}`, async ({ page, home }) => {
    await page.setViewportSize({ width, height });
    await open(page, `${home}own_scene.html`);
    await page.locator('figure[data-live=own_scene][data-ready]').waitFor({ timeout: 20_000 });
    const [stage, controls] = [await page.locator('.stage').boundingBox(), await page.locator('.controls').boundingBox()];
    expect(controls.x).toBeGreaterThan(stage.x + stage.width);
    expect(Math.abs(controls.y - stage.y)).toBeLessThan(30);
    const last = await page.getByRole('button', { name: 'Download PNG' }).boundingBox();
    expect(last.y + last.height).toBeLessThanOrEqual(height);
  });
}

for (const [width, height] of [[390, 508], [1024, 700]]) {
  test(`the picture stays in view above the controls at ${width}×${height}`, async ({ page, home }) => {
    await page.setViewportSize({ width, height });
    await open(page, `${home}own_scene.html`);
    await page.locator('figure[data-live=own_scene][data-ready]').waitFor({ timeout: 20_000 });
    await page.getByRole('button', { name: 'Download PNG' }).evaluate(element => element.scrollIntoView({ block: 'end' }));
    await expect(page.locator('.stage')).toBeInViewport({ ratio: 1 });
    const sliders = await page.locator('.controls input[type=range]:visible').evaluateAll(all => all.map(element => element.clientWidth));
    expect(Math.min(...sliders), 'the width of a slider').toBeGreaterThan(120);
    expect(Math.max(...sliders) - Math.min(...sliders), 'the sliders are equally wide').toBeLessThanOrEqual(1);
  });
}

test('the first page’s picture loads nothing until the pointer is on it, a ball can be dragged, and the link contains the scene', async ({ page, home }) => {
  const files = [];
  page.on('request', request => files.push(request.url().split('/').at(-1)));
  await open(page, `${home}index.html`);
  const figure = page.locator('figure[data-preview]');
  const move = async (i, j) => {
    const { x, y, width } = await figure.locator('img, canvas').boundingBox();
    await page.mouse.move(x + i / 640 * width, y + j / 640 * width, { steps: 3 });
  };
  const said = () => figure.evaluate(element => getComputedStyle(element, '::before').content);
  expect(await said()).toBe('"Drag a ball"');
  await page.setViewportSize({ width: 1280, height: 720 });
  await expect(figure.locator('img')).toBeInViewport({ ratio: 1 });
  await expect(figure.locator('.hint')).toBeInViewport({ ratio: 1 });
  expect(files.filter(file => /figure|wasm|module|own_scene/.test(file))).toEqual([]);
  await move(250, 240);
  await figure.and(page.locator('[data-ready]')).waitFor({ timeout: 20_000 });
  await page.evaluate(() => { performance.now = () => 0; }); // Every drawing counts as fast, however busy the machine is.
  await page.mouse.down();
  await move(250, 190);
  await page.mouse.up();
  await expect(figure.locator('canvas')).toBeVisible();
  expect(await figure.evaluate(element => getComputedStyle(element, '::before').display)).toBe('none');
  const link = figure.getByRole('link', { name: 'A scene of your own' });
  await expect(link).toHaveAttribute('href', /own_scene.html#scene=red-sphere-upwards:0.\d+$/);
  expect(page.url()).not.toContain('#');
  // Once nothing moves, the picture has as many columns as the image that the page shows at first.
  // Reset puts the ball back.
  await expect(figure.locator('canvas')).toHaveAttribute('width', '1280');
  const reset = figure.getByRole('button', { name: 'Reset' });
  await reset.click();
  await expect(link).toHaveAttribute('href', /own_scene.html$/);
  await expect(reset).toBeHidden();
  await move(250, 240);
  await page.mouse.down();
  await move(250, 190);
  await page.mouse.up();
  await expect(link).toHaveAttribute('href', /#scene=red-sphere-upwards:/);
  await link.click();
  await expect(page).toHaveURL(/own_scene.html#scene=red-sphere-upwards:0.\d+$/);
  await expect(page.locator('figure[data-live=own_scene] canvas')).toBeVisible({ timeout: 20_000 });
});

test.describe('with a finger', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true });

  test('the first touch of the first page’s picture drags a ball', async ({ page, home, browserName }) => {
    test.skip(browserName !== 'chromium', 'only Chromium takes touches from a test');
    await open(page, `${home}index.html`);
    const figure = page.locator('figure[data-preview]');
    const { x, y, width } = await figure.locator('img').boundingBox();
    const touch = await page.context().newCDPSession(page);
    const send = (type, ...touchPoints) => touch.send('Input.dispatchTouchEvent', { type, touchPoints });
    const at = i => ({ x: x + i / 640 * width, y: y + 240 / 640 * width });
    await send('touchStart', at(250));
    await send('touchMove', at(280)); // Sideways: a finger that goes up or down scrolls the page.
    await figure.and(page.locator('[data-ready]')).waitFor({ timeout: 20_000 });
    for (const i of [300, 320, 340]) await send('touchMove', at(i));
    await send('touchEnd');
    await expect(figure.getByRole('link', { name: 'A scene of your own' })).toHaveAttribute('href', /#scene=red-sphere-sideways:/);
  });
});
