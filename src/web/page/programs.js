// The programs behind the page, each in a worker. The page never waits for one: what is asked becomes a promise.

/** The request was ended by stop(). */
export class Stopped extends Error {}

/** A program in a worker that can be ended at any moment; then a fresh one is at hand. */
export class Program {
  #start;
  #worker = null;
  #spare = null;
  #running = null;
  #queue = Promise.resolve();
  #requests = 0;

  /** `script` is the worker's source, `data` its first message. */
  constructor(script, data) {
    const url = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
    this.#start = () => {
      const worker = new Worker(url);
      worker.postMessage(data);
      return worker;
    };
  }

  /** Starts a worker ahead of its first use. */
  warmUp() {
    if (this.#worker === null) this.#worker = this.#start();
    else if (this.#spare === null) this.#spare = this.#start();
  }

  /**
   * Runs the program's command line. `files` maps names to Blobs. Requests wait for those before them. The promise
   * gives {code, out, err, files}, with Blobs again, or fails with Stopped.
   */
  run(argv, files, onProgress = () => {}) {
    return this.ask({ argv, files }, onProgress).then((result) => {
      const written = {};
      for (const [name, bytes] of Object.entries(result.files)) written[name] = new Blob([bytes]);
      return { ...result, files: written };
    });
  }

  /** Sends a message to the worker; the promise gives its result as it came. */
  ask(message, onProgress = () => {}) {
    const result = this.#queue.then(() => this.#answer(message, onProgress));
    this.#queue = result.catch(() => {});
    return result;
  }

  /** Ends the request that runs, if one does. */
  stop() {
    if (this.#running === null) return;
    this.#worker.terminate();
    this.#worker = this.#spare;
    this.#spare = null;
    this.#running.reject(new Stopped());
    this.#running = null;
  }

  #answer(message, onProgress) {
    return new Promise((resolve, reject) => {
      this.#worker ??= this.#start();
      const worker = this.#worker;
      const id = ++this.#requests;
      this.#running = { reject };
      const fail = (text) => {
        worker.terminate();
        this.#worker = null;
        this.#running = null;
        reject(new Error(text));
      };
      worker.onerror = (event) => fail(event.message);
      worker.onmessage = ({ data }) => {
        if (data.id !== id) return;
        if (data.progress !== undefined) return onProgress(data.progress);
        if (data.failure !== undefined) return fail(data.failure);
        this.#running = null;
        resolve(data.result);
      };
      worker.postMessage({ id, ...message });
    });
  }
}
