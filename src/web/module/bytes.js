const addresses = {
  "mdm.wasm": new URL("./mdm.wasm", import.meta.url),
  "mdm-check.wasm": new URL("./mdm-check.wasm", import.meta.url),
};

/** The bytes of a file beside this one, where a bundler has put it. */
export async function bytesOf(name) {
  return new Uint8Array(await (await fetch(addresses[name])).arrayBuffer());
}
