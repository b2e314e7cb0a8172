// A person's own highlight: painted with a pointer, and from a file as the command takes it.
import {existsSync, readFileSync} from 'node:fs';
import {compare, newPage, pixels} from './page.mjs';

const settings = 'technique=highlight-map&highlight_source=2&yaw=30';
const asUrl = (file) => 'data:image/png;base64,' + readFileSync(file).toString('base64');

// Mean light of the left and of the right half.
const halves = ({page}, url) => page.evaluate(async (source) => {
  const image = new Image();
  image.src = source;
  await image.decode();
  const {width, height} = image;
  const context = Object.assign(document.createElement('canvas'), {width, height}).getContext('2d');
  context.drawImage(image, 0, 0);
  const {data} = context.getImageData(0, 0, width, height), sums = [0, 0];
  data.forEach((value, i) => { if (i % 4 < 3) sums[i / 4 % width < width / 2 ? 0 : 1] += value; });
  return sums.map((sum) => 2 * sum / data.length);
}, url);

// own: a page made with --highlight card.png, and the desktop's picture of the same.
export const checkHighlight = async (browser, address, own, expect) => {
  const view = await newPage(browser, {width: 1100, height: 1000}, expect, 'painting'), {page} = view;
  await page.goto(address + '#' + settings);
  await view.setSize(320, 240);
  const disc = page.locator('.zv-paint canvas'), shown = async () => { await view.drawn(); return (await pixels(view)).url; };
  expect(await disc.isVisible(), 'there is no disc to paint on');
  const before = await shown();
  const stroke = async (...path) => {
    await disc.scrollIntoViewIfNeeded();
    const box = await disc.boundingBox();
    const places = path.map(([u, v]) => [box.x + u * box.width, box.y + v * box.height]);
    await page.mouse.move(...places[0]);
    await page.mouse.down();
    for (const place of places.slice(1)) await page.mouse.move(...place, {steps: 4});
    await page.mouse.up();
    return shown();
  };
  const painted = await stroke([0.25, 0.3], [0.25, 0.7]);
  const [left, right] = await halves(view, painted), [leftBefore, rightBefore] = await halves(view, before);
  expect(left > leftBefore + 1, `painting on the left brightens it from ${leftBefore} to ${left}`);
  expect(Math.abs(right - rightBefore) < 0.1, `painting on the left changes the right from ${rightBefore} to ${right}`);
  await page.locator('.zv-paint input[name=size]').fill('0.5');
  await page.getByLabel('erase').check();
  await stroke([0.25, 0.1], [0.25, 0.9]);  // a soft brush leaves a tenth beside its middle
  const erased = await stroke([0.25, 0.1], [0.25, 0.9]);
  expect((await compare(page, before, erased)).mean < 0.3, 'what was erased is still there');
  await page.getByLabel('erase').uncheck();
  await page.locator('.zv-paint input[type=color]').fill('#ff0000');
  expect((await compare(page, before, await stroke([0.5, 0.5]))).mean > 0.5, 'a red dab is not seen');
  await page.locator('.zv-paint').getByText('Clear').click();
  const {mean: left_over} = await compare(page, before, await shown());
  expect(left_over === 0, `cleared, it is ${left_over} of 255 from what it was before`);

  await page.setInputFiles('.zv-file input', 'text.png');
  await page.waitForFunction(() => document.querySelector('.zv-paint [role=status]').textContent.includes('no picture'));
  await page.setInputFiles('.zv-file input', 'card.png');
  await page.waitForFunction(() => document.querySelector('.zv-paint [role=status]').textContent.includes('is your highlight'));
  const opened = await shown();
  expect((await compare(page, before, opened)).mean > 0.5, 'a picture file changes nothing');
  await page.goto(own + '#yaw=30');
  await view.setSize(320, 240);
  const made = await shown();
  expect((await compare(page, opened, made)).mean < 0.5, 'a file opened in the page is not what the command makes of it');
  if (existsSync('own.png')) {
    const {mean} = await compare(page, made, asUrl('own.png'));
    expect(mean < 1, `the page made with a highlight differs from the desktop by ${mean.toFixed(2)}`);
  }
  await page.selectOption('select[name=highlight_source]', {index: 0});
  expect(!await disc.isVisible(), 'the disc stays when another highlight is chosen');
  await view.close();
};
