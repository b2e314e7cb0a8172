// The numbers of the page: base 91 of zlib streams of arrays, each plane by plane, its lowest bytes first. The page's own
// come in two parts, so that the first picture need not wait for what other pictures are made of.

const textOf = (part) => {
  const element = document.getElementById('zonal-view-' + part);
  if (!element) throw new Error('this page ends too early: make or download it again');
  return element.textContent;
};

// The script comes before the numbers, so that the card can begin to work while the browser reads them.
const openingRead = new Promise((done) => addEventListener('zonal-view-opening', done));
const documentRead = new Promise((done) => document.addEventListener('DOMContentLoaded', done));

// Something was asked for that is on its way.
class NotYet extends Error {}

const joined = (parts) => {
  const bytes = new Uint8Array(parts.reduce((size, part) => size + part.length, 0));
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
};

// 13 bits in each pair of letters, the lower digit first; six in a last one alone.
const bytesOf = (letters) => {
  const digit = (i) => {
    const code = letters.charCodeAt(i);
    return code - 36 + (code < 64) + (code < 60) + (code < 34);
  };
  const pairs = letters.length >> 1, lone = letters.length & 1;
  const bytes = new Uint8Array((13 * pairs + 6 * lone) >> 3);
  let bits = 0, held = 0, at = 0;
  for (let i = 0; i < pairs + lone; ++i) {
    bits |= (digit(2 * i) + (i < pairs ? 91 * digit(2 * i + 1) : 0)) << held;
    held += i < pairs ? 13 : 6;
    for (; held >= 8; held -= 8, bits >>= 8) bytes[at++] = bits & 255;
  }
  return bytes;
};

const unpacked = async (text) => {
  if (typeof DecompressionStream === 'undefined') {
    throw new Error('this browser cannot unpack the data: it knows no DecompressionStream (browsers since 2023 do)');
  }
  const stream = new DecompressionStream('deflate'), writer = stream.writable.getWriter(), reader = stream.readable.getReader();
  const written = writer.write(bytesOf(text)).then(() => writer.close());
  const parts = [];
  for (let part = await reader.read(); !part.done; part = await reader.read()) parts.push(part.value);
  await written;
  return joined(parts);
};

// Numbers, or as many of them as are there.
class Bytes {
  constructor() {
    this.bytes = new Uint8Array(0);
    this.isWhole = false;
  }
  static whole(bytes) { return Object.assign(new Bytes(), {bytes, isWhole: true}); }

  add(more) { this.bytes = joined([this.bytes, more]); }

  // Throws NotYet.
  from(at, size) {
    if (at + size <= this.bytes.length) return this.bytes.subarray(at, at + size);
    throw this.isWhole ? new Error('the numbers of this page end too early: make it again') : new NotYet();
  }
}

const joinedPlanes = (bytes, at, count, width) => {
  const planes = bytes.from(at, count * width), numbers = new Uint8Array(count * width);
  for (let plane = 0; plane < width; ++plane) {
    for (let i = 0, from = plane * count; i < count; ++i) numbers[i * width + plane] = planes[from + i];
  }
  return numbers.buffer;
};
const shorts = (bytes, at, count) => new Uint16Array(joinedPlanes(bytes, at, count, 2));
const words = (bytes, at, count) => new Uint32Array(joinedPlanes(bytes, at, count, 4));
const floats = (bytes, at, count) => new Float32Array(joinedPlanes(bytes, at, count, 4));

// Each row of `width` numbers was stored as its difference from the row before.
const summedRows = (numbers, width) => {
  for (let i = width; i < numbers.length; ++i) numbers[i] += numbers[i - width];
  return numbers;
};
