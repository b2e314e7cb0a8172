// The worker of a page, run by node: the very text and the very module that the page carries.
import {readFileSync} from 'node:fs';
import vm from 'node:vm';
import {inflateSync} from 'node:zlib';

const digits = '!#$%&\'()*+,-./0123456789:;=>?ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_`abcdefghijklmnopqrstuvwxyz{|}~';
const digitOf = Object.fromEntries([...digits].map((letter, digit) => [letter, digit]));
// Base 91: 13 bits in a pair of letters, six in a last one alone.
const bytesOf = (text) => {
  const bytes = [];
  let bits = 0, held = 0;
  for (let i = 0; i < text.length; i += 2) {
    bits += (digitOf[text[i]] + 91 * (digitOf[text[i + 1]] ?? 0)) * 2 ** held;
    for (held += i + 1 < text.length ? 13 : 6; held >= 8; held -= 8) {
      bytes.push(bits % 256);
      bits = Math.floor(bits / 256);
    }
  }
  return Buffer.from(bytes);
};
const unpacked = (text) => new Uint8Array(inflateSync(bytesOf(text)));

// What the script of the page reads: its tables, with `bytes` and `module`.
export const tablesOf = (path) => {
  const html = readFileSync(path, 'utf8');
  const part = (name) => {
    const open = `id="zonal-view-${name}">`, begin = html.indexOf(open) + open.length;
    return html.slice(begin, html.indexOf('</script>', begin));
  };
  const bytes = Buffer.concat(['opening', 'rest'].map((name) => unpacked(part(name))));
  return {...JSON.parse(part('tables')), bytes, module: part('module'), size: html.length};
};

// What the worker says at the end: {light} or {refused, hint}; `stages` is what it said before.
export const answer = ({chooser, module}, name, file, {from = '', fix = false} = {}) => new Promise((done) => {
  const stages = [];
  const scope = {WebAssembly, TextDecoder, TextEncoder, performance, Blob, postMessage: (message) => {
    if (message.stage === undefined) done({...message, stages});
    else stages.push(message);
  }};
  vm.runInNewContext(chooser.worker, scope);
  scope.onmessage({data: {module: unpacked(module), file: Uint8Array.from(file).buffer, name, from, fix}});
});
