// The lecturer's window: the note of the stop, the next stop, a clock. Without pop-up windows, a part of the page.

class Notes {
  /** @param {HTMLElement} fallback part of the page for where windows are not allowed @param {() => Words} words @param {(event: KeyboardEvent) => void} keys */
  constructor(fallback, words, keys) {
    this.fallback = fallback;
    this.words = words;
    this.keys = keys;
    /** @type {Window|null} */
    this.window = null;
    /** @type {Document|null} */
    this.page = null;
    this.began_ms = 0;
    /** @type {Film|null} */
    this.film = null;
    this.timer = 0;
  }

  get is_open() {
    return this.page !== null && !(this.window?.closed ?? false);
  }

  toggle() {
    if (this.is_open) this.close();
    else this.open();
  }

  open() {
    this.began_ms ||= Date.now();
    try {
      this.window = window.open('', '', 'popup,width=720,height=520');
    } catch {
      this.window = null;
    }
    this.page = this.window?.document ?? document;
    const root = this.window ? this.page.body : this.fallback;
    root.replaceChildren();
    if (this.window) {
      const style = this.page.createElement('style');
      style.textContent = document.getElementById('page-style')?.textContent ?? '';
      this.page.head.append(style);
      this.page.title = this.words().of('notes');
      this.page.documentElement.lang = this.words().code;
      root.className = 'notes-window';
      this.window.addEventListener('keydown', this.keys);
    } else this.fallback.hidden = false;
    for (const name of ['clock', 'where', 'note', 'next']) {
      const part = this.page.createElement(name === 'note' ? 'p' : 'div');
      part.className = `notes-${name}`;
      root.append(part);
    }
    // The clock runs only while this window is open.
    this.timer = window.setInterval(() => this.show(this.film), 1000);
    this.show(this.film);
  }

  close() {
    window.clearInterval(this.timer);
    this.window?.close();
    this.fallback.hidden = true;
    this.window = null;
    this.page = null;
  }

  /** @param {Film|null} film */
  show(film) {
    this.film = film;
    if (!this.page || !film) return;
    if (this.window?.closed) {
      this.close();
      return;
    }
    const words = this.words();
    const {stops} = film.plan;
    const coming = film.coming_stop();
    const stop = stops[coming];
    const waits = film.waiting >= 0;
    const after = stops[waits ? coming + 1 : coming];
    const passed_s = Math.floor((Date.now() - this.began_ms) / 1000);
    const now = new Date().toLocaleTimeString(words.code, {hour: '2-digit', minute: '2-digit'});
    this.#write('clock', `${now} · ${words.of('elapsed')} ${clock_text(passed_s)} · ${words.of('film')} ${clock_text(film.at_s)} / ${clock_text(film.plan.length_s)}`);
    // On the way to a stop, what to say there; after the last, what was said.
    const shown = stop ?? stops[stops.length - 1];
    const number = stops.length > 0 ? `${(stop ? coming : stops.length - 1) + 1} / ${stops.length}` : '';
    this.#write('where', [number, shown?.title || film.chapter()?.title].filter(Boolean).join(' · '));
    this.#write('note', shown?.note ?? '');
    this.#write('next', `${words.of('next')}: ${after ? after.title || clock_text(after.at_s) : words.of('end')}`);
  }

  /** @param {string} name @param {string} text */
  #write(name, text) {
    const root = this.window ? this.page?.body : this.fallback;
    const part = root?.querySelector(`.notes-${name}`);
    if (part && part.textContent !== text) part.textContent = text;
  }
}

/** Minutes and seconds: "2:05". @param {number} seconds */
function clock_text(seconds) {
  const whole = Math.floor(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}`;
}
