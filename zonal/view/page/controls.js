// The inputs of the page, made from the tables of the data. Words of the data go in as text, never as markup.

const made = (tag, attributes, ...children) => {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === 'class') element.className = value;
    else if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (name in element) element[name] = value;
    else element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
};

// Each of these gives {element, show(value)}; `changed(name, value)` is called when a person turns it.

const sliderInput = (field, changed) => {
  const id = 'zv-' + field.name, value = made('span', {class: 'zv-value', 'aria-hidden': 'true'});  // the input says it
  const input = made('input', {type: 'range', id, name: field.name, min: field.least, max: field.greatest,
                               step: field.step > 0 ? field.step : 'any',
                               oninput: () => changed(field.name, Number(input.value))});
  const name = made('span', {class: 'zv-name'}, made('label', {htmlFor: id}, field.label), value);
  return {
    element: made('div', {class: 'zv-control'}, name, input),
    show: (number) => { input.value = number; value.textContent = String(Number(number.toPrecision(6))); },
  };
};

const toggleInput = (field, changed) => {
  const input = made('input', {type: 'checkbox', id: 'zv-' + field.name, name: field.name,
                               onchange: () => changed(field.name, input.checked ? 1 : 0)});
  return {
    element: made('label', {class: 'zv-control zv-toggle'}, input, field.label),
    show: (number) => { input.checked = number !== 0; },
  };
};

// groups: [[name or '', [[value, words]...]]...]
const selectInput = (name, label, groups, changed) => {
  const options = (list) => list.map(([value, words]) => made('option', {value}, words));
  const select = made('select', {id: 'zv-' + name, name, onchange: () => changed(name, select.value)},
                      ...groups.flatMap(([group, list]) => group === '' ? options(list)
                                                                        : [made('optgroup', {label: group}, ...options(list))]));
  return {
    element: made('div', {class: 'zv-control'}, made('label', {htmlFor: select.id, class: 'zv-name'}, label), select),
    show: (value) => { select.value = value; },
  };
};

const choiceInput = (field, changed) =>
    selectInput(field.name, field.label, [['', field.choices.map((words, i) => [String(i), words])]],
                (name, value) => changed(name, Number(value)));

// A choice with all its possibilities in sight.
const optionsInput = (field, changed) => {
  const inputs = field.choices.map((words, i) => made('input', {type: 'radio', name: field.name, value: String(i),
                                                               onchange: () => changed(field.name, i)}));
  const options = inputs.map((input, i) => made('label', {class: 'zv-option'}, input, made('span', {}, field.choices[i])));
  return {
    element: made('fieldset', {}, made('legend', {}, field.label), ...options),
    show: (number) => { inputs[number].checked = true; },
  };
};

const controlInput = (field, changed) =>
    field.kind === 'choice' ? choiceInput(field, changed) : field.kind === 'toggle' ? toggleInput(field, changed)
                                                                                   : sliderInput(field, changed);
