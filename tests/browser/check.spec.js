// The form that looks at a picture knows the right one and a wrong one.
import { forms, picture } from './book.js';
import { expect, open, test } from './fixtures.js';

// Drops a picture on a form; returns what the page says of it.
const drop = (form, bytes, name) => form.evaluate(async (one, [bytes, name]) => {
  const output = one.querySelector('output');
  one.querySelector('button').click();
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([Uint8Array.from(atob(bytes), letter => letter.charCodeAt(0))], name));
  one.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  while (/^(Looking|$)/.test(output.textContent)) await new Promise(done => setTimeout(done, 20));
  return output.textContent;
}, [bytes, name]);

// The first form of each page: the others differ from it by their names.
const firstForms = forms.filter(([name], k) => forms.findIndex(([other]) => other === name) === k);

for (const [name, asked] of firstForms) {
  test(`${name}: the form for ${asked} looks at pictures`, async ({ page, home }) => {
    await open(page, home + name);
    const form = page.locator(`form[data-live=check][data-name="${asked}"]`).first();
    await form.and(page.locator(':not([hidden])')).waitFor({ state: 'attached' });
    const expected = asked === '*' ? 'step04_diffuse' : asked;
    expect(await drop(form, picture(expected), `${expected}.png`)).toMatch(/^Right/);
    expect(await drop(form, picture('shadowed'), `${expected}.png`)).not.toMatch(/^(Right|This page)/);
  });
}

test('a file is looked at again, and a drop beside a form does not leave the page', async ({ page, home }) => {
  const [name, asked] = forms[0];
  await open(page, home + name);
  const form = page.locator('form[data-live=check]').first();
  await form.and(page.locator(':not([hidden])')).waitFor({ state: 'attached' });
  const input = form.locator('input');
  await input.setInputFiles({ name: `${asked}.png`, mimeType: 'image/png', buffer: Buffer.from(picture(asked), 'base64') });
  await expect(form.locator('output')).toHaveText(/^Right/, { timeout: 20_000 });
  // A browser tells of the same file only where none was chosen before.
  await input.dispatchEvent('click');
  await expect(input).toHaveValue('');
  const isKept = await page.locator('h1').evaluate(heading => !heading.dispatchEvent(new DragEvent('drop', { bubbles: true, cancelable: true })));
  expect(isKept).toBe(true);
  await form.evaluate(one => one.dispatchEvent(new DragEvent('drop', { dataTransfer: new DataTransfer(), bubbles: true, cancelable: true })));
  await expect(form.locator('output')).toContainText("isn't a file");
});
