// Work of which only the latest request matters.

/** Runs a job again while requests come in; a run that is outdated is ended when it has had its time. */
export class Latest {
  #job;
  #stop;
  #patience;
  #onChange;
  #isRunning = false;
  #isOutdated = false;
  #since = 0;
  #timer = null;

  /**
   * `job(isOutdated)` gives a promise that never fails; `stop()` ends it; `patience` is in milliseconds; `onChange()`
   * is told when work begins and when all of it is done.
   */
  constructor({ job, stop, patience, onChange }) {
    this.#job = job;
    this.#stop = stop;
    this.#patience = patience;
    this.#onChange = onChange;
  }

  get isRunning() {
    return this.#isRunning;
  }

  request() {
    if (!this.#isRunning) return void this.#run();
    this.#isOutdated = true;
    const left = this.#since + this.#patience - performance.now();
    this.#timer ??= setTimeout(this.#stop, Math.max(0, left));
  }

  async #run() {
    this.#isRunning = true;
    this.#onChange();
    do {
      this.#isOutdated = false;
      this.#since = performance.now();
      await this.#job(() => this.#isOutdated);
      clearTimeout(this.#timer);
      this.#timer = null;
    } while (this.#isOutdated);
    this.#isRunning = false;
    this.#onChange();
  }
}
