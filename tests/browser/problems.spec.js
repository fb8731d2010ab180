// A problem on paper says whether a number is right, and has its answer behind a press.
import { problems } from './book.js';
import { expect, open, test } from './fixtures.js';

// One on the sheet, a count and another number will do: the values are tested where they are computed.
const some = problems.filter(([name, id]) => id === (name === 'problems.html' ? 'problem-1' : 'problem-8') || (id === 'problem-3' && name !== 'problems.html'));

for (const [name, id] of some) {
  test(`${name}: a number for ${id} is right or not yet`, async ({ page, home }) => {
    await open(page, home + name);
    const problem = page.locator(`#${id}`);
    const answer = Number(await problem.getAttribute('data-answer'));
    const isCount = await problem.getAttribute('data-tolerance') === '0';
    const verdict = problem.locator('output');
    const field = problem.getByRole('spinbutton', { name: `Your number for problem ${id.split('-')[1]}` });
    for (const [share, words] of [[0.97, 'not yet'], [1.02, 'not yet'], [0.995, isCount ? 'not yet' : 'right'], [1, 'right']]) {
      await field.clear(); // In Firefox, `fill` leaves what is in a field of numbers.
      await field.fill((answer * share).toPrecision(8));
      await expect(verdict).toBeEmpty();
      if (share === 1) await field.press('Enter');
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
