// A problem on paper says whether a number is right or how wrong it is; its answer is folded.
import { problems } from './book.js';
import { expect, open, test } from './fixtures.js';

// One on the sheet, a count and another number will do: the values are tested where they are computed.
const some = problems.filter(([name, id]) => id === (name === 'problems.html' ? 'problem-1' : 'problem-8') || (id === 'problem-3' && name !== 'problems.html'));

for (const [name, id] of some) {
  test(`${name}: a number for ${id} is right, close or wrong`, async ({ page, home }) => {
    await open(page, home + name);
    const problem = page.locator(`#${id}`);
    const answer = Number(await problem.getAttribute('data-answer'));
    const isCount = await problem.getAttribute('data-tolerance') === '0';
    const verdict = problem.locator('output');
    const field = problem.getByRole('textbox', { name: `Your number for problem ${id.split('-')[1]}` });
    const [less, more] = answer < 0 ? ['large', 'small'] : ['small', 'large'];
    const typed = [
      [answer * 0.5, `too ${less}`], [answer * 1.02, `close, but too ${more}`],
      [answer * 0.995, isCount ? `close, but too ${less}` : 'right'], [`${3 * answer}/3`, 'right'], ['ten', 'not a number'],
    ].map(([text, words]) => [String(text), words]);
    for (const [text, words] of [...typed, [String(answer).replace('.', ','), 'right']]) {
      await field.fill(text);
      await expect(verdict).toBeEmpty();
      if (text.includes('/')) await field.press('Enter');
      else await problem.getByRole('button', { name: 'Check' }).click();
      await expect(verdict).toHaveText(words);
    }
    const box = problem.locator('details');
    if (name === 'problems.html') return;
    await expect(box.locator('p').first()).toBeHidden();
    await box.locator('summary').click();
    const printed = await box.locator('strong').first().textContent();
    expect(parseFloat(printed.replaceAll(',', ''))).toBe(answer);
  });
}
