// node facts.mjs FILE.ktx2                 prints what ktx-parse finds in the file, as JSON
// node facts.mjs --expect FACTS.json ...   compares FACTS.ktx2 with FACTS.json for each; exits 1 when one differs
import * as ktx from 'ktx-parse';
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';

const nameOf = (prefix, value) =>
  Object.keys(ktx).find((key) => key.startsWith(prefix) && ktx[key] === value) ?? `${prefix}${value}`;

function halfToNumber(half) {
  const sign = half & 0x8000 ? -1 : 1, exponent = (half >> 10) & 31, fraction = half & 1023;
  if (exponent === 31) return fraction ? NaN : sign * Infinity;
  return exponent ? sign * (1 + fraction / 1024) * 2 ** (exponent - 15) : sign * fraction * 2 ** -24;
}

/// Values of keys that the specification does not define come as bytes, with the NUL that ends a text.
function textOf(value) {
  return typeof value === 'string' ? value : new TextDecoder('utf-8', { fatal: true }).decode(value).replace(/\0$/, '');
}

function texelAt(bytes, index, channels, bits) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  return Array.from({ length: channels }, (_, c) => {
    const at = ((index * channels + c) * bits) / 8;
    return bits === 16 ? halfToNumber(view.getUint16(at, true)) : view.getFloat32(at, true);
  });
}

function factsOf(file) {
  const texture = ktx.read(new Uint8Array(readFileSync(file)));
  const [descriptor] = texture.dataFormatDescriptor;
  const channels = descriptor.samples.length;
  const bits = descriptor.samples[0].bitLength + 1;
  const compressed = texture.supercompressionScheme !== ktx.KHR_SUPERCOMPRESSION_NONE;

  // What a loader relies on besides the facts below.
  assert.equal(texture.pixelDepth, 0);
  assert.equal(texture.layerCount, 0);
  assert.equal(texture.globalData, null);
  assert.equal(texture.levels.length, texture.levelCount);
  assert.equal(texture.typeSize, bits / 8);
  assert.equal(descriptor.vendorId, ktx.KHR_DF_VENDORID_KHRONOS);
  assert.equal(descriptor.descriptorType, ktx.KHR_DF_KHR_DESCRIPTORTYPE_BASICFORMAT);
  assert.equal(descriptor.versionNumber, ktx.KHR_DF_VERSION);
  assert.equal(descriptor.colorModel, ktx.KHR_DF_MODEL_RGBSDA);
  assert.equal(descriptor.colorPrimaries, ktx.KHR_DF_PRIMARIES_BT709);
  assert.equal(descriptor.transferFunction, ktx.KHR_DF_TRANSFER_LINEAR);
  assert.equal(descriptor.flags, ktx.KHR_DF_FLAG_ALPHA_STRAIGHT);
  assert.deepEqual(descriptor.texelBlockDimension, [0, 0, 0, 0]);
  assert.deepEqual(descriptor.bytesPlane, [(channels * bits) / 8, 0, 0, 0, 0, 0, 0, 0]);
  const channelNames = ['RED', 'GREEN', 'BLUE', 'ALPHA'];
  const [minusOne, one] = new Int32Array(new Float32Array([-1, 1]).buffer);
  descriptor.samples.forEach((sample, c) => {
    const type = ktx.KHR_DF_SAMPLE_DATATYPE_FLOAT | ktx.KHR_DF_SAMPLE_DATATYPE_SIGNED;
    assert.equal(sample.channelType, type | ktx[`KHR_DF_CHANNEL_RGBSDA_${channelNames[c]}`]);
    assert.equal(sample.bitOffset, c * bits);
    assert.equal(sample.bitLength, bits - 1);
    assert.deepEqual(sample.samplePosition, [0, 0, 0, 0]);
    assert.equal(sample.sampleLower, minusOne);
    assert.equal(sample.sampleUpper, one);
  });

  const levels = texture.levels.map((level, p) => {
    const width = Math.max(1, texture.pixelWidth >> p), height = Math.max(1, texture.pixelHeight >> p);
    const facts = { width, height, bytes: level.uncompressedByteLength };
    if (compressed) {
      assert.deepEqual([...level.levelData.slice(0, 4)], [0x28, 0xb5, 0x2f, 0xfd]);  // the magic number of a frame
      return facts;
    }
    assert.equal(level.levelData.byteLength, level.uncompressedByteLength);
    assert.equal(level.levelData.byteOffset % ((channels * bits) / 8), 0);
    facts.corners = [];
    for (let face = 0; face < texture.faceCount; ++face) {
      for (const index of [face * width * height, (face + 1) * width * height - 1]) {
        facts.corners.push(texelAt(level.levelData, index, channels, bits));
      }
    }
    return facts;
  });
  return {
    format: nameOf('VK_FORMAT_', texture.vkFormat),
    faces: texture.faceCount,
    supercompression: nameOf('KHR_SUPERCOMPRESSION_', texture.supercompressionScheme).split('_').pop().toLowerCase(),
    channels,
    channel_bits: bits,
    levels,
    keys: Object.fromEntries(Object.entries(texture.keyValue).map(([key, value]) => [key, textOf(value)])),
  };
}

const [mode, ...files] = process.argv.slice(2);
if (mode === '--expect') {
  assert.ok(files.length > 0, 'no files to compare');
  for (const file of files) {
    assert.deepEqual(factsOf(file.replace(/\.json$/, '.ktx2')), JSON.parse(readFileSync(file, 'utf8')), file);
  }
  console.log(`ktx-parse agrees on ${files.length} files`);
} else {
  console.log(JSON.stringify(factsOf(mode), null, 2));
}
