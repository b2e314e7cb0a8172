// The address of the page keeps its settings and says what it cannot take.
import {newPage} from './page.mjs';

const hashOf = (page) => page.evaluate(() => location.hash.slice(1));
const wait = (page, text) => page.waitForFunction((hash) => location.hash.slice(1) === hash, text, {timeout: 60000});

export const checkAddress = async (browser, address, expect) => {
  const view = await newPage(browser, {width: 1100, height: 800}, expect, 'address'), {page} = view;
  const text = 'technique=sh-bands&mesh=torus-knot&yaw=-20.5&distance=4&compare=2&bands=5&window_strength=0.62';
  await page.goto(address + '#' + text);
  await view.drawn();
  expect(await page.inputValue('select[name=technique]') === 'sh-bands', 'the technique of the address is not taken');
  expect(await page.inputValue('input[name=bands]') === '5', 'the number of bands of the address is not taken');
  expect(await page.inputValue('input[name=yaw]') === '-20.5', 'the eye of the address is not taken');
  expect(await page.isChecked('input[name=compare][value="2"]'), 'the comparison of the address is not taken');
  await view.difference();
  expect(await hashOf(page) === text, `the address became ${await hashOf(page)}`);

  await page.locator('input[name=bands]').focus();
  await page.keyboard.press('ArrowRight');
  await wait(page, text.replace('bands=5', 'bands=6'));
  await page.reload();
  await view.drawn();
  expect(await page.inputValue('input[name=bands]') === '6', 'what was set is lost when the page is opened again');
  await page.click('text=All as at first');
  await page.waitForFunction(() => !location.hash.includes('&'), undefined, {timeout: 60000});

  for (const [bad, words] of [['roughness=7', 'it goes from 0 to 1'], ['rouhgness=0.5', 'no setting “rouhgness”'],
                              ['technique=magic', 'no technique “magic”'], ['mesh=teapot', 'no object “teapot”'],
                              ['yaw=0x10', 'not a number'], ['yaw=', 'not a number'], ['compare=1.5', 'whole number'],
                              ['bands', 'not a setting'], ['%', 'not a setting'], ['yaw=1e999', 'it goes from'],
                              ['<img src=x onerror=alert(1)>=1', 'no setting “<img']]) {
    await page.evaluate((hash) => { location.hash = hash; }, 'albedo=0.35&' + bad);
    await page.waitForSelector('.zv-message');
    const message = await page.textContent('.zv-message');
    expect(message.includes(words), `${bad}: the message is “${message}”`);
    expect(await page.inputValue('input[name=albedo]') === '0.35', `${bad}: what is right is not taken`);
    expect(await page.locator('img').count() === 0, `${bad}: markup came out of the address`);
    await page.evaluate(() => { location.hash = 'technique=lambert'; });
    await page.waitForSelector('.zv-message', {state: 'detached'});
  }
  await view.close();
};
