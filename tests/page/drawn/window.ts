import { readFileSync } from 'node:fs';
import { Script } from 'node:vm';
import { IDBObjectStore } from 'fake-indexeddb';
import { HTMLAnchorElement as Anchor, Node as Base, GlobalWindow, PropertySymbol, type Window } from 'happy-dom';
import { populateGlobal } from 'vitest/runtime';
import { type PageFile, pages, scriptOf } from './built.ts';
import { addCanvas } from './canvas.ts';
import { addDialogs } from './dialogs.ts';
import type { Downloads } from './downloads.ts';
import { completeFields } from './fields.ts';
import { addPopovers } from './popovers.ts';
import { addSizes } from './sizes.ts';
import type { Tab } from './tab.ts';
import { addTransfers } from './transfer.ts';
import { isElementVisible, isHiddenItself } from './visible.ts';
import { DrawnWorker } from './worker.ts';

const bodyOf = (file: PageFile) => /<body>([\s\S]*)<\/body>/.exec(readFileSync(file, 'utf8'))?.[1] ?? '';

const pageAt = ({ pathname }: URL): PageFile | undefined =>
  pathname === '/' ? 'index.html' : (Object.keys(pages) as PageFile[]).find((file) => pathname === `/${file}`);

/** Scripts that have run before: they are read once. */
const scripts = new Map<PageFile, Script>();

function scriptIn(file: PageFile): Script {
  const path = scriptOf(file);
  const script = scripts.get(file) ?? new Script(readFileSync(path, 'utf8'), { filename: path });
  scripts.set(file, script);
  return script;
}

/** The names that the window before has in the global object, and what had them before. */
let keys: ReadonlySet<string> = new Set();
let originals: ReadonlyMap<string | symbol, unknown> = new Map();

/** Keeps something in the global object until the next window. */
const put = (name: string | symbol, value: unknown) =>
  Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });

/** What Node has itself, and can be sent to a thread. */
const { Blob, BroadcastChannel, File, URL, MessageChannel, MessagePort, TextEncoder, TextDecoder } = globalThis;
const ofNode = { Blob, File, URL, MessageChannel, MessagePort, TextEncoder, TextDecoder };

/** What a page may change of its databases, until the next. */
const ofStore = Object.getOwnPropertyDescriptors(IDBObjectStore.prototype);

/** Windows have their classes in common. */
const { click } = Anchor.prototype;

const { setTimeout: later, setInterval: every, clearTimeout: cancel } = globalThis;

const { connectedToNode, isConnected, ownerDocument, parentNode } = PropertySymbol;

/** What a node takes over from the one that it stands in. */
const inherited = [
  PropertySymbol.formNode,
  PropertySymbol.selectNode,
  PropertySymbol.styleNode,
  PropertySymbol.textAreaNode,
];

type Fields = Record<symbol, unknown>;
const joined = Base.prototype as unknown as Record<symbol, () => void>;
const join = joined[connectedToNode];

// A tree that is built before it is in the document would be walked whenever it grows, with nothing to take over.
joined[connectedToNode] = function (this: Fields) {
  const parent = this[parentNode] as Fields | null;
  const isApart = parent && !parent[isConnected] && !this[isConnected] && parent[ownerDocument] === this[ownerDocument];
  if (!isApart || inherited.some((name) => parent[name])) join?.call(this);
};

/** What stays when a page is loaded again. */
export interface Around {
  readonly downloads: Downloads;
  readonly locale: string;
  /** What the page complains of. */
  readonly complaints: string[];
}

/** The window that the page is drawn in: everything a script finds in one stands in the global object until the next. */
export class DrawnWindow {
  readonly window: Window;
  readonly #file: PageFile | undefined;
  readonly #timers = new Set<NodeJS.Timeout>();
  readonly #channels = new Set<BroadcastChannel>();

  constructor(tab: Tab, { downloads, locale, complaints }: Around) {
    // What a window before this one left would not be replaced.
    for (const key of keys) Reflect.deleteProperty(globalThis, key);
    for (const [name, value] of originals) put(name, value);
    this.window = new GlobalWindow({ url: tab.url.href, width: 1280, height: 720 });
    ({ keys, originals } = populateGlobal(globalThis, this.window, { bindFunctions: true }));
    Object.assign(globalThis, ofNode);
    Object.defineProperties(IDBObjectStore.prototype, ofStore);
    const channels = this.#channels;
    const own = {
      history: tab.history,
      location: tab.location,
      indexedDB: tab.databases,
      IDBObjectStore,
      BroadcastChannel: class extends BroadcastChannel {
        constructor(name: string) {
          super(name);
          channels.add(this);
        }

        override postMessage(message: unknown): void {
          if (channels.has(this)) super.postMessage(message);
        }
      },
      localStorage: tab.storage,
      sessionStorage: tab.session,
      Worker: DrawnWorker,
      isSecureContext: true,
      reportError: (error: unknown) => complaints.push(`thrown: ${error}`),
    };
    for (const [name, value] of Object.entries(own)) put(name, value);
    // A link within the page is a step of the tab.
    this.window.addEventListener('click', (event) => {
      const link = (event.target as unknown as Element | null)?.closest?.('a[href]');
      if (event.defaultPrevented || !link) return;
      event.preventDefault();
      if (link.hasAttribute('download')) return downloads.take(link);
      const to = new URL(link.getAttribute('href') ?? '', tab.url);
      if (to.pathname === tab.url.pathname) tab.goToHash(to.hash);
    });
    completeFields(this.window);
    addTransfers(this.window);
    // Timers of a page end with it.
    const kept = (start: typeof later) =>
      ((act: () => void, ...rest: unknown[]) => {
        const timer = start(act, ...(rest as [number]));
        this.#timers.add(timer);
        return timer;
      }) as typeof later;
    globalThis.setTimeout = kept(later);
    globalThis.setInterval = kept(every as typeof later) as typeof every;
    globalThis.getComputedStyle = styleOf as unknown as typeof getComputedStyle;
    Element.prototype.checkVisibility = function () {
      return isElementVisible(this);
    };
    Object.defineProperty(navigator, 'languages', { value: [locale], configurable: true });
    // As in a browser that has Web Serial, where no port was allowed yet.
    const serial = Object.assign(new EventTarget(), { getPorts: async () => [] });
    Object.defineProperty(Navigator.prototype, 'serial', { get: () => serial, configurable: true });
    Object.defineProperty(Navigator.prototype, 'locks', { get: () => DrawnWorker.locks, configurable: true });
    addPopovers(this.window);
    addSizes(this.window);
    addDialogs();
    addCanvas();
    // An id that begins with a digit, as CSS.escape writes it, is not found there; and every id is found by a walk.
    const find = document.querySelector.bind(document);
    document.querySelector = ((selector: string) => {
      const [, digit = '', rest = ''] = /^#(?:\\3(\d) )?([\w-]*)$/.exec(selector) ?? [];
      return digit + rest === '' ? find(selector) : document.getElementById(digit + rest);
    }) as typeof find;
    HTMLAnchorElement.prototype.click = function () {
      // One that is not in the document is not heard of there.
      if (!this.isConnected && this.hasAttribute('download')) downloads.take(this);
      else click.call(this as never);
    };
    this.#file = pageAt(tab.url);
    document.body.innerHTML = this.#file ? bodyOf(this.#file) : '';
    downloads.listen();
  }

  /** Runs the page's script, as after a load. */
  run(): void {
    if (this.#file) scriptIn(this.#file).runInThisContext();
  }

  async close(): Promise<void> {
    this.window.dispatchEvent(new this.window.Event('pagehide'));
    (globalThis as { endPage?: () => void }).endPage?.();
    for (const timer of this.#timers) cancel(timer);
    for (const channel of this.#channels) channel.close();
    this.#channels.clear();
    globalThis.setTimeout = later;
    globalThis.setInterval = every;
    await DrawnWorker.endAll();
    await this.window.happyDOM.close();
  }
}

/** As much of an element's style as tells whether it is shown: the page's own styles are not read here. */
const styleOf = (element: Element) => ({
  get display() {
    return isHiddenItself(element) ? 'none' : 'block';
  },
  visibility: 'visible',
  content: '',
  getPropertyValue: () => '',
});
