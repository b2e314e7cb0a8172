// Everything beside the picture: choices, words, numbers, messages.

// "L_lm", "4^k": what follows the sign, up to the end of the word, is set lower or higher.
const setFormula = (text) => text.split(/([_^][\p{L}\d]+)/u).map((part) =>
    part[0] === '_' ? made('sub', {}, part.slice(1)) : part[0] === '^' ? made('sup', {}, part.slice(1)) : part);

class Panel {
  // painted is called when a person's own highlight is another one; chooser: an element in front of all, or undefined.
  constructor(root, data, settings, changed, painted, chooser) {
    this.data = data;
    this.settings = settings;
    this.shown = new Map();  // name -> {element, show}
    const input = (name, part) => { this.shown.set(name, part); return part.element; };
    const control = (field) => input(field.name, controlInput(field, changed));
    const named = (name) => data.controls.find((field) => field.name === name);

    this.canvas = made('canvas', {tabIndex: 0, role: 'img'});
    this.canvas.setAttribute('aria-describedby', 'zv-keys');
    const compare = named('compare');
    this.sides = made('div', {class: 'zv-sides', hidden: true},
                      ...compare.choices.slice(0, 2).map((words) => made('span', {}, words)));
    this.sides.setAttribute('aria-hidden', 'true');
    this.coarse = made('p', {class: 'zv-coarse', hidden: true},
                       'Drawn coarsely: this exact answer is a long sum for every pixel.');
    this.number = made('output', {class: 'zv-number'});
    this.gain = control(named('difference_gain'));
    const stage = made('div', {class: 'zv-stage'}, made('div', {class: 'zv-picture'}, this.canvas, this.sides, this.coarse),
        made('div', {class: 'zv-bar'}, input('compare', optionsInput(compare, changed)), this.gain, this.number),
        made('span', {class: 'zv-unseen', id: 'zv-keys'},
             'Arrow keys turn the eye about the object, plus and minus bring it nearer and farther.'));

    const groups = new Map();
    for (const {group, id, title} of data.techniques) groups.set(group, [...(groups.get(group) ?? []), [id, title]]);
    this.explanation = made('p', {});
    this.formula = made('p', {class: 'zv-formula'});
    this.source = made('p', {class: 'zv-source'});
    const objects = data.meshes.map(({name}) => [name, name.replaceAll('-', ' ')]);
    const inBar = ['compare', 'difference_gain'], others = data.controls.filter((field) => !inBar.includes(field.name));
    const own = others.filter((field) => !field.common).map((field) => control(field));
    this.painter = new HighlightPainter(painted);
    this.notices = made('div', {class: 'zv-notices', role: 'alert'});
    this.note = made('p', {class: 'zv-note'});
    this.title = made('h1', {});
    const panel = made('div', {class: 'zv-panel'}, ...(chooser ? [chooser] : []),
        input('technique', selectInput('technique', 'Technique', [...groups], changed)),
        made('div', {class: 'zv-words'}, this.explanation, this.formula, this.source),
        ...own, this.painter.element,
        input('mesh', selectInput('mesh', 'Object', [['', objects]], changed)),
        ...others.filter((field) => field.common).map((field) => control(field)),
        made('details', {}, made('summary', {}, 'Eye'), ...data.camera.map((field) => control(field))),
        made('p', {}, made('button', {type: 'button', onclick: () => changed()}, 'All as at first')),
        this.note);
    const header = made('header', {}, this.title, made('p', {class: 'zv-subtitle'}, data.subtitle));
    root.replaceChildren(...(data.embedded ? [] : [header]), this.notices, stage, panel);
    this.name(data.title, data.light.cut_off);
  }

  // Whose light this is.
  name(title, cutOff) {
    if (!this.data.embedded) document.title = title;
    this.title.textContent = title;
    this.note.textContent = `${this.data.note} ${cutOff}`;
  }

  // Everything as the settings are.
  show() {
    const values = this.settings.values, technique = this.data.techniques.find((t) => t.id === values.technique);
    for (const [name, part] of this.shown) part.show(values[name]);
    for (const field of this.data.controls) {
      if (!field.common) this.shown.get(field.name).element.hidden = !technique.controls.includes(field.name);
    }
    // The last choice of a highlight is a person's own.
    const sources = this.data.controls.find((field) => field.name === 'highlight_source');
    this.painter.element.hidden = !technique.controls.includes(sources.name) || values[sources.name] !== sources.greatest;
    this.gain.hidden = values.compare !== 2;
    this.sides.hidden = values.compare !== 3;
    this.explanation.textContent = technique.explanation;
    this.formula.replaceChildren(...setFormula(technique.formula));
    this.source.textContent = technique.source;
    this.technique = technique;
    this.number.classList.add('zv-stale');
    this.describe();
  }

  // rms: a number, or words that say why there is none.
  difference(rms) {
    if (typeof rms === 'string') {
      this.number.textContent = rms;
    } else {
      const percent = rms === 0 ? '0' : rms < 1e-5 ? 'under 0.001' : Number((100 * rms).toPrecision(2)).toString();
      this.number.replaceChildren('difference to the exact answer ', made('b', {}, percent + ' %'));
    }
    this.number.classList.remove('zv-stale');
    this.number.title = 'Root mean square of the difference over that of the exact answer, on the object, in linear light.';
    this.describe();
  }

  describe() {
    const number = this.number.classList.contains('zv-stale') ? '' : ' ' + this.number.textContent + '.';
    const {mesh, compare} = this.settings.values;
    const what = this.data.controls.find((field) => field.name === 'compare').choices[compare];
    this.canvas.setAttribute('aria-label',
                             `${mesh.replaceAll('-', ' ')} lit by: ${this.technique.title}. Shown: ${what}.${number}`);
  }

  // A message of a kind replaces the last one of that kind; no words take it away.
  notice(kind, words) {
    const old = [...this.notices.children].find((element) => element.dataset.kind === kind);
    if (!words) { old?.remove(); return; }
    if (old && old.firstChild.textContent === words) return;
    old?.remove();
    const message = made('p', {class: 'zv-message'}, made('span', {}, words),
                         made('button', {type: 'button', onclick: () => message.remove()}, 'Close'));
    message.dataset.kind = kind;
    this.notices.append(message);
  }
}
