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

for (const [name, asked, before] of forms) {
  const place = before ? `, number ${before + 1} there,` : '';
  const isFirst = forms.find(([other]) => other === name)[1] === asked;
  const details = { tag: isFirst ? [] : '@thorough' };
  test(`${name}: the form for ${asked}${place} looks at pictures`, details, async ({ page, home }) => {
    await open(page, home + name);
    const form = page.locator(`form[data-live=check][data-name="${asked}"]`).nth(before);
    await form.and(page.locator(':not([hidden])')).waitFor({ state: 'attached' });
    const expected = asked === '*' ? 'step04_diffuse' : asked;
    expect(await drop(form, picture(expected), `${expected}.png`)).toMatch(/^Right/);
    expect(await drop(form, picture('shadowed'), `${expected}.png`)).not.toMatch(/^(Right|This page)/);
  });
}
