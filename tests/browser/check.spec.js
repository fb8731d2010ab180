// The form that checks pictures tells a right picture from a wrong picture.
import { forms, picture } from './book.js';
import { expect, open, test } from './fixtures.js';

// It's enough to test the first form on each page, since the other forms differ only in the name of
// their picture.
for (const [name, asked] of forms.filter(([, , k]) => k === 0)) {
  test(`${name}: the form tells the right picture from a wrong picture and from a text file`, async ({ page, home }) => {
    const form = page.locator('form[data-check]').first();
    // Opens the page, and waits until the form works: the form is hidden until then.
    const openPage = async () => {
      await open(page, home + name);
      await form.and(page.locator(':not([hidden])')).waitFor({ state: 'attached' });
    };
    await openPage();
    const [input, output] = [form.locator('input[type=file]'), form.locator('output')];
    const right = asked === '*' ? 'step04_diffuse' : asked;
    for (const [given, words] of [[right, /^Right/], ['shadowed', /^(?!Right|This page|Looking)./]]) {
      await input.setInputFiles({ name: `${right}.png`, mimeType: 'image/png', buffer: picture(given) });
      await expect(output).toHaveText(words, { timeout: 20_000 });
    }
    // If the picture belongs to a step, that step has a tick in the contents, now and after the
    // page is opened again.
    const tick = page.locator(`#contents a[href="${right}.html"] .tick`);
    for (const look of [() => {}, openPage]) {
      await look();
      await expect(tick).toHaveCount(right.startsWith('step') ? 1 : 0);
    }
    // A click has to empty the field. Otherwise, if the reader chose the same file again, the
    // browser wouldn't report the choice.
    await input.dispatchEvent('click');
    await expect(input).toHaveValue('');
    // A file that is dropped beside the forms goes to the nearest form, which is the first form
    // here.
    const mayBrowserOpenIt = await page.locator('h1').evaluate(element => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File(['no picture'], 'notes.txt'));
      return element.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    });
    expect(mayBrowserOpenIt).toBe(false);
    await expect(output).toContainText('is not a PNG');
    await expect(form).toBeInViewport();
  });
}

test('what is plain to see comes first, with a link to the section to read again', async ({ page, home }) => {
  await open(page, `${home}step02_sphere.html`);
  const form = page.locator('form[data-check]').first();
  await form.and(page.locator(':not([hidden])')).waitFor({ state: 'attached' });
  // Draws the right picture upside down, and drops the result on the form.
  await form.evaluate(async element => {
    const image = Object.assign(new Image(), { src: 'generated/step02_sphere.png' });
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext('2d');
    context.scale(1, -1);
    context.drawImage(image, 0, -image.height);
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([await canvas.convertToBlob()], 'step02_sphere.png'));
    element.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  });
  const headline = 'Not right. This is the picture of step02_sphere, upside down.';
  await expect(form.locator('output b')).toHaveText(headline, { timeout: 20_000 });
  await form.getByRole('link', { name: 'See step 1, "The camera".' }).click();
  await expect(page.getByRole('heading', { name: 'The camera' })).toBeInViewport();
});
