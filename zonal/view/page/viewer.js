// The page: settings -> picture. Something is drawn only when something changed.

const view = async (root, data) => {
  const settings = new Settings(data);
  const changed = (name, value) => {
    if (name === undefined) settings.reset();
    else settings.set(name, value);
    update();
  };
  const panel = new Panel(root, data, settings, changed), canvas = panel.canvas;

  const readAddress = () => {
    if (data.embedded) return;
    let text = location.hash.slice(1);
    try { text = decodeURIComponent(text); } catch { /* a bare percent sign: the fields say what is wrong */ }
    settings.reset();
    const problems = settings.read(text);
    panel.notice('address', problems.length === 0 ? '' : 'In the address of this page:\n' + problems.join('\n'));
  };
  const writeAddress = () => {
    if (!data.embedded && decodeURI(location.hash.slice(1)) !== settings.text()) history.replaceState(null, '', '#' + settings.text());
  };

  const gl = canvas.getContext('webgl2', {alpha: false, antialias: true, powerPreference: 'high-performance'});
  readAddress();
  panel.show();
  if (!gl) {
    panel.notice('picture', 'This browser gives no WebGL 2: there is no picture. The words and formulas are all here.');
    return;
  }
  const bytes = await unpacked(data.bytes);
  let scene, measure, waiting = 0, idle = 0;

  const failed = (error) => {
    if (!(error instanceof LostContext)) panel.notice('picture', String(error.message ?? error));
  };
  const measureNow = async () => {
    writeAddress();
    if (gl.isContextLost()) return;
    if (!measure.possible) {
      panel.difference('the difference as a number cannot be had: this browser cannot draw into floats (EXT_color_buffer_float)');
      return;
    }
    try {
      const rms = await measure.difference(scene, settings.values);
      if (rms !== undefined) panel.difference(rms);
    } catch (error) {
      failed(error);
    }
  };
  const draw = () => {
    waiting = 0;
    if (gl.isContextLost()) return;
    const dots = Math.min(2, devicePixelRatio);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((size) => Math.max(1, Math.round(size * dots)));
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    try {
      scene.draw(settings.values, width, height);
      panel.notice('picture', '');
    } catch (error) {
      failed(error);
    }
    clearTimeout(idle);
    idle = setTimeout(measureNow, 250);
  };
  const request = () => { if (!waiting) waiting = requestAnimationFrame(draw); };
  const update = () => { panel.show(); request(); };
  const begin = () => {
    scene = new Scene(gl, data, bytes);
    measure = new Measure(gl);
    request();
  };

  canvas.addEventListener('webglcontextlost', (event) => {
    event.preventDefault();
    panel.notice('context', 'The graphics card was taken away from this page. It waits to get it back.');
  });
  canvas.addEventListener('webglcontextrestored', () => {
    panel.notice('context', '');
    begin();
  });
  addEventListener('hashchange', () => { readAddress(); update(); });
  new ResizeObserver(request).observe(canvas);
  orbitBy(canvas, settings, update, data.embedded);
  begin();
};

const root = document.getElementById('zonal-view');
const tell = (error) => {
  const message = made('p', {class: 'zv-message', role: 'alert'}, 'The viewer cannot start: ' + String(error.message ?? error));
  root.prepend(message);
};
try {
  const data = JSON.parse(document.getElementById('zonal-view-data').textContent);
  if (!data.embedded) document.title = data.title;
  view(root, data).catch(tell);
} catch (error) {
  tell(error);
}
