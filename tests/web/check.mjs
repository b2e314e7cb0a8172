// check.mjs CHROMIUM ZONAL PAGE: panoramas are dropped into the page, which was written for another one.
import {chromium} from 'playwright-core';
import {execFileSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';
import {compare, newPage, pixels} from './page.mjs';

const [executablePath, zonal, path] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath,
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-background-networking',
         '--disable-component-update', '--disable-sync', '--no-first-run'],
});
const failures = [], states = ['technique=split-sum&roughness=0.3&yaw=40', 'technique=lambert&mesh=torus-knot&yaw=120&pitch=-30',
                               'technique=sh-bands&bands=3&mesh=bumpy&yaw=-100', 'technique=extracted-lights&yaw=200'];
let checks = 0;
const expect = (ok, what) => { ++checks; if (!ok) failures.push(what); };
const wait = {timeout: 120000};

// As a person drops a file from a file manager.
const drop = async (page, name, bytes) => {
  const transfer = await page.evaluateHandle(([file, base64]) => {
    const letters = atob(base64), data = new DataTransfer();
    data.items.add(new File([Uint8Array.from(letters, (c) => c.charCodeAt(0))], file));
    return data;
  }, [name, bytes.toString('base64')]);
  for (const type of ['dragenter', 'dragover', 'drop']) await page.dispatchEvent('.zv-picture', type, {dataTransfer: transfer});
};
const choose = (page, file) => page.setInputFiles('.zv-light input[type=file]', file);
const shown = (page, name) => page.waitForFunction((title) => document.querySelector('h1').textContent === title &&
    document.querySelector('.zv-work').hidden, name, wait);
const refusal = async (page) => {
  await page.waitForSelector('.zv-message', wait);
  return page.textContent('.zv-message span');
};
const small = async (address, where) => {
  const view = await newPage(browser, {width: 1000, height: 800}, expect, where);
  await view.page.goto(address);
  await view.setSize(320, 240);
  return view;
};
const pageOf = (file, ...options) => {
  execFileSync(zonal, ['view', file, '--html', file + '.html', '--quiet', ...options]);
  return pathToFileURL(file + '.html').href;
};

const view = await small(pathToFileURL(path).href, 'dropping'), {page} = view;
const day = await pixels(view), opened = await page.textContent('h1');

// The same pictures in the two formats that a browser writes: one that the command reads, too, and one without loss.
const encoded = (type, quality) => page.evaluate(async ([url, as, how]) => {
  const image = Object.assign(new Image(), {src: url});
  await image.decode();
  const canvas = Object.assign(document.createElement('canvas'), {width: image.width, height: image.height});
  canvas.getContext('2d').drawImage(image, 0, 0);
  return canvas.toDataURL(as, how).split(',')[1];
}, ['data:image/png;base64,' + readFileSync('card.png').toString('base64'), type, quality]).then((text) => Buffer.from(text, 'base64'));
writeFileSync('card.jpg', await encoded('image/jpeg', 0.9));
writeFileSync('card.webp', await encoded('image/webp', 1));

// What is dropped looks like a page written for it.
let worst = 0;
for (const [file, likeness, options, from] of [['card.hdr', 'card.hdr', [], ''], ['card.exr', 'card.exr', [], ''], ['card.png', 'card.png', [], ''],
                                              ['card.jpg', 'card.jpg', [], ''], ['card.webp', 'card.png', [], ''],
                                              ['disc.pfm', 'disc.pfm', ['--from', 'angular'], 'angular']]) {
  const theirs = await small(pageOf(likeness, ...options), likeness);
  await page.evaluate((value) => { document.querySelector('details.zv-reading').open = value !== ''; }, from);
  if (from !== '') await page.selectOption('select[name=from]', from);
  if (/\.(hdr|exr)$/.test(file)) await drop(page, file, readFileSync(file));
  else await choose(page, file);
  await shown(page, file);
  expect(await page.title() === file, `${file}: the title is ${await page.title()}`);
  const exposures = await Promise.all([page, theirs.page].map((one) => one.inputValue('input[name=exposure_ev]')));
  expect(exposures[0] === exposures[1], `${file}: opens at ${exposures[0]} EV, not at ${exposures[1]}`);
  for (const state of file === 'card.hdr' ? states : states.slice(0, 2)) {  // all techniques read one set of tables
    await view.go(state);
    await theirs.go(state);
    const [ours, other] = [await pixels(view), await pixels(theirs)];
    const {mean} = await compare(page, ours.url, other.url);
    worst = Math.max(worst, mean);
    expect(mean < 1, `${file}, ${state}: differs by ${mean.toFixed(2)} of 255 from its own page`);
    const {mean: moved} = await compare(page, ours.url, day.url);
    expect(moved > 5, `${file}, ${state}: the picture is still that of the day`);
  }
  await theirs.close();
}
console.log(`dropped pictures and those of their own pages: worst mean difference ${worst.toFixed(4)} of 255`);

// Broken ones are told, and the light stays.
await page.selectOption('select[name=from]', '');
expect((await refusal(page)).includes('neither its shape, 200x200'), 'a square is not asked about');
await choose(page, 'card.hdr');
await shown(page, 'card.hdr');
expect(await page.locator('.zv-message').count() === 0, 'the message outlives its file');
const before = await pixels(view);
const values = new Float32Array(3 * 64 * 32).fill(0.5);
values[0] = NaN;
const broken = Buffer.concat([Buffer.from('PF\n64 32\n-1.0\n'), Buffer.from(values.buffer)]);
for (const [name, bytes, words] of [['short.hdr', readFileSync('card.hdr').subarray(0, 3000), 'ends early'],
                                    ['short.png', readFileSync('card.png').subarray(0, 60), 'cannot decode'],
                                    ['sky.exr', Buffer.from([0x76, 0x2f, 0x31, 0x01]), 'ends early'],
                                    ['bad.pfm', broken, '1 texel is not finite']]) {
  await drop(page, name, bytes);
  await page.waitForFunction((text) => document.querySelector('.zv-message span')?.textContent.includes(text), words, wait)
      .catch(() => {});
  const message = await refusal(page);
  expect(message.includes(name) && message.includes(words), `${name}: it says “${message}”`);
  expect(await page.textContent('h1') === 'card.hdr', `${name}: the title changed`);
}
const after = await compare(page, before.url, (await pixels(view)).url);
expect(after.mean === 0, `a refused file changed the picture by ${after.mean}`);
await page.check('input[name=fix]');
await shown(page, 'bad.pfm');
expect((await page.textContent('.zv-light [role=status]')).includes('1 texels were not finite'), 'a repair is not told');

// Cancelled: all is as before, and the page lives while the worker works.
await page.evaluate(() => {
  globalThis.frames = 0;
  const count = () => { ++globalThis.frames; requestAnimationFrame(count); };
  count();
});
const begun = await page.evaluate(() => globalThis.frames);
await choose(page, 'large.hdr');
await page.waitForFunction((from) => !document.querySelector('.zv-work').hidden && globalThis.frames > from + 5, begun, wait);
await page.click('text=Cancel');
expect(await page.evaluate(() => document.querySelector('.zv-work').hidden), 'Cancel leaves the progress standing');
await page.waitForTimeout(1500);
expect(await page.textContent('h1') === 'bad.pfm', 'a cancelled file is shown after all');
const frames = await page.evaluate(() => globalThis.frames);
await choose(page, 'large.hdr');
await shown(page, 'large.hdr');
expect(await page.evaluate(() => globalThis.frames) > frames + 10, 'the page stands still while the library works');

// A lost context brings the dropped light back, not the first one.
const large = await pixels(view);
await page.evaluate(() => {
  globalThis.lost = document.querySelector('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
  globalThis.lost.loseContext();
});
await page.waitForSelector('.zv-message');
await page.evaluate(() => globalThis.lost.restoreContext());
await page.waitForSelector('.zv-message', {state: 'detached'});
await view.drawn();
const {mean: back} = await compare(page, large.url, (await pixels(view)).url);
expect(back === 0, `after a lost context the picture differs by ${back}`);
expect(opened === 'A clear day', `the page opened as ${opened}`);
await view.close();

await browser.close();
for (const failure of failures) console.log('failed: ' + failure);
console.log(`${checks - failures.length} checks passed, ${failures.length} failed`);
process.exit(failures.length === 0 && checks >= 55 ? 0 : 1);
