// A scene of the reader's own is made by hand, undone, sent and kept.
import { expect, open, test } from './fixtures.js';

test('a ball is dragged, coloured, undone and kept, and a sphere comes in', async ({ page, home }) => {
  // Firefox tells its driver nothing of a download.
  await page.addInitScript(() => { HTMLAnchorElement.prototype.click = function () { window.kept = this.download; }; });
  await open(page, `${home}own_scene.html`);
  await page.locator('figure[data-live=own_scene][data-ready]').waitFor({ timeout: 20_000 });
  const stage = page.locator('.stage');
  const tool = name => page.getByRole('button', { name });
  const drag = async () => {
    const { x, y, width } = await stage.boundingBox();
    const at = (i, j) => [x + i / 640 * width, y + j / 640 * width];
    await page.mouse.move(...at(250, 240)); // The red ball, beside its ring.
    await page.mouse.down();
    await page.mouse.move(...at(250, 200), { steps: 3 });
    await page.mouse.up();
  };
  await drag();
  await expect(page).toHaveURL(/#scene=red-sphere-upwards:/);
  await expect(page.locator('.choice select')).toHaveValue('red sphere');
  await page.keyboard.press('ControlOrMeta+z');
  await expect(page).not.toHaveURL(/#scene/);
  await tool('Redo').click();
  await expect(page).toHaveURL(/#scene=red-sphere-upwards:/);
  await page.locator('.tools input').fill('#00ff00');
  await expect(page).toHaveURL(/red-sphere-red:0,red-sphere-green:1,red-sphere-blue:0$/);
  await tool('+ Sphere').click();
  await expect(page).toHaveURL(/tenth-sphere-in-the-scene:1$/);

  await tool('Download PNG').click();
  await page.waitForFunction(() => window.kept === 'own_scene.png', null, { timeout: 30_000 });

  // Reset asks; undone, it brings the scene back.
  page.once('dialog', dialog => dialog.dismiss());
  await tool('Reset').click();
  await expect(page).toHaveURL(/tenth-sphere/);
  page.once('dialog', dialog => dialog.accept());
  await tool('Reset').click();
  await expect(page).not.toHaveURL(/#scene/);
  await tool('Undo').click();
  await expect(page).toHaveURL(/tenth-sphere/);
});

test('three scenes to start from are drawn', async ({ page, home }) => {
  await open(page, `${home}own_scene.html`);
  await page.locator('figure[data-live=own_scene][data-ready]').waitFor({ timeout: 20_000 });
  const links = await page.locator('main a[href^="#scene="]').all();
  expect(links).toHaveLength(3);
  for (const link of links) {
    await link.click();
    await expect(page.locator('figure[data-live=own_scene]')).toBeInViewport();
    await expect(page.locator('.refused')).toBeHidden();
    await expect(page.getByRole('button', { name: 'Reset' })).toBeEnabled();
  }
});
