// Draws a measured ω(t).

/**
 * @typedef {{begin_s: number, end_s: number, picked: boolean}} Band a flight
 * @typedef {{rows: ArrayLike<number>, from_s: number, to_s: number, bands: Band[]}} OmegaPlot
 *   Rows of four numbers: the time in s, and three components of ω in rad/s.
 */

/** Steps of 1, 2 or 5 times a power of ten, some `n` of them. @param {number} span @param {number} n */
function round_step(span, n) {
  const raw = span / n;
  const decade = 10 ** Math.floor(Math.log10(raw));
  return decade * ([1, 2, 5].find((digit) => digit * decade >= raw) ?? 10);
}

export class OmegaChart {
  /** @param {HTMLCanvasElement} canvas @param {boolean} has_legend above it */
  constructor(canvas, has_legend) {
    this.canvas = canvas;
    this.has_legend = has_legend;
    /** @type {OmegaPlot|null} */
    this.plot = null;
    this.frame = 0;
    new ResizeObserver(() => this.show(this.plot)).observe(canvas);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.show(this.plot));
  }

  /** Draws it in the next frame. @param {OmegaPlot|null} plot */
  show(plot) {
    this.plot = plot;
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.#draw();
    });
  }

  /** Where the plot lies on the canvas, CSS pixels. */
  get box() {
    return {left: 40, right: this.canvas.clientWidth - 10, top: this.has_legend ? 24 : 8, bottom: this.canvas.clientHeight - 20};
  }

  /** The instant at a place from the left. @param {number} x CSS pixels */
  time_at(x) {
    const {left, right} = this.box;
    const {from_s, to_s} = this.plot ?? {from_s: 0, to_s: 1};
    return from_s + ((x - left) / Math.max(1, right - left)) * (to_s - from_s);
  }

  #draw() {
    const {canvas, plot} = this;
    const ink = canvas.getContext('2d');
    const {clientWidth, clientHeight} = canvas;
    if (!ink || clientWidth === 0) return;
    const ratio = window.devicePixelRatio || 1;
    canvas.width = Math.round(clientWidth * ratio);
    canvas.height = Math.round(clientHeight * ratio);
    ink.scale(ratio, ratio);
    if (!plot || plot.rows.length === 0) return;
    const style = getComputedStyle(canvas);
    const colour = (/** @type {string} */ name) => style.getPropertyValue(name).trim() || style.color;
    const {left, right, top, bottom} = this.box;
    const {rows, from_s, to_s} = plot;
    let [first, last] = [0, rows.length / 4];
    while (first < last && (rows[4 * first] ?? 0) < from_s) ++first;
    while (last > first && (rows[4 * (last - 1)] ?? 0) > to_s) --last;
    let most = 1e-9;
    for (let k = first; k < last; ++k) for (let i = 1; i < 4; ++i) most = Math.max(most, Math.abs(rows[4 * k + i] ?? 0));
    most *= 1.06;
    const x_of = (/** @type {number} */ t) => left + ((t - from_s) / Math.max(1e-9, to_s - from_s)) * (right - left);
    const y_of = (/** @type {number} */ w) => (top + bottom) / 2 - (w / most) * ((bottom - top) / 2);

    for (const band of plot.bands) {
      const [x0, x1] = [Math.max(left, x_of(band.begin_s)), Math.min(right, x_of(band.end_s))];
      // Narrow bands need more contrast.
      const is_narrow = x1 - x0 < 12;
      ink.fillStyle = colour(`--${band.picked ? 'picked' : 'band'}${is_narrow ? '-narrow' : ''}`);
      if (x1 > x0) ink.fillRect(x0, top, Math.max(is_narrow ? 3 : 0, x1 - x0), bottom - top);
    }
    this.#axes({x_of, y_of, most, colour, ink});
    ink.save();
    ink.beginPath();
    ink.rect(left, top, right - left, bottom - top);
    ink.clip();
    for (let i = 1; i < 4; ++i) {
      ink.strokeStyle = ink.fillStyle = colour(`--omega-${i}`);
      ink.lineWidth = 1.4;
      this.#curve(ink, i, {first, last, x_of, y_of});
    }
    ink.restore();
    if (this.has_legend) this.#legend(ink, colour);
  }

  /** @param {{x_of: (t: number) => number, y_of: (w: number) => number, most: number, colour: (name: string) => string, ink: CanvasRenderingContext2D}} place */
  #axes({x_of, y_of, most, colour, ink}) {
    const {left, right, top, bottom} = this.box;
    const {from_s, to_s} = /** @type {OmegaPlot} */ (this.plot);
    ink.font = '12px system-ui, sans-serif';
    ink.strokeStyle = colour('--rule');
    ink.fillStyle = getComputedStyle(this.canvas).color;
    ink.lineWidth = 1;
    ink.textBaseline = 'middle';
    ink.textAlign = 'right';
    const line = (/** @type {number[]} */ [x0 = 0, y0 = 0, x1 = 0, y1 = 0]) => {
      ink.beginPath();
      ink.moveTo(x0, y0);
      ink.lineTo(x1, y1);
      ink.stroke();
    };
    const y_step = round_step(2 * most, Math.max(4.6, (bottom - top) / 26));
    for (let k = Math.ceil(-most / y_step); k * y_step <= most; ++k) {
      const y = Math.round(y_of(k * y_step)) + 0.5;
      line([left, y, right, y]);
      ink.fillText(String(Number((k * y_step).toPrecision(6))).replace('-', '−'), left - 5, y);
    }
    ink.textBaseline = 'top';
    ink.textAlign = 'center';
    const x_step = round_step(to_s - from_s, Math.max(2, (right - left) / 66));
    for (let k = Math.ceil(from_s / x_step); k * x_step <= to_s; ++k) {
      const x = Math.round(x_of(k * x_step)) + 0.5;
      line([x, bottom, x, bottom + 4]);
      const text = `${Number((k * x_step).toPrecision(9))} s`;
      const half = ink.measureText(text).width / 2;
      ink.fillText(text, Math.min(Math.max(x, half), this.canvas.clientWidth - half), bottom + 6);
    }
  }

  /** @param {CanvasRenderingContext2D} ink @param {number} i @param {{first: number, last: number, x_of: (t: number) => number, y_of: (w: number) => number}} place */
  #curve(ink, i, {first, last, x_of, y_of}) {
    const {rows} = /** @type {OmegaPlot} */ (this.plot);
    const {left, right} = this.box;
    const n = last - first;
    const typical_s = ((rows[4 * (last - 1)] ?? 0) - (rows[4 * first] ?? 0)) / Math.max(1, n - 1);
    const is_dense = n > 2 * (right - left);
    const has_dots = n < (right - left) / 6;
    ink.beginPath();
    let column = NaN;
    let [low, high] = [0, 0];
    for (let k = first; k < last; ++k) {
      const x = x_of(rows[4 * k] ?? 0);
      const y = y_of(rows[4 * k + i] ?? 0);
      if (is_dense) {
        // All rows of a column of pixels as one stroke.
        if (Math.floor(x) !== column) {
          if (k > first) ink.lineTo(column, low);
          if (k > first) ink.lineTo(column, high);
          column = Math.floor(x);
          [low, high] = [y, y];
        }
        low = Math.min(low, y);
        high = Math.max(high, y);
      } else if (k > first && (rows[4 * k] ?? 0) - (rows[4 * (k - 1)] ?? 0) < 5 * typical_s) ink.lineTo(x, y);
      else ink.moveTo(x, y);
    }
    ink.stroke();
    if (!has_dots) return;
    for (let k = first; k < last; ++k) {
      ink.beginPath();
      ink.arc(x_of(rows[4 * k] ?? 0), y_of(rows[4 * k + i] ?? 0), 2.2, 0, 7);
      ink.fill();
    }
  }

  /** @param {CanvasRenderingContext2D} ink @param {(name: string) => string} colour */
  #legend(ink, colour) {
    const {right, top} = this.box;
    const middle = top - 14;
    ink.textBaseline = 'alphabetic';
    ink.textAlign = 'left';
    let x = right - 152;
    ['x', 'y', 'z'].forEach((axis, i) => {
      ink.fillStyle = colour(`--omega-${i + 1}`);
      ink.fillRect(x, middle, 12, 2.5);
      ink.font = 'italic 14px Georgia, "DejaVu Serif", serif';
      ink.fillText('ω', x + 15, middle + 5);
      ink.font = 'italic 11px Georgia, "DejaVu Serif", serif';
      ink.fillText(axis, x + 25, middle + 8);
      x += 37;
    });
    ink.font = '12px system-ui, sans-serif';
    ink.fillStyle = getComputedStyle(this.canvas).color;
    ink.fillText('rad/s', x + 2, middle + 5);
  }
}
