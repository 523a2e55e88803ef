// What a recording does for one who does not look at the phone: the screen stays awake, and its begin and end are felt and heard.

export class RecordSignals {
  /** Call it from a press: browsers let pages sound and stay awake after one. */
  constructor() {
    /** @type {AudioContext|null} */
    this.sound = null;
    /** @type {Promise<{release: () => Promise<void>}|null>|null} */
    this.lock = null;
    try {
      this.sound = new AudioContext();
      void this.sound.resume();
    } catch {
      // The browser has no sound.
    }
    this.#stay_awake();
    this.seen = () => {
      // A page that was away has lost it.
      if (document.visibilityState === 'visible') this.#stay_awake();
    };
    document.addEventListener('visibilitychange', this.seen);
  }

  #stay_awake() {
    const {wakeLock} = /** @type {any} */ (navigator);
    this.lock = wakeLock ? wakeLock.request('screen').catch(() => null) : null;
  }

  /** The first row is there: throw. */
  begun() {
    navigator.vibrate?.(150);
    this.#tone(660, 0);
  }

  /** The recording has ended. @param {boolean} is_heard false: it never began */
  ended(is_heard) {
    document.removeEventListener('visibilitychange', this.seen);
    void this.lock?.then((lock) => lock?.release());
    if (is_heard) {
      navigator.vibrate?.([120, 80, 120]);
      this.#tone(660, 0);
      this.#tone(990, 0.18);
    }
    const {sound} = this;
    if (sound) window.setTimeout(() => void sound.close().catch(() => {}), 1000);
  }

  /** @param {number} frequency_Hz @param {number} after_s */
  #tone(frequency_Hz, after_s) {
    const {sound} = this;
    if (!sound) return;
    const [source, volume] = [sound.createOscillator(), sound.createGain()];
    const from_s = sound.currentTime + after_s;
    source.frequency.value = frequency_Hz;
    // Without clicks.
    volume.gain.setValueAtTime(0.0001, from_s);
    volume.gain.exponentialRampToValueAtTime(0.3, from_s + 0.02);
    volume.gain.exponentialRampToValueAtTime(0.0001, from_s + 0.15);
    source.connect(volume).connect(sound.destination);
    source.start(from_s);
    source.stop(from_s + 0.16);
  }
}
