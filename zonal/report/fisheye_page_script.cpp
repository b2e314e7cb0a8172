#include "zonal/report/fisheye_page_script.h"

namespace zonal {

// The preview sums over a grid of kGrid x kGrid points of the circle's square, for maps of as many pixels.
std::string_view fisheye_page_script() {
  return R"js(
(function () {
  'use strict';
  const kGrid = 41, kTable = 1024;
  const tool = document.getElementById('circle-tool');
  const facts = tool.dataset;
  const photo = document.getElementById('circle-photo');
  const overlay = document.getElementById('circle-overlay');
  const ring = document.getElementById('circle-ring');
  const heart = document.getElementById('circle-heart');
  const command = document.getElementById('circle-command');
  const inputs = {};
  for (const name of ['x', 'y', 'radius', 'shininess', 'ground']) inputs[name] = document.getElementById('circle-' + name);
  const maps = {
    published: document.getElementById('preview-published'),
    corrected: document.getElementById('preview-corrected'),
  };
  const isCodes = facts.codes === 'yes';
  const width = Number(facts.width), height = Number(facts.height);

  // Values 0..255 of the picture to what is averaged, and back.
  const decode = code => {
    const c = code / 255;
    if (isCodes) return c;
    return c <= 0.04045 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4);
  };
  const encode = value => {
    const v = Math.min(Math.max(value, 0), 1);
    if (isCodes) return Math.round(255 * v);
    return Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * Math.pow(v, 1 / 2.4) - 0.055));
  };

  let pixels = null;
  function readPhoto() {
    const copy = document.createElement('canvas');
    copy.width = photo.naturalWidth;
    copy.height = photo.naturalHeight;
    const context = copy.getContext('2d', {willReadFrequently: true});
    context.drawImage(photo, 0, 0);
    pixels = context.getImageData(0, 0, copy.width, copy.height);
  }
  // Row y and column x of the photograph in its own pixels; null outside of it.
  function valueAt(x, y) {
    const i = Math.floor(x * pixels.width / width), j = Math.floor(y * pixels.height / height);
    if (!(i >= 0 && j >= 0 && i < pixels.width && j < pixels.height)) return null;
    const k = 4 * (j * pixels.width + i);
    return [decode(pixels.data[k]), decode(pixels.data[k + 1]), decode(pixels.data[k + 2])];
  }

  // The grid's points in the square around the circle, and the pixels of a paraboloid map: these never change.
  const points = [], targets = [];
  for (let j = 0; j < kGrid; ++j) {
    for (let i = 0; i < kGrid; ++i) {
      const s = 2 * (i + 0.5) / kGrid - 1, t = 1 - 2 * (j + 0.5) / kGrid;
      const r = Math.hypot(s, t), angle = r * Math.PI / 2, side = r > 0 ? Math.sin(angle) / r : 0;
      points.push({s, t, sky: r < 1, x: s * side, y: t * side, z: Math.cos(angle),
                   solid: (angle > 0 ? Math.sin(angle) / angle : 1) * Math.pow(Math.PI / kGrid, 2)});
      const u = s / 2, v = t / 2, m = u * u + v * v, a = 0.25 + m;
      targets.push({x: u / a, y: v / a, z: (0.25 - m) / a});
    }
  }

  // cos^s, and that times sin(a)/a, as tables over the cosine.
  let tabled = null, powers = new Float64Array(kTable + 2), published = new Float64Array(kTable + 2);
  function fillTables(shininess) {
    if (tabled === shininess) return;
    tabled = shininess;
    for (let i = 0; i <= kTable + 1; ++i) {
      const c = Math.min(i / kTable, 1), a = Math.acos(c);
      powers[i] = Math.pow(c, shininess);
      published[i] = powers[i] * (a > 0 ? Math.sin(a) / a : 1);
    }
  }

  function settings() {
    const read = (input, low, high, fallback) => {
      const value = Number(input.value);
      return input.value !== '' && Number.isFinite(value) ? Math.min(Math.max(value, low), high) : fallback;
    };
    const ground = [1, 3, 5].map(i => decode(parseInt(inputs.ground.value.slice(i, i + 2), 16)));
    return {x: read(inputs.x, 0, width, width / 2), y: read(inputs.y, 0, height, height / 2),
            radius: read(inputs.radius, 1, Math.max(width, height), Math.min(width, height) / 2),
            shininess: read(inputs.shininess, 1, 100, 1), ground};
  }

  function drawPreviews(now) {
    fillTables(now.shininess);
    const colors = points.map(p => (p.sky && valueAt(now.x + p.s * now.radius, now.y - p.t * now.radius)) || now.ground);
    const scale = (now.shininess + 1) / (2 * Math.PI);
    const images = {};
    for (const name in maps) images[name] = maps[name].getContext('2d').createImageData(kGrid, kGrid);
    const put = (image, k, r, g, b) => { image.data.set([encode(r), encode(g), encode(b), 255], 4 * k); };
    targets.forEach((q, k) => {
      if (!(q.z > 0)) {
        for (const name in images) put(images[name], k, ...now.ground);
        return;
      }
      let w = 0, r = 0, g = 0, b = 0, share = 0, cr = 0, cg = 0, cb = 0;
      for (let i = 0; i < points.length; ++i) {
        const p = points[i], c = p.x * q.x + p.y * q.y + p.z * q.z;
        if (!(c > 0)) continue;
        const place = Math.min(c, 1) * kTable, cell = Math.floor(place), part = place - cell;
        const color = colors[i], as = published[cell] + part * (published[cell + 1] - published[cell]);
        w += as; r += as * color[0]; g += as * color[1]; b += as * color[2];
        if (!p.sky) continue;
        const is = scale * p.solid * (powers[cell] + part * (powers[cell + 1] - powers[cell]));
        share += is; cr += is * color[0]; cg += is * color[1]; cb += is * color[2];
      }
      put(images.published, k, r / w, g / w, b / w);
      // The grid is coarse: its sum may be a little over the whole.
      const rest = Math.max(0, 1 - share), all = share + rest;
      put(images.corrected, k, (cr + rest * now.ground[0]) / all, (cg + rest * now.ground[1]) / all,
          (cb + rest * now.ground[2]) / all);
    });
    for (const name in maps) maps[name].getContext('2d').putImageData(images[name], 0, 0);
  }

  const short = (value, digits) => String(Number(value.toFixed(digits)));
  // For a shell: in single quotes where a name asks for it.
  const quoted = word => /^[\w.\/+-]+$/.test(word) ? word : "'" + word.replace(/'/g, "'\\''") + "'";
  function writeCommand(now) {
    command.textContent = 'zonal fisheye ' + quoted(facts.name) + ' --center ' + short(now.x, 1) + ',' + short(now.y, 1) +
      ' --radius ' + short(now.radius, 1) + ' --ground ' + now.ground.map(v => short(v, 4)).join(',') + ' --shininess ' +
      short(now.shininess, 1) + ' ' + facts.kept + ' --outside ' + facts.outside + ' -o maps';
  }

  function drawCircle(now) {
    for (const [part, radius] of [[ring, now.radius], [heart, Math.max(width, height) / 90]]) {
      part.setAttribute('cx', now.x);
      part.setAttribute('cy', now.y);
      part.setAttribute('r', radius);
    }
  }

  let asked = false;
  function refresh() {
    const now = settings();
    drawCircle(now);
    writeCommand(now);
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      if (pixels) drawPreviews(settings());
    });
  }

  function change(values) {
    for (const name in values) inputs[name].value = short(values[name], 1);
    refresh();
  }

  // A drag near the ring changes the radius, any other moves the circle.
  let drag = null;
  function place(event) {
    const box = overlay.getBoundingClientRect();
    return {x: (event.clientX - box.left) * width / box.width, y: (event.clientY - box.top) * height / box.height};
  }
  overlay.addEventListener('pointerdown', event => {
    const now = settings(), at = place(event), distance = Math.hypot(at.x - now.x, at.y - now.y);
    drag = {resizes: Math.abs(distance - now.radius) < 0.15 * now.radius, dx: now.x - at.x, dy: now.y - at.y,
            more: now.radius - distance};
    overlay.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  overlay.addEventListener('pointermove', event => {
    if (!drag) return;
    const now = settings(), at = place(event);
    if (drag.resizes) {
      change({radius: Math.max(1, Math.hypot(at.x - now.x, at.y - now.y) + drag.more)});
    } else {
      change({x: Math.min(Math.max(at.x + drag.dx, 0), width), y: Math.min(Math.max(at.y + drag.dy, 0), height)});
    }
  });
  for (const end of ['pointerup', 'pointercancel']) overlay.addEventListener(end, () => { drag = null; });

  for (const name in inputs) inputs[name].addEventListener('input', refresh);
  const ready = () => { readPhoto(); refresh(); };
  if (photo.complete && photo.naturalWidth > 0) ready(); else photo.addEventListener('load', ready);
  tool.hidden = false;
})();
)js";
}

}  // namespace zonal
