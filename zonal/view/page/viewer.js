// The page: settings -> picture. Something is drawn only when something changed.

const view = async (root, data) => {
  root.classList.toggle('zv-embedded', data.embedded);
  const settings = new Settings(data), pace = new Pace();
  let scene, measure, waiting = 0, idle = 0, tick = 0, busy = false, again = false, refining = false, missing = false;

  const later = (what) => { clearTimeout(idle); idle = setTimeout(what, 250); };
  const request = () => { if (scene?.light && !waiting) waiting = requestAnimationFrame(draw); };
  const update = () => {
    clearTimeout(idle);
    refining = false;
    panel.show();
    request();
  };
  const changed = (name, value) => {
    if (name === undefined) settings.reset();
    else settings.set(name, value);
    update();
  };
  const ownHighlight = 'highlight_own';
  let hasPainted = false;
  const painted = () => {
    hasPainted = true;
    scene.textures.replace(ownHighlight, panel.painter.picture);
    update();
  };
  const chooser = data.chooser && new LightChooser(data.chooser, root, {
    show: (light) => showLight(light),
    notice: (kind, words) => panel.notice(kind, words),
  });
  const panel = new Panel(root, data, settings, changed, painted, chooser?.element), canvas = panel.canvas;

  const readAddress = (hash) => {
    if (data.embedded) return;
    settings.reset();
    const problems = settings.read(hash.slice(1));
    panel.notice('address', problems.length === 0 ? '' : 'In the address of this page:\n' + problems.join('\n'));
  };
  const writeAddress = () => {
    const address = '#' + settings.text();
    if (!data.embedded && location.hash !== address) history.replaceState(null, '', address);
  };

  const gl = canvas.getContext('webgl2', {antialias: false, powerPreference: 'high-performance'});
  const failed = (error) => {
    if (error instanceof NotYet) missing = true;
    else if (!(error instanceof LostContext)) panel.notice('picture', String(error.message ?? error));
  };
  // When nothing has changed for a while: edges are smoothed and the difference is measured.
  const rest = async () => {
    writeAddress();
    if (gl.isContextLost()) return;
    if (panel.coarse.hidden) drawPicture(true);
    measure ??= new Measure(gl);
    try {
      const rms = await measure.difference(scene, settings.values, panel.technique.slow);
      if (rms === undefined) return;
      panel.difference(rms);
    } catch (error) {
      failed(error);
    }
    canvas.ariaBusy = String(missing);
  };
  const drawPicture = (smooth) => {
    try {
      if (!scene.draw(settings.values, canvas.width, canvas.height, smooth)) request();
      panel.notice('picture', '');
    } catch (error) {
      failed(error);
    }
  };
  const draw = () => {
    waiting = 0;
    measure?.forget();
    if (gl.isContextLost()) return;
    if (busy) { again = true; return; }
    const slow = settings.values.compare !== 0 && panel.technique.slow;
    const [wide, high] = [canvas.clientWidth, canvas.clientHeight].map((size) => size * Math.min(2, devicePixelRatio));
    const scale = slow ? pace.scale(wide * high, refining ? 600 : 60) : 1;
    const [width, height] = [wide, high].map((size) => Math.max(1, Math.round(size * scale)));
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    panel.coarse.hidden = scale === 1;
    canvas.ariaBusy = 'true';
    drawPicture(false);
    clearTimeout(tick);
    if (panel.technique.moves) tick = setTimeout(request, 1000 - performance.now() % 1000);  // at the next full second
    if (slow) drawnSlowly(width * height, wide * high);
    else later(rest);
  };
  // A finer picture follows when nothing else is asked for.
  const drawnSlowly = async (drawn, whole) => {
    busy = true;
    await pace.learn(gl, drawn);
    busy = false;
    if (again) {
      again = false;
      request();
    } else if (pace.scale(whole, 600) ** 2 * whole > 1.5 * drawn) {
      later(() => { refining = true; request(); });
    } else {
      later(rest);
    }
  };
  const bytes = new Bytes();
  let light;  // {name, textures, uniforms, exposure_ev, cut_off, bytes}
  // What was painted outlives a lost context and another light.
  const placeHighlight = () => {
    if (hasPainted) scene.textures.replace(ownHighlight, panel.painter.picture);
    else if (light.bytes.isWhole) panel.painter.show(floatsOfShared(scene.textures.texels(ownHighlight, 0)));
  };
  const showOnCard = () => {
    scene.show(light);
    placeHighlight();
    request();
  };
  const showLight = (other) => {
    light = {...other, bytes: Bytes.whole(other.bytes)};
    settings.start.exposure_ev = settings.values.exposure_ev = floats(light.bytes, ...light.exposure_ev)[0];
    panel.name(light.name, light.cut_off);
    if (scene && !gl.isContextLost()) showOnCard();
    update();
  };

  readAddress(location.hash);
  panel.show();
  // What was asked for: the address itself may have been written anew since.
  addEventListener('hashchange', (event) => { readAddress(new URL(event.newURL).hash); update(); });
  if (!gl) {
    panel.notice('picture', 'This browser gives no WebGL 2: there is no picture. The words and formulas are all here.');
    return;
  }
  scene = new Scene(gl, data, bytes);
  try {
    scene.prepare(settings.values);
  } catch (error) {
    failed(error);
  }
  canvas.addEventListener('webglcontextlost', (event) => {
    event.preventDefault();
    measure?.forget();
    measure = undefined;
    panel.notice('context', 'The graphics card was taken away from this page. It waits to get it back.');
  });
  canvas.addEventListener('webglcontextrestored', () => {
    panel.notice('context', '');
    scene = new Scene(gl, data, bytes);
    if (light) showOnCard();
  });
  new ResizeObserver(request).observe(canvas);
  orbitBy(canvas, settings, update, data.embedded);
  await openingRead;
  bytes.add(await unpacked(textOf('opening')));
  light ??= {...data.light, bytes};
  if (!gl.isContextLost()) showOnCard();
  await documentRead;
  await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));  // the first picture has been asked for
  bytes.add(await unpacked(textOf('rest')));
  bytes.isWhole = true;
  if (!gl.isContextLost()) placeHighlight();
  if (missing) request();
  missing = false;
};

const root = document.getElementById('zonal-view');
const tell = (error) => {
  const message = made('p', {class: 'zv-message', role: 'alert'}, 'The viewer cannot start: ' + String(error.message ?? error));
  (root.querySelector('.zv-notices') ?? root).prepend(message);
};
try {
  const data = JSON.parse(textOf('tables'));
  view(root, data).catch(tell);
} catch (error) {
  tell(error);
}
