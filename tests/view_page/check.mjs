// check.mjs CHROMIUM PAGE DESKTOP: the viewer's page as a person uses it, from the file system.
import {chromium} from 'playwright-core';
import {existsSync, readFileSync, writeFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';
import {checkAddress} from './address.mjs';
import {checkControls} from './controls.mjs';
import {checkHighlight} from './highlight.mjs';
import {compare, newPage, pixels} from './page.mjs';
import {size, states, tables} from './states.mjs';

const [executablePath, path, desktop] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath,
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-background-networking',
         '--disable-component-update', '--disable-sync', '--no-first-run'],
});
const address = pathToFileURL(path).href, failures = [];
let checks = 0;
const expect = (ok, what) => { ++checks; if (!ok) failures.push(what); };

// Opening.
{
  const opened = await newPage(browser, {width: 1280, height: 800}, expect, 'opening');
  const begin = Date.now();
  await opened.page.goto(address, {waitUntil: 'load'});
  await opened.drawn();
  console.log(`first picture ${Date.now() - begin} ms after the page was asked for`);
  const number = await opened.difference();
  expect(/^difference to the exact answer [\d.]+ %$/.test(number), `the difference is “${number}”`);
  expect((await opened.page.title()).length > 0, 'the page has a title');
  await opened.close();
}

// Each technique draws what the desktop draws.
{
  const view = await newPage(browser, {width: 1000, height: 800}, expect, 'pictures');
  await view.page.goto(address + '#' + states[0].text);
  await view.setSize(...size);
  let compared = 0, worst = 0;
  for (const {name, text} of states) {
    await view.go(text);
    const picture = await pixels(view);
    expect(picture.colors > 20, `${name}: the page draws nothing`);
    const file = `${desktop}/${name}.png`;
    if (!existsSync(file)) continue;
    const {mean} = await compare(view.page, picture.url, 'data:image/png;base64,' + readFileSync(file).toString('base64'));
    worst = Math.max(worst, mean);
    // Two rasterisers may differ along edges and in the last bit; a wrong lookup differs by tens.
    expect(mean < 1, `${name}: page and desktop differ by ${mean.toFixed(2)} of 255 on average`);
    // The number: fewer pixels are compared in the page, fewest where the exact answer is slow.
    const [, theirs] = readFileSync(`${desktop}/${name}.txt`, 'utf8').match(/exact answer: (\S+) of it/);
    const [, ours] = (await view.difference()).match(/(\S+) %$/), slow = tables.techniques.find((t) => t.id === name).slow;
    expect(Math.abs(ours / 100 - theirs) <= (slow ? 0.3 : 0.12) * theirs + 0.002, `${name}: the difference is ${ours} %, on the desktop ${100 * theirs} %`);
    ++compared;
  }
  console.log(`${compared} of ${states.length} techniques compared with the desktop, worst mean difference ${worst.toFixed(3)} of 255`);
  expect(compared === states.length || compared === 0, 'some pictures of the desktop are missing');
  if (compared === 0) console.log('no OpenGL for the desktop path: nothing to compare with');
  await view.close();
}

// What comes first in the file is all that the first picture needs; a page that is cut off says so.
{
  const html = readFileSync(path, 'utf8');
  writeFileSync('cut.html', html.slice(0, html.indexOf('id="zonal-view-rest"')));
  const view = await newPage(browser, {width: 900, height: 700}, expect, 'cut off');
  await view.page.goto(new URL('cut.html', address).href);
  await view.page.waitForFunction(() => globalThis.pictures > 0);
  await view.page.waitForSelector('.zv-message');
  const message = await view.page.textContent('.zv-message');
  expect(message.includes('ends too early'), `cut off: the message is “${message}”`);
  expect((await pixels(view, false)).colors > 20, 'cut off: there is no first picture');
  await view.close();
}

await checkControls(browser, address, expect);
await checkAddress(browser, address, expect);
await checkHighlight(browser, address, new URL('own.html', address).href, expect);

// The context is lost and comes back.
{
  const view = await newPage(browser, {width: 900, height: 700}, expect, 'lost context');
  await view.page.goto(address);
  await view.drawn();
  const before = await pixels(view);
  await view.page.evaluate(() => {
    const gl = document.querySelector('canvas').getContext('webgl2');
    globalThis.lost = gl.getExtension('WEBGL_lose_context');
    globalThis.lost.loseContext();
  });
  await view.page.waitForSelector('.zv-message');
  expect((await view.page.textContent('.zv-notices')).includes('taken away'), 'a lost context is not told');
  await view.page.evaluate(() => globalThis.lost.restoreContext());
  await view.page.waitForSelector('.zv-message', {state: 'detached'});
  await view.drawn();
  const after = await pixels(view);
  const {mean} = await compare(view.page, before.url, after.url);
  expect(mean === 0, `after a lost context the picture differs by ${mean}`);
  await view.close();
}

// Browsers that lack something say what.
for (const [what, take, words] of [
       ['no WebGL 2', () => { HTMLCanvasElement.prototype.getContext = () => null; }, 'no WebGL 2'],
       ['a driver that refuses', () => { WebGL2RenderingContext.prototype.getProgramParameter = () => false; }, 'refuses the shaders'],
       ['no DecompressionStream', () => { delete globalThis.DecompressionStream; }, 'DecompressionStream'],
     ]) {
  const view = await newPage(browser, {width: 900, height: 700}, expect, what);
  await view.page.addInitScript(take);
  await view.page.goto(address);
  await view.page.waitForSelector('.zv-message');
  const message = await view.page.textContent('.zv-message');
  expect(message.includes(words), `${what}: the message is “${message}”`);
  expect((await view.page.textContent('.zv-words')).length > 100, `${what}: the explanation is missing`);
  await view.close();
}
{
  const view = await newPage(browser, {width: 900, height: 700}, expect, 'no floats');
  await view.page.addInitScript(() => {
    const original = WebGL2RenderingContext.prototype.getExtension;
    WebGL2RenderingContext.prototype.getExtension = function(name) { return name.includes('color_buffer') ? null : original.call(this, name); };
  });
  await view.page.goto(address);
  await view.drawn();
  const number = await view.difference();
  expect(number.includes('cannot be had'), `no floats: it says “${number}”`);
  await view.close();
}

// Sizes and colours of screens.
for (const [width, height] of [[390, 844], [320, 640], [768, 1024], [1280, 800], [1920, 1080]]) {
  for (const colorScheme of ['light', 'dark']) {
    const view = await newPage(browser, {width, height}, expect, `${width} wide, ${colorScheme}`, colorScheme);
    await view.page.goto(address);
    await view.drawn();
    const facts = await view.page.evaluate(() => ({
      overflow: document.scrollingElement.scrollWidth - document.documentElement.clientWidth,
      picture: document.querySelector('canvas').getBoundingClientRect().toJSON(),
      unnamed: [...document.querySelectorAll('input, select, button, canvas')]
          .filter((e) => !e.getAttribute('aria-label') && !e.labels?.length && !e.textContent.trim()).length,
      paper: getComputedStyle(document.body).backgroundColor,
    }));
    expect(facts.overflow <= 0, `${width} wide: the page is ${facts.overflow} pixels too wide`);
    expect(facts.picture.height > 150 && facts.picture.width > 250, `${width} wide: the picture is too small`);
    expect(facts.picture.bottom <= height, `${width} wide: the picture is not on the first screen`);
    expect(facts.unnamed === 0, `${width} wide: ${facts.unnamed} inputs have no label`);
    expect((facts.paper === 'rgb(20, 20, 20)') === (colorScheme === 'dark'), `${width} wide: ${colorScheme} is ${facts.paper}`);
    await view.close();
  }
}

await browser.close();
for (const failure of failures) console.log('failed: ' + failure);
console.log(`${checks - failures.length} checks passed, ${failures.length} failed`);
process.exit(failures.length === 0 && checks >= 150 ? 0 : 1);
