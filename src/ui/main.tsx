// First, since it names the layers of all style sheets in their order.
import './kit/kit.css';
import { effect } from '@preact/signals';
import { render } from 'preact';
import { languages, languageTag, Vocabulary } from '../words/index.ts';
import { App } from './app.tsx';
import { listenForKeys } from './parts/commands.ts';
import { linkLights } from './parts/lit.ts';
import { keepOffline } from './parts/offline/offline.ts';
import { takePastedText } from './parts/pasted.ts';
import { page } from './parts/store.ts';
import { showTheme } from './parts/theme.ts';
import { openWords } from './views.tsx';

const take = () => page.address.take();
addEventListener('popstate', take);
addEventListener('hashchange', take);
addEventListener('pagehide', () => page.address.now());
effect(() => showTheme(document.documentElement));
// A script or a style that did not come: WebKit does not ask for it again, even after a reload, until it is fetched as data.
addEventListener(
  'error',
  ({ target }) => target instanceof HTMLLinkElement && fetch(target.href).catch(() => {}),
  true,
);
listenForKeys();
takePastedText();

/** Draws the page as soon as its words have come. */
async function draw(root: HTMLElement): Promise<Vocabulary> {
  const tag = languageTag(navigator.languages);
  const vocabulary = new Vocabulary(languages[tag]);
  // Those of the view come beside those of the page; if they do not, its place says so.
  vocabulary.load(...openWords()).catch(() => undefined);
  await vocabulary.load('page');
  document.documentElement.lang = tag;
  // What the page says while its script is on its way.
  root.replaceChildren();
  linkLights(root);
  render(<App vocabulary={vocabulary} />, root);
  return vocabulary;
}

/** Has the browser keep the page for offline use, once it can be used. */
function keepLater(vocabulary: Vocabulary): void {
  if (import.meta.env.PROD) setTimeout(() => keepOffline(vocabulary), 2000);
}

/** Shows what the page has in plain HTML for this. */
function missWords(root: HTMLElement, error: unknown): never {
  for (const paragraph of root.children) paragraph.toggleAttribute('hidden');
  root.querySelector('button')?.addEventListener('click', () => location.reload());
  throw error;
}

const root = document.getElementById('app');
// Nothing is waited for here: the chunks of the words import this one, and would wait for it in turn.
if (root) draw(root).then(keepLater, (error) => missWords(root, error));
