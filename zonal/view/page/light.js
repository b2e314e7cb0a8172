// Another light than the one that the page was written with: a picture that a person drops or chooses, made ready by the
// library in a worker.

class LightChooser {
  // data: what view_page_tables() wrote under "chooser"; show(light) is called with new tables.
  constructor(data, root, {show, notice}) {
    this.data = data;
    this.show = show;
    this.notice = notice;
    const input = made('input', {type: 'file', hidden: true, 'aria-label': 'A panorama', onchange: () => {
      if (input.files.length > 0) this.take(input.files);
      input.value = '';  // so that the same file can be chosen again
    }});
    const again = () => { if (this.file) this.open(); };
    const kinds = [['', [['', 'as its name and shape suggest'], ...data.layouts.map((name) => [name, name.replaceAll('-', ' ')])]]];
    const from = selectInput('from', 'How the picture shows the sphere', kinds, (_, value) => { this.from = value; again(); });
    const fix = toggleInput({name: 'fix', label: 'Repair what is not finite or negative'},
                            (_, value) => { this.fix = value; again(); });
    this.from = '';
    this.fix = 0;
    this.bar = made('progress', {max: 1, value: 0, 'aria-label': 'Progress'});
    this.stage = made('span', {});
    this.work = made('p', {class: 'zv-work', hidden: true}, this.stage, this.bar,
                     made('button', {type: 'button', onclick: () => this.cancel()}, 'Cancel'));
    this.words = made('p', {class: 'zv-note', role: 'status'});
    this.element = made('section', {class: 'zv-light'}, input,
        made('p', {}, made('button', {type: 'button', onclick: () => input.click()}, 'Choose a panorama…'),
             made('span', {class: 'zv-note'}, ' or drop one: EXR, HDR, PFM, PNG, JPEG, WebP, TGA')),
        this.work, this.words, made('details', {class: 'zv-reading'}, made('summary', {}, 'How it is read'), from.element, fix.element));
    this.watchDrops(root);
  }

  watchDrops(root) {
    const carriesFiles = (event) => event.dataTransfer?.types.includes('Files');
    let inside = 0;  // dragenter and dragleave come for each element on the way
    const mark = () => root.classList.toggle('zv-dropping', inside > 0);
    addEventListener('dragenter', (event) => { if (carriesFiles(event)) { ++inside; mark(); } });
    addEventListener('dragleave', (event) => { if (carriesFiles(event)) { inside = Math.max(0, inside - 1); mark(); } });
    addEventListener('dragover', (event) => { if (carriesFiles(event)) event.preventDefault(); });
    addEventListener('drop', (event) => {
      if (!carriesFiles(event)) return;
      event.preventDefault();
      inside = 0;
      mark();
      this.take(event.dataTransfer.files);
    });
  }

  take(files) {
    if (files.length > 1) {
      this.notice('light', 'One picture at a time: of several, a page cannot tell which is which face.');
      return;
    }
    this.file = files[0];
    this.open();
  }

  async open() {
    this.cancel();
    this.notice('light', '');
    const {file, from, fix} = this, ticket = this.ticket = {};
    this.progress('reading', 0);
    try {
      await documentRead;
      this.module ??= await unpacked(textOf('module'));
      const bytes = await file.arrayBuffer();
      if (this.ticket !== ticket) return;
      const source = URL.createObjectURL(new Blob([this.data.worker], {type: 'text/javascript'}));
      this.worker = new Worker(source);
      URL.revokeObjectURL(source);
      this.worker.onmessage = ({data}) => this.hear(data);
      this.worker.onerror = (event) => this.hear({refused: `${file.name}: ${event.message ?? 'this browser starts no worker'}`});
      this.worker.postMessage({module: this.module, file: bytes, name: file.name, from, fix: fix === 1}, [bytes]);
    } catch (error) {
      if (this.ticket === ticket) this.hear({refused: `${file.name}: ${error.message ?? error}`});
    }
  }

  progress(stage, fraction) {
    this.work.hidden = false;
    this.stage.textContent = stage;
    this.bar.value = fraction;
  }

  hear({stage, fraction, light, refused, hint}) {
    if (stage !== undefined) {
      this.progress(stage, fraction);
      return;
    }
    this.cancel();
    if (refused !== undefined) {
      this.notice('light', hint ? `${refused}\n${hint}` : refused);
      return;
    }
    const notes = [`taken for ${light.projection.replaceAll('-', ' ')}: ${light.projection_reason}`, ...light.notes];
    this.words.textContent = `${light.name}: ${notes.join('; ')}.`;
    this.show(light);
  }

  // Also when nothing is under way.
  cancel() {
    this.worker?.terminate();
    this.worker = this.ticket = undefined;
    this.work.hidden = true;
  }
}
