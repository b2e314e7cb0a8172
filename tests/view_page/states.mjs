// The states whose pictures the page and the desktop are compared in: "name size state" each, read by run.sh and check.mjs.
// Every technique there is, as the command lists them in the page itself.
import {readFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';

const html = readFileSync('page.html', 'utf8');
const open = '<script type="application/json" id="zonal-view-tables">', begin = html.indexOf(open) + open.length;
export const tables = JSON.parse(html.slice(begin, html.indexOf('</script>', begin)));
export const size = [320, 240];
// Where a technique can turn the coefficients themselves, each home does so in its own way.
const own = (id, moves) => (moves ? '&light_set=3' : '') + (id === 'sh-bands' ? '&turn_by=1&bands=6' : '');
export const states = tables.techniques.map(({id, moves}, i) => {
  const mesh = tables.meshes[i % tables.meshes.length].name;
  return {name: id, text: `technique=${id}&mesh=${mesh}&yaw=${(40 * i + 25) % 360}&pitch=${(17 * i) % 60 - 20}&light_yaw_deg=${15 * i % 90}&light_pitch_deg=${(23 * i) % 90 - 45}&light_roll_deg=${(50 * i) % 360 - 180}${own(id, moves)}`};
});

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  for (const {name, text} of states) console.log(`${name} ${size.join('x')} ${text}`);
}
