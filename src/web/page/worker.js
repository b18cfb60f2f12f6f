// What the workers of the page share: a worker is started once and then answers one request after the other.

/**
 * Serves a program that `start(data)` makes of the first message's data. A request {id, argv, files} is answered by
 * {id, result}, and before by any number of {id, progress}; `files` has Blobs, the result's files Uint8Arrays.
 */
export function serveProgram(start) {
  let program;
  self.onmessage = async ({ data }) => {
    if (program === undefined) {
      program = start(data);
      program.catch(() => {});
      return;
    }
    const { id, argv, files } = data;
    try {
      const bytes = {};
      for (const [name, blob] of Object.entries(files)) bytes[name] = new Uint8Array(await blob.arrayBuffer());
      const result = await (await program).run(argv, bytes, (progress) => self.postMessage({ id, progress }));
      self.postMessage(
        { id, result },
        Object.values(result.files).map((file) => file.buffer),
      );
    } catch (error) {
      self.postMessage({ id, failure: String(error) });
    }
  };
}

/** The bytes of gzip data that is written in base64. */
export async function unpacked(base64) {
  const packed = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
