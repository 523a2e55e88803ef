// What other scripts can do with the page: the object `poinsot`.

/** @param {Page} page */
function scripting(page) {
  const {figure} = page;
  const started = () => {
    if (!figure.program) throw new Error('the figure has not started; wait for poinsot.ready');
    return figure.program;
  };
  return Object.freeze({
    /** A promise of the first picture; asking for it starts the figure. */
    get ready() {
      return page.start();
    },
    /** The motion at any time, as `poinsot sample` has it. @param {number} t */
    at: (t) => started().at(Number(t)),
    /** Shows a time of the motion. @param {number} t */
    seek(t) {
      started();
      if (!Number.isFinite(t)) throw new TypeError(`poinsot.seek(${t}): give a time in seconds`);
      figure.film.seek(figure.film_second_of(t));
      page.changed();
    },
    play() {
      figure.film.pause();
      figure.film.play();
      page.changed();
    },
    pause() {
      figure.film.pause();
      page.changed();
    },
    next() {
      figure.film.next();
      page.changed();
    },
    previous() {
      figure.film.previous();
      page.changed();
    },
    /** Sets keys of the scene, as --set does; rejects with the program's message. @param {Record<string, unknown>} values */
    async set(values) {
      await page.start();
      page.set(new Map(Object.entries(values).map(([key, value]) => [key, toml_of(value)])));
    },
    /** Turns a panel, or all that have a view; null: the scene's camera. @param {(Partial<View>)|null} view */
    view(view) {
      if (view === null) {
        page.views.reset();
        return;
      }
      const {panel, ...values} = view;
      page.views.panels.forEach((place, index) => {
        if (place.has_view && (panel === undefined || panel === index)) page.views.change(index, values);
      });
    },
    /** This instant as a PNG file. @param {number} [width] @param {number} [height] */
    png: (width = figure.canvas.width, height = figure.canvas.height) => figure.png(width, height),
    /** This instant as SVG. */
    svg: () => page.svg(),
    get time_s() {
      return figure.time_s;
    },
    get first_time_s() {
      return figure.loaded?.first_time_s ?? 0;
    },
    get last_time_s() {
      return figure.loaded?.last_time_s ?? 0;
    },
  });
}

const the_page = new Page();
/** @type {any} */ (window)['poinsot'] = scripting(the_page);
the_page.watch_sight();
