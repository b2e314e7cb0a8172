// All that the viewer is set to: named fields, as in the page's address and on the command line.

class Settings {
  constructor(data) {
    this.fields = new Map();
    this.fields.set('technique', {label: 'technique', names: data.techniques.map((t) => t.id)});
    this.fields.set('mesh', {label: 'object', names: data.meshes.map((m) => m.name)});
    for (const field of [...data.camera, ...data.controls]) this.fields.set(field.name, field);
    this.values = {technique: data.techniques[0].id, mesh: data.meshes[0].name};
    for (const field of [...data.camera, ...data.controls]) this.values[field.name] = field.initial;
    for (const problem of this.read(data.start)) throw new Error(problem);
    this.start = {...this.values};
  }

  // Takes what it can of "name=value&name=value" and says what it cannot. What is not named stays.
  read(text) {
    const problems = [];
    for (let part of text.split('&')) {
      if (part === '') continue;
      try { part = decodeURIComponent(part); } catch { /* a bare percent sign: what follows says what is wrong */ }
      const equals = part.indexOf('=');
      const name = equals < 0 ? part : part.slice(0, equals), value = equals < 0 ? '' : part.slice(equals + 1);
      const problem = equals < 0 ? `“${part}” is not a setting: write name=value` : this.take(name, value);
      if (problem) problems.push(problem);
    }
    return problems;
  }

  // undefined: taken.
  take(name, text) {
    const field = this.fields.get(name);
    if (!field) return `There is no setting “${name}”.`;
    if (field.names) {
      if (!field.names.includes(text)) return `There is no ${field.label} “${text}” in this page.`;
      this.values[name] = text;
      return undefined;
    }
    if (!/^-?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text)) return `${name}: “${text}” is not a number.`;
    const value = Number(text);
    if (!(value >= field.least && value <= field.greatest)) {
      return `${name} is ${text}: it goes from ${field.least} to ${field.greatest}.`;
    }
    const whole = field.kind === 'choice' || field.kind === 'toggle';
    if (whole && !Number.isInteger(value)) return `${name} is ${text}: it is a whole number.`;
    this.values[name] = value;
    return undefined;
  }

  // Of numbers: to the nearest that there is.
  set(name, value) {
    const field = this.fields.get(name);
    this.values[name] = field.names ? value : Math.min(field.greatest, Math.max(field.least, value));
  }

  reset() { Object.assign(this.values, this.start); }

  // The technique, and what differs from how the page opens.
  text() {
    const parts = ['technique=' + this.values.technique];
    for (const name of this.fields.keys()) {
      if (name !== 'technique' && this.values[name] !== this.start[name]) parts.push(`${name}=${encodeURIComponent(this.values[name])}`);
    }
    return parts.join('&');
  }
}
