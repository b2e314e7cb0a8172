// The numbers of the page: base64 of a zlib stream of arrays, each plane by plane, its lowest bytes first.

const unpacked = async (text) => {
  if (typeof DecompressionStream === 'undefined') {
    throw new Error('this browser cannot unpack the data: it knows no DecompressionStream (browsers since 2023 do)');
  }
  const letters = atob(text), packed = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) packed[i] = letters.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
};

const joinedPlanes = (bytes, at, count, width) => {
  const numbers = new Uint8Array(count * width);
  for (let plane = 0; plane < width; ++plane) {
    for (let i = 0, from = at + plane * count; i < count; ++i) numbers[i * width + plane] = bytes[from + i];
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
