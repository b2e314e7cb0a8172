// A page under watch, and pictures of it.

// {page, drawn(), go(), pictures(), difference(), setSize(), close()}; what the browser complains about or asks the network for is a failure.
export const newPage = async (browser, viewport, expect, where, colorScheme = 'light') => {
  const context = await browser.newContext({viewport, colorScheme});
  const page = await context.newPage();
  const complaints = [], outside = [];
  page.on('console', (message) => complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('request', (request) => { if (!/^(file|data|blob):/.test(request.url())) outside.push(request.url()); });
  // Counts the pictures that were drawn: the background is the last triangle of each.
  await page.addInitScript(() => {
    globalThis.pictures = 0;
    const original = WebGL2RenderingContext.prototype.drawArrays;
    WebGL2RenderingContext.prototype.drawArrays = function(...how) { original.apply(this, how); ++globalThis.pictures; };
  });
  // A picture at rest: with smooth edges, and measured.
  const settled = () => page.evaluate(async () => {
    const atRest = () => globalThis.pictures > 0 && document.querySelector('.zv-picture canvas')?.ariaBusy === 'false';
    const begin = performance.now();
    do {
      for (let i = 0; i < 3; ++i) await new Promise(requestAnimationFrame);  // what was asked for just now has begun
    } while (!atRest() && performance.now() < begin + 60000);
  });
  return {
    page,
    drawn: settled,
    // To other settings, as if somebody changed the address.
    go: async (text) => {
      await page.evaluate((hash) => new Promise((done) => {
        if (location.hash === '#' + hash) { done(); return; }
        addEventListener('hashchange', () => done(), {once: true});
        location.hash = hash;
      }), text);
      await settled();
    },
    pictures: () => page.evaluate(() => globalThis.pictures),
    difference: async () => {
      await page.waitForFunction(() => document.querySelector('.zv-number:not(.zv-stale)')?.textContent, undefined, {timeout: 60000});
      return page.textContent('.zv-number');
    },
    // The picture alone, in CSS pixels, which are the canvas's own here.
    setSize: async (width, height) => {
      await page.addStyleTag({content: `.zv-picture { flex: none !important; width: ${width}px; height: ${height}px; }
        .zv-picture canvas { width: ${width}px !important; height: ${height}px !important; }`});
      await page.waitForFunction(([w, h]) => {
        const canvas = document.querySelector('canvas');
        return canvas.width === w && canvas.height === h;
      }, [width, height]);
      await settled();
    },
    close: async () => {
      expect(complaints.length === 0, `${where}: the browser says: ${complaints.join('; ')}`);
      expect(outside.length === 0, `${where}: it asks the network for ${outside.join(', ')}`);
      await context.close();
    },
  };
};

// What the canvas shows, at rest unless told otherwise: {url, colors}.
export const pixels = async ({page, drawn}, atRest = true) => {
  if (atRest) await drawn();
  const png = await page.locator('.zv-picture canvas').screenshot();
  const url = 'data:image/png;base64,' + png.toString('base64');
  return {url, colors: await page.evaluate(countColors, url)};
};

const countColors = async (url) => {
  const image = new Image();
  image.src = url;
  await image.decode();
  const context = Object.assign(document.createElement('canvas'), {width: image.width, height: image.height}).getContext('2d');
  context.drawImage(image, 0, 0);
  return new Set(new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer)).size;
};

// Mean and largest absolute difference of two pictures of one size, in 255ths, and the share of pixels that differ.
export const compare = (page, first, second) => page.evaluate(async (urls) => {
  const [a, b] = await Promise.all(urls.map(async (url) => {
    const image = new Image();
    image.src = url;
    await image.decode();
    const context = Object.assign(document.createElement('canvas'), {width: image.width, height: image.height}).getContext('2d');
    context.drawImage(image, 0, 0);
    return {data: context.getImageData(0, 0, image.width, image.height).data, size: `${image.width}x${image.height}`};
  }));
  if (a.size !== b.size) throw new Error(`pictures of ${a.size} and of ${b.size}`);
  let sum = 0, most = 0;
  for (let i = 0; i < a.data.length; ++i) {
    const difference = i % 4 === 3 ? 0 : Math.abs(a.data[i] - b.data[i]);
    sum += difference;
    most = Math.max(most, difference);
  }
  return {mean: sum / (a.data.length / 4 * 3), most};
}, [first, second]);
