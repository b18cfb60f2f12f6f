// A question as a link: the gradation's bytes and the options are in its fragment, which no browser sends anywhere.

const LONGEST = 60_000;

const encoder = new TextEncoder();
const decoder = new TextDecoder();

function toBase64Url(bytes) {
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

function fromBase64Url(text) {
  const plain = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(plain, (character) => character.charCodeAt(0));
}

/** The bytes as a stream makes them; what is wrong with them is said by what is read, not by what is written. */
async function through({ readable, writable }, bytes) {
  const writer = writable.getWriter();
  writer.write(bytes).catch(() => {});
  writer.close().catch(() => {});
  writer.closed.catch(() => {});
  return new Uint8Array(await new Response(readable).arrayBuffer());
}

/** The fragment, without #, of {name, options} and the gradation; null if it would be too long for a link. */
export async function fragmentOf({ name, options, bytes }) {
  if (bytes.length > 50 * LONGEST) return null;
  const head = encoder.encode(JSON.stringify({ name, options }) + "\n");
  const whole = new Uint8Array(head.length + bytes.length);
  whole.set(head);
  whole.set(bytes, head.length);
  const fragment =
    typeof CompressionStream === "undefined"
      ? "p=" + toBase64Url(whole)
      : "q=" + toBase64Url(await through(new CompressionStream("deflate-raw"), whole));
  return fragment.length <= LONGEST ? fragment : null;
}

/** The question of a fragment; null if it has none. */
export async function questionOf(fragment) {
  const [kind, text] = [fragment.slice(0, 2), fragment.slice(2)];
  if (kind !== "q=" && kind !== "p=") return null;
  const data = fromBase64Url(text);
  const whole = kind === "q=" ? await through(new DecompressionStream("deflate-raw"), data) : data;
  const end = whole.indexOf(10);
  const { name, options } = JSON.parse(decoder.decode(whole.subarray(0, end)));
  return { name: String(name), options, bytes: whole.subarray(end + 1) };
}
