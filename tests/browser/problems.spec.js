// Below each problem that readers solve on paper, a form says whether their answer is right. If the
// answer is wrong, the form says whether the answer is too small or too large.
import { expect, open, test } from './fixtures.js';

test('an answer to a problem is right, close or wrong', async ({ page, home }) => {
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
  // The page keeps the answer and the verdict. The sheet of all problems shows both, too.
  await problem.getByRole('textbox').fill(String(answer));
  await problem.getByRole('button', { name: 'Check' }).click();
  for (const name of ['step01_practice.html', 'problems.html']) {
    await open(page, home + name);
    await expect(problem.getByRole('textbox')).toHaveValue(String(answer));
    await expect(problem.locator('output')).toHaveText('right');
  }
});
