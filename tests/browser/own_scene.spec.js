// A reader makes a scene, undoes changes, shares the scene, and downloads its picture.
import { expect, open, test } from './fixtures.js';

test('a ball is dragged, coloured, undone and kept, and a sphere comes in', async ({ page, home }) => {
  await open(page, `${home}own_scene.html`);
  await page.locator('figure[data-live=own_scene][data-ready]').waitFor({ timeout: 20_000 });
  // Firefox doesn't report a download to its driver, so record the file's name instead.
  await page.evaluate(() => { HTMLAnchorElement.prototype.click = function () { window.kept = this.download; }; });
  const press = name => page.getByRole('button', { name }).click();
  const { x, y, width } = await page.locator('.stage').boundingBox();
  const move = (i, j) => page.mouse.move(x + i / 640 * width, y + j / 640 * width, { steps: 3 });
  await move(250, 240); // The red ball, beside its ring.
  await page.mouse.down();
  await move(250, 200);
  await page.mouse.up();
  await page.keyboard.press('ControlOrMeta+z'); // Before the address is written.
  await expect(page).not.toHaveURL(/#scene/);
  await press('Redo');
  await page.locator('.tools input').fill('#00ff00');
  await expect(page).toHaveURL(/#scene=red-sphere-upwards:.*red-sphere-red:0,red-sphere-green:1,red-sphere-blue:0$/);
  await press('+ Sphere');
  await expect(page).toHaveURL(/tenth-sphere-in-the-scene:1$/);
  await press('Download PNG');
  await page.waitForFunction(() => window.kept === 'own_scene.png', null, { timeout: 30_000 });

  // Reset asks first, and Undo brings the scene back.
  page.once('dialog', dialog => dialog.dismiss());
  await press('Reset');
  await expect(page).toHaveURL(/tenth-sphere/);
  page.once('dialog', dialog => dialog.accept());
  await press('Reset');
  await expect(page).not.toHaveURL(/#scene/);
  await press('Undo');
  await expect(page).toHaveURL(/tenth-sphere/);

  // The link to a ready-made scene draws it.
  await page.locator('main a[href^="#scene="]').first().click();
  await expect(page).not.toHaveURL(/tenth-sphere/);
  await expect(page.locator('.refused')).toBeHidden();
});
