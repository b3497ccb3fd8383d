// Unpacks the script of the one file and runs it. Workers are started from the same address.
(async () => {
  const packed = atob(document.getElementById('packed').textContent);
  const bytes = Uint8Array.from(packed, (character) => character.charCodeAt(0));
  const script = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  const blob = await new Response(script, { headers: { 'content-type': 'text/javascript' } }).blob();
  const address = URL.createObjectURL(blob);
  const policy = globalThis.trustedTypes?.createPolicy('framewright', {
    createScriptURL(asked) {
      if (asked === address) return asked;
      throw new TypeError(`No script of this page: ${asked}`);
    },
  });
  globalThis.framewrightScript = policy?.createScriptURL(address) ?? address;
  const element = document.createElement('script');
  element.src = globalThis.framewrightScript;
  document.head.append(element);
})();
