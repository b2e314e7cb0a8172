// shots.mjs CHROMIUM STATE: photographs the pages of this folder as the docs show them, into pictures/.
import {chromium} from 'playwright-core';
import {pathToFileURL} from 'node:url';

const [executablePath, state] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath,
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-background-networking',
         '--disable-component-update', '--disable-sync', '--no-first-run'],
});
const opened = async (file, width, height, scale = 1) => {
  const context = await browser.newContext({viewport: {width, height}, deviceScaleFactor: scale, colorScheme: 'light'});
  const page = await context.newPage();
  await page.goto(pathToFileURL(file).href, {waitUntil: 'load'});
  return page;
};

{
  const page = await opened('techniques.svg', 640, 600, 1.5);
  const [width, height] = await page.evaluate(() => document.documentElement.getAttribute('viewBox').split(' ').slice(2).map(Number));
  await page.setViewportSize({width, height});
  await page.screenshot({path: 'pictures/techniques.png'});
}
{
  const page = await opened('view.html', 1280, 760);
  await page.evaluate((hash) => { location.hash = hash; }, `${state}&technique=sh-bands&compare=3`);
  await page.waitForFunction(() => document.querySelector('.zv-number:not(.zv-stale) b'), undefined, {timeout: 120000});
  await page.screenshot({path: 'pictures/view-page.png'});
}
{  // The first pictures of a bake.
  const page = await opened('baked/index.html', 1000, 900), shown = ['Panorama', 'Prefiltered chain'];
  const [top, bottom] = await page.evaluate((names) => {
    const sections = [...document.querySelectorAll('section')];
    const named = sections.filter((section) => names.includes(section.querySelector('h2')?.textContent));
    for (const section of sections) section.style.display = named.includes(section) ? '' : 'none';
    return [named[0].getBoundingClientRect().top, named.at(-1).getBoundingClientRect().bottom].map((y) => y + scrollY);
  }, shown);
  await page.screenshot({path: 'pictures/bake.png', fullPage: true, clip: {x: 20, y: top, width: 960, height: bottom - top}});
}
await browser.close();
