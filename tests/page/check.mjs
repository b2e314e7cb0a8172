// check.mjs CHROMIUM PAGE: opens a baked page from the file system as a person would, on a desktop and on a phone, light and dark.
import {chromium} from 'playwright-core';
import {pathToFileURL} from 'node:url';

const [executablePath, page_path] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath,
  // The page's viewer draws with WebGL, here on the processor.
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-background-networking', '--disable-component-update',
         '--disable-sync', '--no-first-run'],
});
const failures = [];
let checks = 0;
const expect = (ok, what) => { ++checks; if (!ok) failures.push(what); };

for (const [name, width, height] of [['desktop', 1280, 900], ['tablet', 768, 1024], ['phone', 390, 844], ['small phone', 320, 640]]) {
  for (const colorScheme of ['light', 'dark']) {
    const where = `${name}, ${colorScheme}`;
    const context = await browser.newContext({viewport: {width, height}, colorScheme});
    const page = await context.newPage();
    const messages = [], requests = [];
    page.on('console', message => messages.push(message.text()));
    page.on('pageerror', error => messages.push(String(error)));
    page.on('request', request => requests.push(request.url()));
    await page.goto(pathToFileURL(page_path).href, {waitUntil: 'load'});
    const facts = await page.evaluate(() => ({
      title: document.title,
      overflow: document.scrollingElement.scrollWidth - document.documentElement.clientWidth,
      images: [...document.images].map(i => ({done: i.complete && i.naturalWidth > 0, alt: i.alt, wide: i.getBoundingClientRect().right})),
      sections: document.querySelectorAll('section').length,
      headings: document.querySelectorAll('h1').length,
    }));
    expect(facts.overflow <= 0, `${where}: the page is ${facts.overflow} pixels too wide`);
    expect(facts.images.length >= 20, `${where}: only ${facts.images.length} pictures`);
    expect(facts.images.every(i => i.done), `${where}: a picture did not load`);
    expect(facts.images.every(i => i.alt !== ''), `${where}: a picture has no description`);
    expect(facts.sections >= 10 && facts.headings === 1, `${where}: ${facts.sections} sections, ${facts.headings} titles`);
    expect(facts.title.length > 0, `${where}: no title`);
    expect(messages.length === 0, `${where}: the browser says: ${messages.join('; ')}`);
    const outside = requests.filter(url => !url.startsWith('file:') && !url.startsWith('data:'));
    expect(outside.length === 0, `${where}: it asks the network for ${outside.join(', ')}`);
    await context.close();
  }
}
await browser.close();
for (const failure of failures) console.log('failed: ' + failure);
console.log(`${checks - failures.length} checks passed, ${failures.length} failed`);
process.exit(failures.length === 0 && checks >= 64 ? 0 : 1);
