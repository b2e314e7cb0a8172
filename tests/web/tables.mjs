// tables.mjs FILE...: FILE.html is what the command made of each FILE.
import {readFileSync} from 'node:fs';
import {answer, tablesOf} from './worker.mjs';

const failures = [];
let checks = 0;
const expect = (ok, what) => { ++checks; if (!ok) failures.push(what); };

const planes = (bytes, at, count, width) => {
  const numbers = [];
  for (let i = 0; i < count; ++i) {
    let number = 0;
    for (let plane = width; plane-- > 0;) number = number * 256 + bytes[at + plane * count + i];
    numbers.push(number);
  }
  return numbers;
};
// The channels of shared-exponent texels in steps of the texel's own last bit, which both pictures are written with.
const steps = (a, b) => {
  const unit = 2 ** (Math.max(a >>> 27, b >>> 27) - 24);
  return Math.max(...[0, 9, 18].map((shift) => {
    const [x, y] = [a, b].map((word) => (word >>> shift & 511) * 2 ** ((word >>> 27) - 24));
    return Math.abs(x - y) / unit;
  }));
};
const floatOf = (word) => new Float32Array(Uint32Array.of(word).buffer)[0];

for (const name of process.argv.slice(2)) {
  const page = tablesOf(name + '.html'), from = {'probe.pfm': 'angular', 'fisheye.pfm': 'fisheye'}[name] ?? '';
  const {light, refused, stages} = await answer(page, name, readFileSync(name));
  expect(refused === undefined, `${name}: refused: ${refused}`);
  if (!light) continue;
  expect(stages.length > 0 && light.name === name, `${name}: it is called ${light.name}`);
  expect(light.projection === (from || 'equirect'), `${name}: taken for ${light.projection}`);
  const exposures = [light, page.light].map(({exposure_ev: [at]}, i) => planes([light.bytes, page.bytes][i], at, 1, 4)[0]);
  expect(exposures[0] === exposures[1], `${name}: exposure ${exposures.map(floatOf)}`);
  expect(light.cut_off === page.light.cut_off, `${name}: cut off: ${light.cut_off}`);

  const plain = ({levels, ...rest}) => JSON.stringify({...rest, sizes: levels.map(([, ...size]) => size)});
  expect(light.textures.map(plain).join() === page.light.textures.map(plain).join(), `${name}: other textures`);
  let texels = 0, differ = 0, worst = 0, worstHalf = 0;
  light.textures.forEach((texture, i) => texture.levels.forEach(([at, width, height], level) => {
    const [atOfPage] = page.light.textures[i].levels[level], count = texture.table ? 3 * width * height : width * height;
    const [ours, theirs] = [[light.bytes, at], [page.bytes, atOfPage]].map(([bytes, place]) => planes(bytes, place, count, texture.table ? 2 : 4));
    texels += count;
    ours.forEach((value, k) => {
      if (value === theirs[k]) return;
      ++differ;
      if (texture.table) worstHalf = Math.max(worstHalf, Math.abs(value - theirs[k]));
      else worst = Math.max(worst, steps(value, theirs[k]));
    });
  }));
  let floats = 0, worstFloat = 0;
  expect(light.uniforms.map((u) => u.name).join() === page.light.uniforms.map((u) => u.name).join(), `${name}: other uniforms`);
  light.uniforms.forEach(({name: uniform, floats: [at, count]}, i) => {
    const [atOfPage, countOfPage] = page.light.uniforms[i].floats;
    expect(count === countOfPage, `${name}: ${uniform} has ${count} numbers`);
    const ours = planes(light.bytes, at, count, 4).map(floatOf), theirs = planes(page.bytes, atOfPage, count, 4).map(floatOf);
    const size = Math.max(...theirs.map(Math.abs), 1e-30);
    floats += count;
    ours.forEach((value, k) => { worstFloat = Math.max(worstFloat, Math.abs(value - theirs[k]) / size); });
  });
  console.log(`${name}: ${texels} texels, ${differ} differ, at most by ${worst} steps of their last bit (tables: ${worstHalf}); ` +
              `${floats} numbers, at most ${worstFloat.toExponential(1)} apart`);
  // Sines and powers of two C libraries differ in their last bit: the texel may fall on the other side of a step, and the search
  // for lights ends where the residual cannot tell directions apart, some 1e-7 from the other.
  expect(texels > 400000 && differ < 1e-4 * texels && worst <= 1 && worstHalf <= 1, `${name}: ${differ} of ${texels} texels differ`);
  expect(floats > 200 && worstFloat < 1e-5, `${name}: numbers are ${worstFloat} apart`);
}

// Refusals say what to do.
const page = tablesOf(process.argv[2] + '.html'), sky = readFileSync(process.argv[2]);
console.log(`a page of ${page.size} bytes, of them ${page.module.length} the module`);
expect(readFileSync(process.argv[2] + '.html', 'utf8').split('Syoyo Fujita and many contributors').length === 2, 'no notices of its parts');
expect(page.size < 3e6, `the page has ${page.size} bytes`);
const pfm = (width, height, values) => Buffer.concat([Buffer.from(`PF\n${width} ${height}\n-1.0\n`), Buffer.from(Float32Array.from(values).buffer)]);
const grey = new Array(3 * 64 * 32).fill(0.5), bad = [...grey];
bad[10] = NaN;
bad[100] = Infinity;
for (const [what, name, bytes, options, words] of [
       ['cut short', 'short.hdr', sky.subarray(0, 5000), {}, /short\.hdr.*ends early/],
       ['no picture', 'words.txt', Buffer.from('no picture at all, but words'), {}, /not a picture|cannot be read/],
       ['empty', 'empty.hdr', Buffer.alloc(0), {}, /the file is empty/],
       ['OpenEXR without a header', 'sky.exr', Buffer.from([0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0]), {}, /sky\.exr.*ends early/],
       ['not finite', 'bad.pfm', pfm(64, 32, bad), {}, /2 texels are not finite \(1 NaN, 1 infinite\)/],
       ['of no known shape', 'odd.pfm', pfm(30, 32, grey.slice(0, 3 * 30 * 32)), {}, /neither its shape, 30x32/],
       ['no cross', 'grey.pfm', pfm(64, 32, grey), {from: 'cube-cross'}, /cannot be cube-cross/],
       ['too large to be true', 'huge.pfm', Buffer.from('PF\n60000 30000\n-1.0\n'), {}, /ends early|not enough memory/]]) {
  const {refused, hint, light} = await answer(page, name, bytes, options);
  expect(light === undefined && words.test(refused), `${what}: it says “${refused}”`);
  expect(typeof hint === 'string' && !/--from|--fix/.test(hint), `${what}: the hint is “${hint}”`);
}
// Nothing of a broken OpenEXR gets past the run that reads it: each has an answer. The sound one is refused for its shape alone.
const nine = readFileSync('nine.exr');
let seed = 5;
const kinds = new Set(), kBroken = 120;
const random = (below) => { seed = (seed * 16807) % 2147483647; return seed % below; };
for (let i = 0; i < kBroken; ++i) {
  const bytes = Buffer.from(i % 4 ? nine : nine.subarray(0, random(nine.length)));
  if (i % 4 && i > 1) bytes[random(i % 4 === 1 ? bytes.length : 400)] = random(256);
  const {refused, hint, light} = await answer(page, 'nine.exr', bytes);
  expect(light === undefined && refused.startsWith('nine.exr: ') && hint !== undefined, `broken ${i}: it says “${refused}”, “${hint}”`);
  kinds.add(refused);
}
console.log(`${kBroken} broken files, ${kinds.size} answers`);
expect(kinds.has('nine.exr: neither its shape, 9x9, nor its name says how it shows the sphere') && kinds.size >= 5, [...kinds].join('; '));
const {light: repaired} = await answer(page, 'bad.pfm', pfm(64, 32, bad), {fix: true});
expect(repaired?.notes.some((note) => note.startsWith('2 texels were not finite')), `repaired: ${JSON.stringify(repaired?.notes)}`);

for (const failure of failures) console.log('failed: ' + failure);
console.log(`${checks - failures.length} checks passed, ${failures.length} failed`);
process.exit(failures.length === 0 && checks >= 60 ? 0 : 1);
