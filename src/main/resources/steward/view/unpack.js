// What is packed in the page: gzip in base64.

/** The text that an element of the page holds packed. */
export async function unpacked(source) {
  const bytes = Uint8Array.from(atob(source.textContent.trim()), letter => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).text();
}

/** Runs the library of charts, uPlot; the policy of the page names it by its hash. */
export async function loadLibrary() {
  const script = document.createElement('script');
  script.textContent = await unpacked(document.getElementById('library'));
  document.head.append(script);
}
