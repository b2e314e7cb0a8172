// check.mjs CHROMIUM ZONAL: the page of zonal fisheye as a person uses it, from the file system.
import {chromium} from 'playwright-core';
import {execFileSync} from 'node:child_process';
import {existsSync, rmSync} from 'node:fs';
import {pathToFileURL} from 'node:url';

const [executablePath, zonal] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath,
  args: ['--no-sandbox', '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run'],
});
const failures = [];
let checks = 0;
const expect = (ok, what) => { ++checks; if (!ok) failures.push(what); };
const photograph = 240;  // pixels a side, as run.sh makes it

// A page under watch: what the browser complains about or asks the network for is a failure when it is closed.
const open = async (mode, options, where) => {
  const context = await browser.newContext(options), page = await context.newPage();
  const complaints = [], outside = [];
  page.on('console', (message) => complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('request', (request) => { if (!/^(file|data):/.test(request.url())) outside.push(request.url()); });
  await page.goto(pathToFileURL(`${mode}/index.html`).href, {waitUntil: 'load'});
  await page.waitForSelector('#circle-tool:not([hidden])');
  await drawn(page);
  return {page, context, close: async () => {
    expect(complaints.length === 0, `${where}: the browser says: ${complaints.join('; ')}`);
    expect(outside.length === 0, `${where}: it asks the network for ${outside.join(', ')}`);
    await context.close();
  }};
};
// The previews are drawn in the frame after a change.
const drawn = (page) => page.evaluate(async () => {
  for (let i = 0; i < 3; ++i) await new Promise(requestAnimationFrame);
});
const state = (page) => page.evaluate(() => {
  const value = (name) => Number(document.getElementById('circle-' + name).value);
  const ring = document.getElementById('circle-ring');
  const pixels = (name) => document.getElementById('preview-' + name).toDataURL();
  return {x: value('x'), y: value('y'), radius: value('radius'), shininess: value('shininess'),
          ring: ['cx', 'cy', 'r'].map((name) => Number(ring.getAttribute(name))),
          command: document.getElementById('circle-command').textContent,
          published: pixels('published'), corrected: pixels('corrected')};
});
// Where a pixel of the photograph is in the window, and how many of the window's pixels it is wide.
const placer = async (page) => {
  await page.locator('#circle-overlay').scrollIntoViewIfNeeded();
  const box = await page.locator('#circle-overlay').boundingBox(), scale = box.width / photograph;
  return {scale, at: (x, y) => [box.x + x * scale, box.y + y * scale]};
};
const near = (is, meant, off) => Math.abs(is - meant) <= off;
// Numbers, ring and command tell the same circle; the previews are those of it.
const followed = async (page, before, meant, where) => {
  await drawn(page);
  const now = await state(page);
  for (const name of ['x', 'y', 'radius']) {
    expect(near(now[name], meant[name] ?? before[name], 1), `${where}: ${name} is ${now[name]}, not ${meant[name] ?? before[name]}`);
  }
  expect(near(now.ring[0], now.x, 0.1) && near(now.ring[1], now.y, 0.1) && near(now.ring[2], now.radius, 0.1),
         `${where}: the ring is drawn at ${now.ring}`);
  expect(now.command.includes(` --center ${now.x},${now.y} --radius ${now.radius} `), `${where}: the command is ${now.command}`);
  expect(now.published !== before.published && now.corrected !== before.corrected, `${where}: a preview does not follow`);
  return now;
};

// Sizes and colours of screens; what is in the page.
for (const [name, width, height] of [['desktop', 1280, 900], ['phone', 390, 844], ['small phone', 320, 640]]) {
  for (const colorScheme of ['light', 'dark']) {
    const where = `${name}, ${colorScheme}`, view = await open('corrected', {viewport: {width, height}, colorScheme}, where);
    const facts = await view.page.evaluate(() => ({
      title: document.title,
      overflow: document.scrollingElement.scrollWidth - document.documentElement.clientWidth,
      images: [...document.images].map((i) => ({done: i.complete && i.naturalWidth > 0, alt: i.alt})),
      unnamed: [...document.querySelectorAll('input, canvas')].filter((e) => !e.getAttribute('aria-label') && !e.labels?.length).length,
      inputs: document.querySelectorAll('#circle-tool input').length,
      overlay: document.getElementById('circle-overlay').getBoundingClientRect().width,
      text: document.body.textContent,
      paper: getComputedStyle(document.body).backgroundColor,
    }));
    expect(facts.title === 'a sky.png', `${where}: the title is “${facts.title}”`);
    expect(facts.overflow <= 0, `${where}: the page is ${facts.overflow} pixels too wide`);
    expect(facts.images.length === 19, `${where}: ${facts.images.length} pictures`);  // 3 forms x 3 x 2 maps, photograph
    expect(facts.images.every((i) => i.done && i.alt !== ''), `${where}: a picture is missing or has no description`);
    expect(facts.images.filter((i) => i.alt.includes('difference, white at')).length === 6, `${where}: differences are missing`);
    expect(facts.inputs === 5 && facts.unnamed === 0, `${where}: ${facts.unnamed} of ${facts.inputs} inputs have no label`);
    expect(facts.overlay > 200, `${where}: the photograph is too small to drag on`);
    const luma = facts.paper.match(/\d+/g).slice(0, 3).reduce((sum, c) => sum + Number(c), 0);
    expect((luma < 384) === (colorScheme === 'dark'), `${where}: the paper is ${facts.paper}`);
    for (const words of ['weights alone', 'ground alone', 'codes averaged']) expect(facts.text.includes(words), `${where}: no “${words}”`);
    await view.close();
  }
}

// The mouse.
{
  const view = await open('corrected', {viewport: {width: 1280, height: 900}}, 'mouse'), {page} = view;
  const drag = async (from, to) => {
    const {at} = await placer(page);
    await page.mouse.move(...at(...from));
    await page.mouse.down();
    await page.mouse.move(...at(...to), {steps: 5});
    await page.mouse.up();
  };
  const first = await state(page);
  expect(first.x === 110 && first.y === 130 && first.radius === 100 && first.shininess === 20, `at first it is ${JSON.stringify(first)}`);
  await drag([110, 130], [130, 115]);
  const moved = await followed(page, first, {x: 130, y: 115}, 'the centre dragged');
  await drag([130 + moved.radius, 115], [130 + moved.radius - 30, 115]);
  const smaller = await followed(page, moved, {radius: moved.radius - 30}, 'the rim dragged');
  await drag([150, 120], [150 - 400, 120 + 400]);
  const edge = await followed(page, smaller, {x: 0, y: photograph}, 'dragged out of the picture');
  await page.mouse.move(...(await placer(page)).at(60, 60));
  await drawn(page);
  expect((await state(page)).x === edge.x, 'the circle follows a pointer that does not hold it');
  await view.close();
}

// A finger.
{
  const view = await open('published', {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true}, 'finger'), {page} = view;
  const first = await state(page), {at} = await placer(page);
  const session = await view.context.newCDPSession(page), scroll = await page.evaluate(() => scrollY);
  const touch = (type, place) => session.send('Input.dispatchTouchEvent', {
    type, touchPoints: place ? [{x: at(...place)[0], y: at(...place)[1]}] : []});
  await touch('touchStart', [110, 130]);
  for (const place of [[115, 120], [120, 110], [125, 100]]) await touch('touchMove', place);
  await touch('touchEnd');
  await followed(page, first, {x: 125, y: 100}, 'dragged by a finger');
  expect(await page.evaluate(() => scrollY) === scroll, 'the page scrolls under the finger');
  await view.close();
}

// Keys alone, and typing.
{
  const view = await open('published', {viewport: {width: 1280, height: 900}}, 'keys'), {page} = view;
  await page.focus('#circle-x');
  const names = [];
  for (let i = 0; i < 5; ++i) {
    names.push(await page.evaluate(() => document.activeElement.id));
    await page.keyboard.press('Tab');
  }
  expect(names.join() === 'circle-x,circle-y,circle-radius,circle-shininess,circle-ground', `the order of the inputs is ${names}`);
  let last = await state(page);
  for (const [name, key, by] of [['x', 'ArrowUp', 0.5], ['y', 'ArrowDown', -0.5], ['radius', 'ArrowUp', 0.5]]) {
    await page.focus('#circle-' + name);
    for (let i = 0; i < 8; ++i) await page.keyboard.press(key);
    last = await followed(page, last, {[name]: last[name] + 8 * by}, `${name} by ${key}`);
  }
  await page.focus('#circle-shininess');
  await page.keyboard.press('Home');
  await drawn(page);
  const soft = await state(page);
  expect(soft.shininess === 1 && soft.command.includes('--shininess 1 '), `the least shininess is ${soft.shininess}: ${soft.command}`);
  expect(soft.published !== last.published && soft.corrected !== last.corrected, 'the previews do not follow the shininess');
  await page.fill('#circle-radius', '80');
  await followed(page, soft, {radius: 80}, 'a radius typed');
  await page.fill('#circle-radius', '');
  expect((await state(page)).command.includes(`--radius ${photograph / 2} `), 'an empty field is not the largest circle that fits');
  await page.fill('#circle-radius', '80');
  await page.fill('#circle-ground', '#ff8000');
  await drawn(page);
  const bright = await state(page);
  expect(bright.command.includes('--ground 1,0.502,0 '), `the ground is not in the command: ${bright.command}`);
  expect(bright.published !== soft.published, 'the previews do not follow the ground');
  await view.close();
}

// The command does what the page previews: the maps it makes look like the previews.
for (const mode of ['published', 'corrected']) {
  const view = await open(mode, {viewport: {width: 1280, height: 900}}, `${mode} again`), {page} = view;
  await page.fill('#circle-x', '120');
  await page.fill('#circle-y', '120');
  await page.fill('#circle-radius', '90');
  await drawn(page);
  const {command} = await state(page);
  rmSync('maps', {recursive: true, force: true});
  execFileSync('sh', ['-c', command.replace(/^zonal/, '"$0"') + ' --quiet', zonal], {stdio: ['ignore', 'ignore', 'inherit']});
  expect(existsSync('maps/index.html'), `${command}: makes no page`);
  const preview = await page.evaluate((name) => document.getElementById('preview-' + name).toDataURL(), mode);
  await page.goto(pathToFileURL('maps/index.html').href, {waitUntil: 'load'});
  const mean = await page.evaluate(async ([url, words]) => {
    const map = [...document.images].filter((i) => i.alt === words).at(-1), image = new Image();
    image.src = url;
    await image.decode();
    const [a, b] = [map, image].map((picture) => {
      const context = Object.assign(document.createElement('canvas'), {width: 41, height: 41}).getContext('2d');
      context.drawImage(picture, 0, 0, 41, 41);
      return context.getImageData(0, 0, 41, 41).data;
    });
    // Inside of the circle; at its edge a map's pixels end elsewhere than a preview's.
    let sum = 0, count = 0;
    for (let i = 0; i < a.length; ++i) {
      if (i % 4 === 3 || Math.hypot((i >> 2) % 41 - 20, Math.floor((i >> 2) / 41) - 20) > 19) continue;
      sum += Math.abs(a[i] - b[i]);
      ++count;
    }
    return sum / count;
  }, [preview, `paraboloid, ${mode}`]);
  console.log(`${mode}: the preview and the map of the command differ by ${mean.toFixed(2)} of 255 on average`);
  // The preview sums over 41 x 41 points of a photograph of 180, in 8 bits.
  expect(mean < 3, `${mode}: preview and map differ by ${mean.toFixed(2)}`);
  await view.close();
}

await browser.close();
for (const failure of failures) console.log('failed: ' + failure);
console.log(`${checks - failures.length} checks passed, ${failures.length} failed`);
process.exit(failures.length === 0 && checks >= 120 ? 0 : 1);
