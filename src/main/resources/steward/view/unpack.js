// What is packed in the page: gzip in base64.

/** The bytes that an element of the page holds packed. */
export async function unpackedBytes(source) {
  const letters = atob(source.textContent.trim());
  const bytes = new Uint8Array(letters.length);
  for (let k = 0; k < letters.length; k++) bytes[k] = letters.charCodeAt(k);
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer());
}

/** The text that an element of the page holds packed. */
export async function unpacked(source) {
  return new TextDecoder().decode(await unpackedBytes(source));
}

/** Runs the library of charts, uPlot; the policy of the page names it by its hash. */
export async function loadLibrary() {
  const script = document.createElement('script');
  script.textContent = await unpacked(document.getElementById('library'));
  document.head.append(script);
}
