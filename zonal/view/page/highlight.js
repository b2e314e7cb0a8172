// A person's own highlight: a disc to paint on with a pointer, or a picture file. `changed()` is called when the picture
// is another one.

// The numbers of a texture of shared exponents (GL_RGB9_E5).
const floatsOfShared = (words) => {
  const floats = new Float32Array(3 * words.length);
  words.forEach((word, i) => {
    const scale = 2 ** ((word >>> 27) - 24);
    for (let c = 0; c < 3; ++c) floats[3 * i + c] = (word >>> 9 * c & 511) * scale;
  });
  return floats;
};

const linearOf = (byte) => {
  const c = byte / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
};
const byteOf = (light) => {
  const c = Math.min(1, light / (1 + light) * (1 + light / 64));  // as the picture's own tone curve
  return Math.round(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055));
};

class HighlightPainter {
  constructor(changed) {
    this.changed = changed;
    this.brush = {size: 0.12, brightness: 3};
    this.canvas = made('canvas', {role: 'img'});
    this.canvas.setAttribute('aria-label', 'Your highlight, as the eye sees it on a ball. It is painted with a pointer.');
    const slider = (name, label, least, greatest, step) => {
      const part = sliderInput({name, label, least, greatest, step}, (_, value) => {
        this.brush[name] = value;
        part.show(value);
      });
      part.show(this.brush[name]);
      return part.element;
    };
    this.color = made('input', {type: 'color', value: '#ffffff'});
    this.erase = made('input', {type: 'checkbox'});
    const file = made('input', {type: 'file', accept: 'image/*', onchange: () => this.open(file.files[0])});
    this.message = made('p', {role: 'status'});
    this.element = made('div', {class: 'zv-paint', hidden: true},
        made('p', {}, 'Paint on the disc: it is the object as the eye sees it. Painting needs a pointer; with a keyboard, ' +
                          'open a picture file or choose another highlight above.'),
        this.canvas, slider('size', 'brush, widths of the disc', 0.02, 0.5, 0.01),
        slider('brightness', 'brightness, white is 1', 0.1, 10, 0.1),
        made('p', {class: 'zv-row'}, made('label', {}, 'colour ', this.color), made('label', {}, this.erase, ' erase'),
             made('button', {type: 'button', onclick: () => this.clear()}, 'Clear')),
        made('label', {class: 'zv-file'}, 'or a picture file ', file), this.message);
    this.listen();
  }

  // picture: three numbers a texel, linear light, square.
  show(picture) {
    this.picture = picture;
    const px = Math.round(Math.sqrt(picture.length / 3));
    this.canvas.width = this.canvas.height = px;
    const image = new ImageData(px, px);
    for (let i = 0; i < px * px; ++i) {
      for (let c = 0; c < 3; ++c) image.data[4 * i + c] = byteOf(picture[3 * i + c]);
      image.data[4 * i + 3] = 255;
    }
    this.canvas.getContext('2d').putImageData(image, 0, 0);
  }
  replace(picture) {
    this.show(picture);
    this.changed();
  }
  clear() { if (this.picture) this.replace(new Float32Array(this.picture.length)); }

  listen() {
    let stroke;
    const paint = (event) => {
      const box = this.canvas.getBoundingClientRect();
      for (const each of event.getCoalescedEvents?.().length ? event.getCoalescedEvents() : [event]) {
        stroke.moveTo((each.clientX - box.left) / box.width, (each.clientY - box.top) / box.height);
      }
      this.replace(stroke.picture);
    };
    this.canvas.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || !this.picture) return;
      this.canvas.setPointerCapture(event.pointerId);
      const bytes = [1, 3, 5].map((at) => parseInt(this.color.value.slice(at, at + 2), 16));
      stroke = new Stroke(this.picture, {
        radius: this.brush.size,
        light: bytes.map((byte) => (this.erase.checked ? 0 : this.brush.brightness * linearOf(byte))),
      });
      paint(event);
    });
    this.canvas.addEventListener('pointermove', (event) => { if (stroke) paint(event); });
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) {
      this.canvas.addEventListener(end, () => { stroke = undefined; });
    }
  }

  // The middle square of a picture that the browser can read.
  async open(file) {
    if (!file || !this.picture) return;
    try {
      const source = await createImageBitmap(file), side = Math.min(source.width, source.height), px = this.canvas.width;
      const context = made('canvas', {width: px, height: px}).getContext('2d', {willReadFrequently: true});
      context.imageSmoothingQuality = 'high';
      context.drawImage(source, (source.width - side) / 2, (source.height - side) / 2, side, side, 0, 0, px, px);
      const {data} = context.getImageData(0, 0, px, px), picture = new Float32Array(3 * px * px);
      for (let i = 0; i < px * px; ++i) {
        for (let c = 0; c < 3; ++c) picture[3 * i + c] = linearOf(data[4 * i + c]) * data[4 * i + 3] / 255;
      }
      this.replace(picture);
      this.message.textContent = `“${file.name}” is your highlight now.`;
    } catch {
      this.message.textContent = `“${file.name}” is no picture that this browser can read: give a PNG or a JPEG.`;
    }
  }
}
