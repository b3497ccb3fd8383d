// Keeps the page, so that it works offline. The build puts `files` in front: each file's address and the SHA-256 of what is
// in it, in hexadecimal digits; and `version`, another name for other files.

const PREFIX = 'framewright-files-';
const SHARED = 'framewright-shared';
const own = PREFIX + version;

addEventListener('install', (event) => event.waitUntil(keepAll()));
addEventListener('activate', (event) => event.waitUntil(forgetOld().then(() => clients.claim())));
addEventListener('message', (event) => event.data === 'change' && event.waitUntil(skipWaiting()));

addEventListener('fetch', (event) => {
  const { method, url } = event.request;
  const folder = registration.scope;
  if (!url.startsWith(folder)) return;
  const path = url.slice(folder.length).replace(/[?#].*$/, '');
  if (method === 'GET') event.respondWith(answer(path === 'index.html' ? './' : `./${path}`, event.request));
  else if (method === 'POST' && path === 'share') event.respondWith(takeShared(event.request));
});

/** All files or none: a version of which a file is missing, cut or another one is not kept. */
async function keepAll() {
  const cache = await caches.open(own);
  const waiting = [...files];
  const keepSome = async () => {
    for (let file = waiting.shift(); file; file = waiting.shift()) await cache.put(file[0], await soundCopy(...file));
  };
  try {
    // A few at a time: the page may be loading something, too.
    await Promise.all([keepSome(), keepSome(), keepSome(), keepSome()]);
  } catch (error) {
    await caches.delete(own);
    throw error;
  }
}

/** A file as the version before it has it, or as it is served. */
async function soundCopy(path, hash) {
  for (const get of [() => caches.match(path), () => fetch(path, { cache: 'no-cache' })]) {
    const response = await get();
    if (!response?.ok) continue;
    const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', await response.clone().arrayBuffer()));
    if (hash === Array.from(digest, (byte) => byte.toString(16).padStart(2, '0')).join('')) return response;
  }
  throw new Error(`${path} is not what it was when the page was built.`);
}

/** Forgets all versions but this one and the one before it, which other windows may still show. */
async function forgetOld() {
  const kept = (await caches.keys()).filter((name) => name.startsWith(PREFIX) && name !== own);
  await Promise.all(kept.slice(0, -1).map((name) => caches.delete(name)));
}

async function answer(path, request) {
  const cache = await caches.open(own);
  return (await cache.match(path)) ?? (await caches.match(path)) ?? fetch(request);
}

/** What another program shares comes here and no further; the page that is opened takes it from the browser. */
async function takeShared(request) {
  const form = await request.formData();
  const file = form.get('file');
  const texts = ['title', 'text', 'url'].map((name) => form.get(name)).filter(Boolean);
  const what = file instanceof File ? file : texts.join('\n');
  const cache = await caches.open(SHARED);
  await cache.put('./shared', new Response(what, { headers: { name: encodeURIComponent(what.name ?? '') } }));
  return Response.redirect('./?shared', 303);
}
