// The worker of a page, run by node: the very text and the very module that the page carries.
import {readFileSync} from 'node:fs';
import vm from 'node:vm';
import {inflateSync} from 'node:zlib';

const unpacked = (text) => new Uint8Array(inflateSync(Buffer.from(text, 'base64')));

// What the script of the page reads.
export const tablesOf = (path) => {
  const html = readFileSync(path, 'utf8'), open = '<script type="application/json" id="zonal-view-data">';
  const begin = html.indexOf(open) + open.length, data = JSON.parse(html.slice(begin, html.indexOf('</script>', begin)));
  return {...data, bytes: unpacked(data.bytes), size: html.length};
};

// What the worker says at the end: {light} or {refused, hint}; `stages` is what it said before.
export const answer = ({chooser}, name, file, {from = '', fix = false} = {}) => new Promise((done) => {
  const stages = [];
  const scope = {WebAssembly, TextDecoder, TextEncoder, performance, Blob, postMessage: (message) => {
    if (message.stage === undefined) done({...message, stages});
    else stages.push(message);
  }};
  vm.runInNewContext(chooser.worker, scope);
  scope.onmessage({data: {module: unpacked(chooser.module), file: Uint8Array.from(file).buffer, name, from, fix}});
});
