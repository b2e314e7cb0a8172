// Every control, turned as a person turns it, changes the picture as its label says.
import {compare, newPage, pixels} from './page.mjs';
import {tables} from './states.mjs';

// What a control does from its least to its greatest value: to the light of the object, or to the detail on it. The rest
// only have to change something. `state`: in which it can be seen; by itself the first technique that lists it. `page`:
// of another light, beside the first.
const known = {
  exposure_ev: {state: 'technique=irradiance-map', from: -2, to: 2, does: 'brighter'},
  light_yaw_deg: {state: 'technique=cube-map', from: 0, to: 90},
  light_pitch_deg: {state: 'technique=cube-map', from: 0, to: 60},
  light_roll_deg: {state: 'technique=cube-map', from: 0, to: 90},
  compare: {state: 'technique=ambient-cube'},
  tone_curve: {state: 'technique=irradiance-map&exposure_ev=3'},
  difference_gain: {state: 'technique=ambient-cube&compare=2'},
  albedo: {state: 'technique=irradiance-map', does: 'brighter'},
  ambient_light: {does: 'brighter', from: 0, to: 1},
  ambient_brdf: {state: 'technique=lambert&ambient_light=2', from: 0, to: 3},
  bump_depth: {does: 'rougher'},
  highlight_strength: {does: 'brighter'},
  blur_level: {does: 'smoother'},
  shininess: {state: 'technique=phong', does: 'rougher'},
  roughness: {state: 'technique=split-sum', does: 'smoother'},
  f0: {state: 'technique=split-sum', does: 'brighter'},
  bands: {state: 'technique=sh-bands&tint_negative=0', from: 1, to: 3, does: 'rougher'},
  window_kind: {state: 'technique=sh-bands&window_strength=1&bands=6'},
  tint_negative: {page: 'sun.html', state: 'technique=sh-bands&bands=4'},
  highlight_source: {from: 0, to: 2},
  yaw: {from: 0, to: 90},
  turn_by: {state: 'technique=TECHNIQUE&bands=6&light_yaw_deg=50&light_pitch_deg=-35&light_roll_deg=110', does: 'nothing'},
  // The technique does not see the size of a lamp; its exact answer does, where the horizon cuts it.
  lamp_radius: {state: 'technique=near-lamp&compare=2&difference_gain=32'},
  light_set: {from: 1, to: 2},
  sky_form: {state: 'technique=TECHNIQUE&sky_map=1&shininess=100'},
  sky_grey: {state: 'technique=TECHNIQUE&sky_ground=2', does: 'brighter'},
  window_strength: {state: 'technique=sh-bands&window_kind=1&bands=6&tint_negative=0', does: 'smoother'},
};

// Mean light, and mean change from pixel to pixel, of the middle of the object.
const figures = ({page}, url) => page.evaluate(async (source) => {
  const image = new Image();
  image.src = source;
  await image.decode();
  const context = Object.assign(document.createElement('canvas'), {width: image.width, height: image.height}).getContext('2d');
  context.drawImage(image, 0, 0);
  const edge = Math.round(image.height / 2);
  const {data} = context.getImageData((image.width - edge) / 2, (image.height - edge) / 2, edge, edge);
  let light = 0, change = 0;
  for (let i = 4; i < data.length; i += 4) {
    for (let c = 0; c < 3; ++c) {
      light += data[i + c];
      change += Math.abs(data[i + c] - data[i + c - 4]);
    }
  }
  return {light: light / data.length, change: change / data.length};
}, url);

const turn = async (page, field, value) => {
  if (field.kind === 'slider') {
    const input = page.locator(`input[name=${field.name}]`);
    await input.focus();
    if (value === field.least) await input.press('Home');
    else if (value === field.greatest) await input.press('End');
    else await input.fill(String(value));
  } else if (field.kind === 'toggle') {
    await page.locator(`input[name=${field.name}]`).setChecked(value !== 0);
  } else if (await page.locator(`select[name=${field.name}]`).count() > 0) {
    await page.selectOption(`select[name=${field.name}]`, {label: field.choices[value]});
  } else {
    await page.locator('.zv-option', {has: page.locator(`input[name=${field.name}]`)}).nth(value).click();
  }
};

export const checkControls = async (browser, address, expect) => {
  const view = await newPage(browser, {width: 1100, height: 1000}, expect, 'controls'), {page} = view;
  const open = async (where) => {
    await page.goto(where);
    await view.drawn();
    await page.locator('summary', {hasText: 'Eye'}).click();
    await view.setSize(320, 240);
  };
  await open(address);
  let turned = 0, directions = 0;
  for (const field of [...tables.controls, ...tables.camera.map((f) => ({kind: 'slider', ...f}))]) {
    const {page: other, state, does, from = field.least, to = field.greatest} = known[field.name] ?? {};
    const first = tables.techniques.find((t) => t.controls.includes(field.name))?.id ?? 'cube-map';
    if (other) await open(new URL(other, address).href);
    await view.go((state ?? 'technique=TECHNIQUE').replace('TECHNIQUE', first));
    const shown = [];
    for (const value of [from, to]) {
      await turn(page, field, value);
      await view.drawn();
      const {url} = await pixels(view);
      shown.push({url, ...await figures(view, url)});
    }
    const [a, b] = shown, {mean} = await compare(page, a.url, b.url);
    if (does === 'nothing') expect(mean < 0.05, `${field.name}: two ways to one picture differ by ${mean.toFixed(3)}`);
    else expect(mean > 0.02, `${field.name}: nothing changes from ${from} to ${to}`);
    if (does === 'brighter') expect(b.light > a.light + 1, `${field.name}: ${a.light.toFixed(1)} becomes ${b.light.toFixed(1)}, not brighter`);
    if (does === 'rougher') expect(b.change > 1.05 * a.change, `${field.name}: ${a.change.toFixed(3)} becomes ${b.change.toFixed(3)}, not rougher`);
    if (does === 'smoother') expect(b.change < 0.95 * a.change, `${field.name}: ${a.change.toFixed(3)} becomes ${b.change.toFixed(3)}, not smoother`);
    if (other) await open(address);
    directions += does && does !== 'nothing' ? 1 : 0;
    ++turned;
  }
  expect(turned === tables.controls.length + 4 && directions >= 11, `${turned} controls turned, ${directions} with a direction`);

  // A control whose effect makes one technique another.
  for (const [one, other] of [['technique=bump&bump_depth=0', 'technique=blinn-newell'],
                              ['technique=highlight-map&highlight_strength=0', 'technique=irradiance-map'],
                              ['technique=cube-map&compare=1', 'technique=blinn-newell']]) {
    const urls = [];
    for (const text of [one, other]) {
      await view.go(text);
      urls.push((await pixels(view)).url);
    }
    const {mean} = await compare(page, ...urls);
    expect(mean < 0.05, `${one} differs from ${other} by ${mean.toFixed(3)}`);
  }

  // Every technique and object is chosen from its list; own controls are there when their technique is.
  let chosen = 0;
  for (const {id, title, controls, explanation} of tables.techniques) {
    await page.selectOption('select[name=technique]', {label: title});
    expect(await page.textContent('.zv-words p') === explanation, `${id}: its explanation is not shown`);
    for (const field of tables.controls.filter((f) => !f.common)) {
      const there = await page.locator(`[name=${field.name}]`).first().isVisible();
      expect(there === controls.includes(field.name), `${id}: ${field.name} is ${there ? '' : 'not '}shown`);
    }
    ++chosen;
  }
  expect(chosen === tables.techniques.length && chosen >= 17, `${chosen} techniques chosen`);
  await page.selectOption('select[name=technique]', 'cube-map');
  const objects = new Set();
  for (const {name} of tables.meshes) {
    await page.selectOption('select[name=mesh]', name);
    await view.drawn();
    objects.add((await pixels(view)).url);
  }
  expect(objects.size === tables.meshes.length, 'two objects look the same');

  // Keys, dragging, wheel.
  const field = (name) => page.evaluate((n) => Number(document.querySelector(`input[name=${n}]`).value), name);
  await page.click('text=All as at first');
  await page.focus('canvas');
  const yaw = await field('yaw'), distance = await field('distance');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('+');
  expect(await field('yaw') === yaw + 5 - (yaw + 5 > 180 ? 360 : 0), 'the arrow keys do not turn the eye');
  expect(await field('distance') < distance, 'plus does not bring the object nearer');
  const box = await page.locator('.zv-picture canvas').boundingBox(), x = box.x + box.width / 2, y = box.y + box.height / 2;
  const pitch = await field('pitch');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y + 50, {steps: 4});
  await page.mouse.up();
  expect(await field('pitch') > pitch + 10, 'dragging down does not lift the eye');
  const near = await field('distance');
  await page.mouse.wheel(0, 300);
  await page.waitForFunction((d) => Number(document.querySelector('input[name=distance]').value) > d, near);
  await page.click('text=All as at first');
  expect(await field('distance') === distance && await field('yaw') === yaw, 'the button does not take all back');

  // Nothing is drawn while nothing changes.
  await view.drawn();
  await view.difference();
  const pictures = await view.pictures();
  await page.waitForTimeout(700);
  expect(await view.pictures() === pictures, 'the page draws though nothing changed');
  await view.close();
};
