// The workbench: gallery, text of the scene, files, and what it exports.

/**
 * @typedef {{name: string, title: string, text: string, files: Record<string, string>, thumbnail: string}} GalleryScene
 * @typedef {{schema: string, scenes: GalleryScene[], template: string, no_script: Record<string, string>}} WorkbenchData
 */

const write_after_ms = 250;
const most_rows = 20000;

/** @type {Record<string, string[]>} */
const workbench_words = {
  gallery: ['Gallery', 'Galerie', 'Galerie', 'Galería', 'Galleria', 'ギャラリー'],
  open: ['Open …', 'Öffnen …', 'Ouvrir…', 'Abrir…', 'Apri…', '開く…'],
  save_scene: ['Save scene', 'Szene speichern', 'Enregistrer la scène', 'Guardar la escena', 'Salva la scena', 'シーンを保存'],
  export_page: ['Page', 'Seite', 'Page', 'Página', 'Pagina', 'ページ'],
  export_csv: ['Data (CSV)', 'Daten (CSV)', 'Données (CSV)', 'Datos (CSV)', 'Dati (CSV)', 'データ (CSV)'],
  reading: ['Reading', 'Liest', 'Lecture de', 'Leyendo', 'Lettura di', '読み込み中:'],
  text: ['Text of the scene', 'Text der Szene', 'Texte de la scène', 'Texto de la escena', 'Testo della scena', 'シーンのテキスト'],
};
Object.assign(all_words, workbench_words);

/** @param {Uint8Array} bytes @returns {string} */
function base64_of_bytes(bytes) {
  let text = '';
  for (let i = 0; i < bytes.length; i += 32768) text += String.fromCharCode(...bytes.subarray(i, i + 32768));
  return btoa(text);
}

/** JSON for a script element: it cannot close the element. @param {unknown} value */
function script_json(value) {
  return JSON.stringify(value).replace(/[<>&\u2028\u2029]/g, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, '0')}`);
}

/** @param {string} text */
function escaped(text) {
  return text.replace(/[&<>"']/g, (c) => `&#${c.charCodeAt(0)};`);
}

class Workbench {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    /** @type {WorkbenchData} */
    this.data = JSON.parse(block('workbench-data'));
    this.words = new Words(navigator.language.slice(0, 2));
    this.timer = 0;
    /** Choices that the next accepted text gets. @type {Partial<Choices>} */
    this.changes = {};
    /** Files dropped or of the gallery, as base64. @type {Record<string, string>} */
    this.files = {};
    this.editor = new Editor(JSON.parse(this.data.schema), () => this.#soon());
    this.#name();
    this.#wire();
    this.#show_gallery();
    this.editor.text = page.data.text;
    this.files = {...page.data.files};
    page.said = () => this.#find();
    this.measure = new Measure(this.words, (name, text, files) => this.open(name, text, files));
    this.#open_named();
  }

  /** A link may name a scene of the gallery: poinsot.html#scene=tennis_racket. */
  #open_named() {
    const name = new URLSearchParams(location.hash.slice(1)).get('scene');
    const scene = this.data.scenes.find((scene) => scene.name === name);
    if (scene) this.open(scene.name, scene.text, scene.files);
  }

  #name() {
    for (const [id, word] of [['gallery-open', 'gallery'], ['file-open', 'open'], ['file-save', 'save_scene'], ['export-page', 'export_page'],
      ['export-csv', 'export_csv']]) part(/** @type {string} */ (id)).textContent = this.words.of(/** @type {string} */ (word));
    for (const id of ['text', 'writing']) part(id).setAttribute('aria-label', this.words.of('text'));
    part('gallery-close').setAttribute('aria-label', this.words.of('close'));
    const heading = part('gallery').querySelector('h2');
    if (heading) heading.textContent = this.words.of('gallery');
  }

  #wire() {
    const gallery = /** @type {HTMLDialogElement} */ (part('gallery'));
    part('gallery-open').addEventListener('click', () => gallery.showModal());
    part('file-open').addEventListener('click', () => input('file').click());
    input('file').addEventListener('change', () => {
      void this.#take([...(input('file').files ?? [])]);
      input('file').value = '';
    });
    part('file-save').addEventListener('click', () => this.page.save(new Blob([this.editor.text], {type: 'application/toml'}), '.toml'));
    part('export-csv').addEventListener('click', () => this.page.save(new Blob([this.csv()], {type: 'text/csv'}), '.csv'));
    part('export-page').addEventListener('click', () => void this.page_of_scene().then(
      (text) => this.page.save(new Blob([text], {type: 'text/html'}), '.html'), (error) => this.#find(error)));
    document.addEventListener('dragover', (event) => {
      event.preventDefault();
      document.body.classList.add('dropping');
    });
    document.addEventListener('dragleave', () => document.body.classList.remove('dropping'));
    document.addEventListener('drop', (event) => {
      event.preventDefault();
      document.body.classList.remove('dropping');
      void this.#take([...(event.dataTransfer?.files ?? [])]);
    });
  }

  #show_gallery() {
    part('scenes').replaceChildren(...this.data.scenes.map((scene) => {
      const button = document.createElement('button');
      const picture = document.createElement('img');
      const title = document.createElement('span');
      button.type = 'button';
      picture.src = scene.thumbnail;
      picture.alt = '';
      picture.loading = 'lazy';
      title.textContent = scene.title;
      button.append(picture, title);
      button.addEventListener('click', () => {
        /** @type {HTMLDialogElement} */ (part('gallery')).close();
        this.open(scene.name, scene.text, scene.files);
      });
      return button;
    }));
  }

  /** @param {string} name @param {string} text @param {Record<string, string>} files */
  open(name, text, files) {
    this.editor.text = text;
    this.files = {...this.files, ...files};
    this.page.views.reset();
    this.page.figure.film.seek(0);
    this.page.figure.film.pause();
    this.page.figure.film.untouched = true;
    this.#write(name, {values: new Map(), shown: null});
  }

  /** Opens scenes, keeps the files that scenes name, and measures tables that the scene does not name. @param {File[]} files */
  async #take(files) {
    if (files.length === 0) return;
    const scene = files.find((file) => file.name.toLowerCase().endsWith('.toml'));
    const table = files.find((file) => /\.(csv|tsv|txt)$/i.test(file.name));
    if (table && !scene && (this.measure.is_open || !this.editor.text.includes(table.name))) {
      await this.measure.take(table.name, new Uint8Array(await table.arrayBuffer()));
      return;
    }
    /** @type {Record<string, string>} */
    const taken = {};
    for (const file of files) if (file !== scene) taken[file.name] = base64_of_bytes(new Uint8Array(await file.arrayBuffer()));
    this.files = {...this.files, ...taken};
    await this.#show_reading(files);
    if (scene) this.open(scene.name.replace(/\.toml$/i, ''), await scene.text(), {});
    else this.#write(this.page.data.name);
  }

  /** Says which files the program reads, and waits until that is painted: a large mesh takes seconds. @param {File[]} files */
  async #show_reading(files) {
    const row = document.createElement('p');
    row.textContent = `${this.words.of('reading')} ${files.map((file) => file.name).join(', ')} …`;
    part('findings').replaceChildren(row);
    await painted();
  }

  #soon() {
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.#write(this.page.data.name), write_after_ms);
  }

  /** Gives the text to the program. @param {string} name @param {Partial<Choices>} [changes] kept until the program accepts a text */
  #write(name, changes = {}) {
    const {page} = this;
    this.changes = {...this.changes, ...changes};
    const data = {...page.data, name, text: this.editor.text, files: this.files};
    try {
      if (!page.figure.program) {
        // The next start shows this text.
        page.figure.choices = {...page.figure.choices, ...this.changes};
        page.data = data;
        return;
      }
      for (const [file, bytes] of Object.entries(this.files)) page.figure.program.addFile(file, bytes_of_base64(bytes));
      page.figure.reload(this.changes, data);
      this.changes = {};
      page.data = data;
    } catch (error) {
      page.data = {...page.data, name};
      this.#find(error);
    }
  }

  /** Shows what the program found in the text. @param {unknown} [error] */
  #find(error) {
    /** @type {Finding[]} */
    const findings = [];
    const rows = [];
    if (error) {
      const {line, column} = error instanceof ProgramError ? error : {line: 0, column: 0};
      const finding = {message: message_of(error), line, column};
      findings.push(finding);
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = finding.message;
      button.addEventListener('click', () => this.editor.go(Math.max(1, finding.line), finding.column));
      rows.push(button);
    } else {
      const {loaded} = this.page.figure;
      for (const text of loaded ? [loaded.regime, ...loaded.notes].filter(Boolean) : []) {
        const row = document.createElement('p');
        row.textContent = text;
        rows.push(row);
      }
    }
    part('findings').replaceChildren(...rows);
    this.editor.mark(findings);
  }

  /** The motion at the film's frames, with the columns of `poinsot sample`. */
  csv() {
    const {figure} = this.page;
    const {program} = figure;
    if (!program) return '';
    const {length_s, frames_per_s} = figure.film.plan;
    const n = Math.min(most_rows, Math.max(1, Math.round(length_s * frames_per_s)));
    const states = Array.from({length: n}, (_, k) => program.at(figure.time_of(k / frames_per_s)));
    const rows = states.map((state) =>
      [state.time_s, ...state.omega_body, ...state.space_from_body, ...state.herpolhode, ...(state.angles ?? [])].join(','));
    const names = ['time_s', 'omega_body_1', 'omega_body_2', 'omega_body_3', 'q_w', 'q_x', 'q_y', 'q_z',
      'herpolhode_x', 'herpolhode_y', 'herpolhode_z', ...(states[0]?.angles ? ['theta_rad', 'phi_rad', 'psi_rad'] : [])];
    return `${names.join(',')}\n${rows.join('\n')}\n`;
  }

  /** A page of this scene, as `poinsot render -o PAGE.html` writes it. */
  async page_of_scene() {
    const {page} = this;
    const {figure} = page;
    const {loaded} = figure;
    const width = 1280;
    const height = Math.round((width * (loaded?.height ?? page.data.height)) / (loaded?.width ?? page.data.width));
    const language = loaded?.language ?? 'en';
    const poster = await figure.png(width, height, 'image/jpeg');
    // The text that the program accepted last, and its files.
    const {text} = page.data;
    const files = Object.fromEntries(Object.entries(page.data.files).filter(([name]) => text.includes(name)));
    const scene = {...page.data, files, controls: loaded?.controls.map((c) => c.key) ?? [],
      overrides: [...figure.choices.values].map(([key, value]) => `${key}=${value}`), language, width: loaded?.width ?? page.data.width, height: loaded?.height ?? page.data.height,
      poster_at_s: figure.film.at_s};
    /** @type {Record<string, string>} */
    const values = {
      language: escaped(language), 'no-script': escaped(this.data.no_script[language] ?? ''), ground: escaped(loaded?.theme.background ?? '#ffffff'), title: escaped(loaded?.title ?? page.data.name),
      poster: `data:${poster.type};base64,${base64_of_bytes(new Uint8Array(await poster.arrayBuffer()))}`,
      scene: script_json(scene), fonts: block('program-fonts'), 'page-scripts': block('page-scripts'), 'film-writer': block('film-writer'), module: block('program-module'),
    };
    return this.data.template.replace(/\{\{([a-z-]+)\}\}/g, (place, name) => values[name] ?? place);
  }
}

const the_workbench = new Workbench(the_page);
