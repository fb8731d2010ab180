// The form below a problem on paper says whether a number is right. If the number is wrong, the
// form says how wrong it is.
import { expect, open, test } from './fixtures.js';

test('a number for a problem is right, close or wrong', async ({ page, home }) => {
  await open(page, `${home}step01_practice.html`);
  const problem = page.locator('#problem-1');
  const answer = Number(await problem.getAttribute('data-answer'));
  for (const [text, words] of [
    [answer * 0.5, 'too small'], [answer * 1.02, 'close, but too large'], [answer * 0.995, 'right'],
    [`${3 * answer}/3`, 'right'], [String(answer).replace('.', ','), 'right'], ['ten', 'not a number'],
  ]) {
    await problem.getByRole('textbox').fill(String(text));
    await expect(problem.locator('output')).toBeEmpty();
    await problem.getByRole('button', { name: 'Check' }).click();
    await expect(problem.locator('output')).toHaveText(words);
  }
  // The page keeps the number and its verdict. The sheet of all problems shows them, too.
  await problem.getByRole('textbox').fill(String(answer));
  await problem.getByRole('button', { name: 'Check' }).click();
  for (const name of ['step01_practice.html', 'problems.html']) {
    await open(page, home + name);
    await expect(problem.getByRole('textbox')).toHaveValue(String(answer));
    await expect(problem.locator('output')).toHaveText('right');
  }
});
