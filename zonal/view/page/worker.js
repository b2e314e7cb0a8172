'use strict';
// Makes the light of one picture, with the library itself. Runs in a worker of its own that does nothing else: the page
// stays alive meanwhile, and ends the worker to cancel. Nothing of one picture is left for the next.

class Refusal extends Error {
  constructor(message, hint) {
    super(message);
    this.hint = hint;
  }
}

const beginsWith = (bytes, at, text) => [...text].every((c, i) => bytes[at + i] === c.charCodeAt(0));
const isPng = (bytes) => beginsWith(bytes, 0, '\x89PNG\r\n\x1a\n');
const isJpeg = (bytes) => beginsWith(bytes, 0, '\xff\xd8\xff');
const isWebp = (bytes) => beginsWith(bytes, 0, 'RIFF') && beginsWith(bytes, 8, 'WEBP');

// Pixels are taken as they are stored, as the library does: without the segments that may turn them (EXIF).
const withoutExif = (bytes) => {
  const parts = [bytes.subarray(0, 2)];
  let at = 2;
  while (at + 4 <= bytes.length && bytes[at] === 0xff && bytes[at + 1] !== 0xda) {
    const end = at + 2 + (bytes[at + 2] << 8 | bytes[at + 3]);
    if (bytes[at + 1] !== 0xe1) parts.push(bytes.subarray(at, end));
    at = end;
  }
  return [...parts, bytes.subarray(at)];
};

// What a PNG says about its numbers before the pixels begin: {wide: 16 bits, linear}.
const pngFacts = (bytes) => {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let linear = false, srgb = false;
  for (let at = 8; at + 12 <= bytes.length && !beginsWith(bytes, at + 4, 'IDAT'); at += 12 + view.getUint32(at)) {
    if (beginsWith(bytes, at + 4, 'gAMA')) linear = view.getUint32(at + 8) === 100000;
    if (beginsWith(bytes, at + 4, 'sRGB')) srgb = true;
  }
  return {wide: bytes[24] === 16, linear: linear && !srgb};
};

const bitmapOf = async (bytes, name) => {
  const blob = new Blob(isJpeg(bytes) ? withoutExif(bytes) : [bytes]);
  try {
    return await createImageBitmap(blob, {colorSpaceConversion: 'none', premultiplyAlpha: 'none'});
  } catch (error) {
    throw new Refusal(`${name}: this browser cannot decode the picture (${error.message})`, 'copy or download it again');
  }
};

// Red, green, blue and alpha of all pixels, a strip at a time: a whole canvas may be larger than a browser allows.
const copyPixels = (bitmap, target) => {
  const {width, height} = bitmap, rows = Math.min(height, 256);
  const context = new OffscreenCanvas(width, rows).getContext('2d', {willReadFrequently: true});
  context.globalCompositeOperation = 'copy';
  for (let y = 0; y < height; y += rows) {
    context.drawImage(bitmap, 0, -y);
    const strip = context.getImageData(0, 0, width, Math.min(rows, height - y)).data;
    target.set(strip, 4 * width * y);
  }
};

const lightOf = async ({module, file, name, from, fix}) => {
  let memory, light, told = 0;
  const text = (at, length) => new TextDecoder().decode(new Uint8Array(memory.buffer, at >>> 0, length));
  const page = {
    fail: (message, messageLength, hint, hintLength) => {
      throw new Refusal(text(message, messageLength), text(hint, hintLength));
    },
    progress: (stage, length, fraction) => {
      if (performance.now() < told + 50) return;
      told = performance.now();
      postMessage({stage: text(stage, length), fraction});
    },
    give: (json, jsonLength, bytes, count) => {
      light = {...JSON.parse(text(json, jsonLength)), bytes: new Uint8Array(memory.buffer, bytes >>> 0, count).slice()};
    },
  };
  const system = new Proxy({}, {get: (_, call) => () => { throw new Error(`the library asks the system for ${call}`); }});
  const {instance: {exports}} = await WebAssembly.instantiate(module, {page, wasi_snapshot_preview1: system});
  memory = exports.memory;
  exports._initialize();
  const room = (size) => {
    const at = exports.allocate(size) >>> 0;
    return [at, new Uint8Array(memory.buffer, at, size)];
  };
  const put = (bytes) => {
    const [at, target] = room(bytes.length);
    target.set(bytes);
    return [at, bytes.length];
  };
  const words = [...put(new TextEncoder().encode(name)), ...put(new TextEncoder().encode(from)), fix ? 1 : 0];
  const bytes = new Uint8Array(file);
  if (!isPng(bytes) && !isJpeg(bytes) && !isWebp(bytes)) {
    try {
      exports.show_file(...words, ...put(bytes));
    } catch (error) {
      if (error instanceof Refusal) throw error;
      throw new Refusal(`${name}: the library stopped while it read this (${error.message})`,
                        'most likely the file is broken; if other programs open it, please report it');
    }
    return light;
  }
  const facts = isPng(bytes) ? pngFacts(bytes) : {wide: false, linear: false};
  const bitmap = await bitmapOf(bytes, name), [at, target] = room(4 * bitmap.width * bitmap.height);
  copyPixels(bitmap, target);
  exports.show_pixels(...words, at, bitmap.width, bitmap.height, facts.linear ? 1 : 0);
  if (facts.wide) light.notes.push('a browser gives 8 of its 16 bits');
  return light;
};

onmessage = async ({data}) => {
  try {
    const light = await lightOf(data);
    postMessage({light}, [light.bytes.buffer]);
  } catch (error) {
    if (error instanceof Refusal) postMessage({refused: error.message, hint: error.hint});
    else postMessage({refused: `${data.name}: ${error.message ?? error}`, hint: 'this is an error of the page: please report it'});
  }
};
