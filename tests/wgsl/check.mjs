// check.mjs CHROMIUM CASES: compiles and runs every WGSL text of the cases in a browser and compares what comes out. Exit code 77
// where the browser has no WebGPU.
import {chromium} from 'playwright-core';
import {readFileSync, writeFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';

const [executablePath, cases_path] = process.argv.slice(2);
const cases = JSON.parse(readFileSync(cases_path, 'utf8'));

/// In the browser. Returns what each case drew or computed, and the messages of its modules.
async function run(cases) {
  const adapter = await navigator.gpu?.requestAdapter();
  if (!adapter) return {missing: 'no WebGPU adapter'};
  const device = await adapter.requestDevice();
  const errors = [];
  device.addEventListener('uncapturederror', event => errors.push(event.error.message));
  const module_of = async (code, messages) => {
    const module = device.createShaderModule({code});
    messages.push(...(await module.getCompilationInfo()).messages.map(m => `${m.type} ${m.lineNum}: ${m.message}`));
    return module;
  };
  const buffer_of = (floats, usage) => {
    const buffer = device.createBuffer({size: floats.length * 4, usage: usage | GPUBufferUsage.COPY_DST});
    device.queue.writeBuffer(buffer, 0, new Float32Array(floats));
    return buffer;
  };
  const count = cases.normals.length, bytes = count * 16;
  const result = () => device.createBuffer({size: bytes, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ});
  const floats_in = async buffer => {
    await buffer.mapAsync(GPUMapMode.READ);
    return [...new Float32Array(buffer.getMappedRange())];
  };
  const found = [];

  const normals = buffer_of(cases.normals.flatMap(n => [...n, 0]), GPUBufferUsage.STORAGE);
  for (const {code} of cases.functions) {
    const messages = [], module = await module_of(code, messages);
    const pipeline = device.createComputePipeline({layout: 'auto', compute: {module, entryPoint: 'main'}});
    const output = device.createBuffer({size: bytes, usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC}), read = result();
    const encoder = device.createCommandEncoder(), pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, device.createBindGroup({
      layout: pipeline.getBindGroupLayout(0),
      entries: [{binding: 0, resource: {buffer: normals}}, {binding: 1, resource: {buffer: output}}],
    }));
    pass.dispatchWorkgroups(count);
    pass.end();
    encoder.copyBufferToBuffer(output, 0, read, 0, bytes);
    device.queue.submit([encoder.finish()]);
    found.push({messages, values: await floats_in(read)});
  }

  // One point for each normal, in the middle of a pixel of its own; the normal's w must not matter.
  const points = buffer_of(cases.normals.flatMap(
    (n, i) => [i % cases.width + 0.5, Math.floor(i / cases.width) + 0.5, 0, 1, ...n, 5]), GPUBufferUsage.VERTEX);
  for (const {vertex, fragment, matrices, sh} of cases.programs) {
    const messages = [];
    const pipeline = device.createRenderPipeline({
      layout: 'auto',
      vertex: {module: await module_of(vertex, messages), entryPoint: 'main', buffers: [{arrayStride: 32, attributes: [
        {shaderLocation: 0, offset: 0, format: 'float32x4'}, {shaderLocation: 1, offset: 16, format: 'float32x4'}]}]},
      fragment: {module: await module_of(fragment, messages), entryPoint: 'main', targets: [{format: 'rgba32float'}]},
      primitive: {topology: 'point-list'},
    });
    const picture = device.createTexture({size: [cases.width, cases.height], format: 'rgba32float',
      usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC});
    const read = result(), encoder = device.createCommandEncoder();
    const pass = encoder.beginRenderPass({colorAttachments: [
      {view: picture.createView(), loadOp: 'clear', storeOp: 'store', clearValue: [-1e9, -1e9, -1e9, -1e9]}]});
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, device.createBindGroup({layout: pipeline.getBindGroupLayout(0), entries: [
      {binding: 0, resource: {buffer: buffer_of(matrices, GPUBufferUsage.UNIFORM)}},
      {binding: 1, resource: {buffer: buffer_of(sh, GPUBufferUsage.UNIFORM)}}]}));
    pass.setVertexBuffer(0, points);
    pass.draw(count);
    pass.end();
    encoder.copyTextureToBuffer({texture: picture}, {buffer: read, bytesPerRow: cases.width * 16}, [cases.width, cases.height]);
    device.queue.submit([encoder.finish()]);
    found.push({messages, values: await floats_in(read)});
  }

  // A compiler that accepts anything would prove nothing.
  const broken = [];
  device.pushErrorScope('validation');
  await module_of(cases.functions[0].code.replace('return ', 'return 1u + '), broken);
  await device.popErrorScope();
  return {found, broken, errors};
}

const browser = await chromium.launch({
  executablePath,
  args: ['--no-sandbox', '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run',
         '--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader', '--enable-features=Vulkan'],
});
let outcome;
try {
  const page = await browser.newPage();
  writeFileSync('empty.html', '<!doctype html><title>WGSL</title>');
  await page.goto(pathToFileURL('empty.html').href);  // WebGPU wants an origin that it trusts
  outcome = await page.evaluate(run, cases);
} finally {
  await browser.close();
}
if (outcome.missing) {
  console.log('skipped: ' + outcome.missing);
  process.exit(77);
}

const failures = [...outcome.errors];
if (!outcome.broken.some(m => m.startsWith('error'))) failures.push('a broken module was accepted');
let compared = 0;
[...cases.functions, ...cases.programs].forEach(({name, expected, allowed}, at) => {
  const {messages, values} = outcome.found[at];
  if (messages.length > 0) failures.push(`${name}: ${messages.join('; ')}`);
  expected.forEach((color, i) => [...color, 1].forEach((value, channel) => {
    ++compared;
    const got = values[4 * i + channel];
    if (!(Math.abs(got - value) <= allowed)) failures.push(`${name}: normal ${i}, channel ${channel}: ${got}, not ${value}`);
  }));
});
for (const failure of failures.slice(0, 20)) console.log('failed: ' + failure);
console.log(`${compared} values compared, ${failures.length} failures`);
process.exit(failures.length === 0 && compared === 20 * 64 * 4 ? 0 : 1);
