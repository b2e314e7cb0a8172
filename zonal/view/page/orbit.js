// Moving the eye: one pointer turns it about the object, two or the wheel bring it nearer, and so do keys.

const orbitBy = (canvas, settings, changed, wheelNeedsFocus) => {
  const values = settings.values;
  const turn = (right, up) => {
    const yaw = values.yaw + right;
    settings.set('yaw', yaw - 360 * Math.round(yaw / 360));
    settings.set('pitch', values.pitch + up);
    changed();
  };
  const zoom = (factor) => { settings.set('distance', values.distance * factor); changed(); };

  const pointers = new Map();
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  canvas.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
  });
  canvas.addEventListener('pointermove', (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const before = pointers.size === 2 ? spread() : 0, dx = event.clientX - last.x, dy = event.clientY - last.y;
    [last.x, last.y] = [event.clientX, event.clientY];
    if (pointers.size === 1) turn(-0.4 * dx, 0.4 * dy);  // the object follows the pointer
    else if (pointers.size === 2 && spread() > 0) zoom(before / spread());
  });
  for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) {
    canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  }
  canvas.addEventListener('wheel', (event) => {
    if (event.ctrlKey || (wheelNeedsFocus && document.activeElement !== canvas)) return;  // the page's own zoom, its scrolling
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
    zoom(Math.exp(0.001 * lines * event.deltaY));
  }, {passive: false});

  const keys = {
    ArrowLeft: () => turn(-5, 0), ArrowRight: () => turn(5, 0), ArrowUp: () => turn(0, 5), ArrowDown: () => turn(0, -5),
    '+': () => zoom(1 / 1.1), '=': () => zoom(1 / 1.1), '-': () => zoom(1.1),
  };
  canvas.addEventListener('keydown', (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    keys[event.key]();
  });
};
