// A program of the command line as WebAssembly: words and files in, what it prints and writes out.

const folder = "/files";

/** Bytes that come one by one. */
class Bytes {
  #bytes = new Uint8Array(1024);
  #length = 0;

  add(byte) {
    if (this.#length === this.#bytes.length) {
      const longer = new Uint8Array(2 * this.#length);
      longer.set(this.#bytes);
      this.#bytes = longer;
    }
    this.#bytes[this.#length++] = byte;
  }
  text() {
    return new TextDecoder().decode(this.#bytes.subarray(0, this.#length));
  }
}

/** The files below a folder, by their paths from it. */
function filesBelow(FS, path, prefix = "", found = {}) {
  for (const name of FS.readdir(path)) {
    if (name === "." || name === "..") continue;
    const full = `${path}/${name}`;
    if (FS.isDir(FS.stat(full).mode)) filesBelow(FS, full, `${prefix}${name}/`, found);
    else found[prefix + name] = FS.readFile(full);
  }
  return found;
}

/** What is told of a run that ended on the spot, without the program's own words. */
function endMessage(error) {
  const isMemory = /memory|allocat/i.test(String(error?.message));
  return isMemory || error instanceof RangeError
    ? "out of memory: use mdm of the command line, or ask for fewer particles, steps or digits\n"
    : `internal error, please report it: ${error}\n`;
}

/**
 * Makes a program ready to be run.
 * @param {{glue: Function, wasm: Uint8Array | WebAssembly.Module}} source what Emscripten made of it
 */
export async function loadProgram({ glue, wasm }) {
  const module = wasm instanceof WebAssembly.Module ? wasm : await WebAssembly.compile(wasm);

  /**
   * Runs the program once, in a fresh instance: nothing is left of the runs before. Blocks its thread.
   * @param {string[]} words the command line, without the program's name
   * @param {Object<string, Uint8Array>} files those that are there before, by name
   * @param {(bounds: {least: string, particles: string | null}) => void} [onProgress] called now and then during a search
   * @param {Object<string, string>} [environment] variables of the environment
   * @returns {Promise<{code: number, out: string, err: string, files: Object<string, Uint8Array>}>} exit code, standard
   * output and error, and the files that were written
   */
  async function run(words, files = {}, onProgress, environment = {}) {
    const out = new Bytes();
    const err = new Bytes();
    const instance = await glue({
      instantiateWasm(imports, done) {
        WebAssembly.instantiate(module, imports).then(done);
        return {};
      },
      preRun: [
        ({ FS, ENV }) => {
          FS.init(() => null, (byte) => out.add(byte), (byte) => err.add(byte));
          if (ENV) Object.assign(ENV, environment);
        },
      ],
      onProgress: onProgress && ((least, particles) => onProgress({ least, particles: particles || null })),
    });
    const { FS } = instance;
    FS.mkdir(folder);
    FS.chdir(folder);
    for (const [name, bytes] of Object.entries(files)) FS.writeFile(`${folder}/${name}`, bytes);
    let code = 2;
    let end = "";
    try {
      code = instance.callMain(words);
    } catch (error) {
      end = endMessage(error);
    }
    const written = filesBelow(FS, folder);
    for (const name of Object.keys(files)) delete written[name];
    return { code, out: out.text(), err: err.text() + end, files: written };
  }

  return { run };
}
