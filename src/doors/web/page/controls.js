// Sliders, fields, switches and choices for the keys of [page] controls.

/** @import {Control} from './program.js' */
/** @import {Words} from './words.js' */

/** A value as TOML, for --set. @param {unknown} value @returns {string} */
export function toml_of(value) {
  if (Array.isArray(value)) return `[${value.map(toml_of).join(', ')}]`;
  if (typeof value === 'number') return Number.isInteger(value) && Math.abs(value) < 1e15 ? value.toFixed(1) : String(value);
  return String(value);
}

/** The value of an override for a control. @param {Control} control @param {unknown} value */
function override_of(control, value) {
  return control.kind === 'integer' ? String(value) : toml_of(value);
}

/**
 * Bounds of a slider: those of its key. Where one is missing, or many decades lie between them, three times the value, or the largest
 * component of a vector, takes their place.
 * @param {{min: number|null, max: number|null, size?: number}} control @param {number} value
 */
export function slider_span({min, max, size = 0}, value) {
  const reach = 3 * (Math.max(size, Math.abs(value)) || 1);
  const is_wide = min !== null && max !== null && Math.log10(max / (min > 0 ? min : 1)) > 4;
  const least = min === null || is_wide ? Math.max(min ?? -Infinity, -reach) : min;
  const most = max === null || is_wide ? Math.min(max ?? Infinity, Math.max(reach, (min ?? 0) + reach)) : max;
  return {least, most};
}

/** The label of a control: in the language of the page, or else the beginning of what the key means. @param {Control} control @param {Words} words */
function title_of(control, words) {
  const clause = (control.label || control.key).split(';')[0] ?? '';
  return words.label(control.key) ?? clause.replace(/^[a-z]/, (letter) => letter.toUpperCase());
}

/** @typedef {Control & {size?: number}} ShownControl `size`: of the largest component of a vector. */

/** A component of a vector, "start.omega_rad_s[1]", is a number. @param {Control} control @param {Words} words @returns {ShownControl} */
export function component_of(control, words) {
  const label = title_of(control, words);
  const index = /\[(\d+)\]$/.exec(control.key)?.[1];
  if (!Array.isArray(control.value)) return {...control, label};
  const size = Math.max(...control.value.map((x) => Math.abs(x)));
  if (index === undefined) return {...control, label, size};
  return {...control, kind: 'number', label: `${label} [${index}]`, value: control.value[Number(index)] ?? 0, size};
}

export class Controls {
  /** @param {HTMLElement} holder @param {() => Words} words @param {(key: string, value: string) => void} change */
  constructor(holder, words, change) {
    this.holder = holder;
    this.words = words;
    this.change = change;
    /** @type {Map<string, {control: Control, show: (value: Control['value']) => void, message: HTMLElement}>} */
    this.rows = new Map();
    this.signature = '';
  }

  /** Shows the values that the scene has now. @param {Control[]} controls */
  show(controls) {
    controls = controls.map((control) => component_of(control, this.words()));
    const signature = controls.map((c) => c.key + c.label + c.kind + (Array.isArray(c.value) ? c.value.length : '')).join();
    if (signature !== this.signature) this.#build(controls);
    this.signature = signature;
    for (const control of controls) {
      const row = this.rows.get(control.key);
      if (!row) continue;
      row.control = control;
      row.show(control.value);
      row.message.textContent = '';
    }
  }

  /** Shows a message below its control. @param {string} key @param {string} message */
  show_message(key, message) {
    const row = this.rows.get(key) ?? [...this.rows.values()][0];
    if (row) row.message.textContent = message;
  }

  /** @param {Control[]} controls */
  #build(controls) {
    this.holder.replaceChildren();
    this.rows.clear();
    for (const control of controls) {
      const group = document.createElement('fieldset');
      group.className = 'control';
      const title = document.createElement('legend');
      title.textContent = control.label;
      title.title = control.key;
      if (control.unit) {
        const unit = document.createElement('span');
        unit.className = 'unit';
        unit.textContent = ` / ${control.unit}`;
        title.append(unit);
      }
      const message = document.createElement('p');
      message.className = 'refusal';
      message.setAttribute('role', 'alert');
      group.append(title);
      const show = this.#fill(group, control);
      group.append(message);
      this.holder.append(group);
      this.rows.set(control.key, {control, show, message});
    }
  }

  /** @param {HTMLElement} group @param {Control} control @returns {(value: Control['value']) => void} */
  #fill(group, control) {
    if (control.kind === 'boolean') return this.#switch(group, control);
    if (control.kind === 'choice') return this.#choice(group, control);
    const first = Array.isArray(control.value) ? control.value : [Number(control.value)];
    const now = [...first];
    const sent = () => {
      const value = Array.isArray(control.value) ? now : now[0];
      this.change(control.key, override_of(control, value));
    };
    const rows = first.map((value, i) => {
      const name = first.length > 1 ? `${control.label} ${i + 1}` : control.label;
      return this.#number(group, control, name, first.length > 1 ? String(i + 1) : '', value, (changed) => {
        now[i] = changed;
        sent();
      });
    });
    return (value) => {
      const values = Array.isArray(value) ? value : [Number(value)];
      values.forEach((v, i) => {
        now[i] = v;
        rows[i]?.(v);
      });
    };
  }

  /**
   * A slider and a field for one number.
   * @param {HTMLElement} group @param {Control} control @param {string} name @param {string} index
   * @param {number} first @param {(value: number) => void} changed @returns {(value: number) => void}
   */
  #number(group, control, name, index, first, changed) {
    const row = document.createElement('div');
    row.className = 'number';
    const slider = document.createElement('input');
    const field = document.createElement('input');
    slider.type = 'range';
    field.type = 'number';
    const label = control.unit ? `${name} / ${control.unit}` : name;
    slider.setAttribute('aria-label', label);
    field.setAttribute('aria-label', label);
    const {step} = control;
    slider.step = step === null ? 'any' : String(step);
    field.step = step === null ? 'any' : String(step);
    const widen = (/** @type {number} */ value) => {
      const {least, most} = slider_span(control, value);
      slider.min = String(least);
      slider.max = String(most);
    };
    widen(first);
    slider.addEventListener('input', () => {
      // Three digits of the slider's span: what a hand can set.
      const span = Number(slider.max) - Number(slider.min);
      const grain = control.kind === 'integer' ? 1 : 10 ** Math.floor(Math.log10(span / 400));
      const value = Math.round(Number(slider.value) / grain) * grain;
      changed(Number(value.toPrecision(12)));
    });
    field.addEventListener('change', () => {
      if (field.value.trim() !== '' && Number.isFinite(field.valueAsNumber)) changed(field.valueAsNumber);
    });
    if (index) {
      const mark = document.createElement('span');
      mark.className = 'index';
      mark.textContent = index;
      row.append(mark);
    }
    row.append(slider, field);
    group.append(row);
    return (value) => {
      if (value < Number(slider.min) || value > Number(slider.max)) widen(value);
      slider.value = String(value);
      slider.style.setProperty('--part', String((value - Number(slider.min)) / (Number(slider.max) - Number(slider.min))));
      if (document.activeElement !== field || Number(field.value) !== value) field.value = String(Number(value.toPrecision(10)));
    };
  }

  /** @param {HTMLElement} group @param {Control} control @returns {(value: Control['value']) => void} */
  #switch(group, control) {
    const box = document.createElement('input');
    box.type = 'checkbox';
    box.setAttribute('aria-label', control.label);
    box.addEventListener('change', () => this.change(control.key, String(box.checked)));
    group.append(box);
    return (value) => {
      box.checked = value === true;
    };
  }

  /** @param {HTMLElement} group @param {Control} control @returns {(value: Control['value']) => void} */
  #choice(group, control) {
    const list = document.createElement('select');
    list.setAttribute('aria-label', control.label);
    for (const choice of control.choices ?? []) list.append(new Option(choice, choice));
    list.addEventListener('change', () => this.change(control.key, JSON.stringify(list.value)));
    group.append(list);
    return (value) => {
      list.value = String(value);
    };
  }
}
