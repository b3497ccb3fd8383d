import userEvent, { type UserEvent } from '@testing-library/user-event';
import { type Download, Downloads } from './downloads.ts';
import { press, type } from './keys.ts';
import { drawn, Locator } from './locator.ts';
import { Tab } from './tab.ts';
import { DrawnWindow } from './window.ts';

const ORIGIN = 'http://127.0.0.1:43951/';

/** As much of Playwright's page as the tests use: the page, drawn in this process. */
export class Page {
  #tab: Tab | undefined;
  #window: DrawnWindow | undefined;
  #user: UserEvent | undefined;
  readonly downloads = new Downloads();
  readonly complaints: string[] = [];
  readonly #scripts: (() => void)[] = [];
  readonly locale: string;

  constructor(locale = 'en-US') {
    this.locale = locale;
  }

  readonly #all = new Locator(() => this.user);
  readonly getByRole = this.#all.getByRole.bind(this.#all);
  readonly getByLabel = this.#all.getByLabel.bind(this.#all);
  readonly getByText = this.#all.getByText.bind(this.#all);
  readonly getByTitle = this.#all.getByTitle.bind(this.#all);
  readonly getByPlaceholder = this.#all.getByPlaceholder.bind(this.#all);
  readonly locator = this.#all.locator.bind(this.#all);

  get user(): UserEvent {
    if (!this.#user) throw new Error('The page is not open: goto() comes first');
    return this.#user;
  }

  async goto(address: string): Promise<void> {
    const tab = this.#tab;
    const next = new URL(address, ORIGIN);
    if (!tab) this.#tab = new Tab(next, () => void this.reload());
    else if (next.hash !== '' && next.pathname === tab.url.pathname && next.search === tab.url.search) {
      tab.goToHash(next.hash);
      return drawn();
    } else {
      // What the page before still says of its address is said of its own.
      await this.#window?.close();
      this.#window = undefined;
      tab.load(next);
    }
    if (next.protocol !== 'about:') await this.#load();
  }

  async reload(): Promise<void> {
    await this.#load();
  }

  async #load(): Promise<void> {
    if (!this.#tab) throw new Error('The page is not open: goto() comes first');
    await this.#window?.close();
    this.#window = new DrawnWindow(this.#tab, this);
    this.#user = userEvent.setup({ delay: null, pointerEventsCheck: 0, document });
    for (const script of this.#scripts) script();
    this.#window.run();
    await drawn();
  }

  async addInitScript<Given>(script: (given: Given) => void, given?: Given): Promise<void> {
    this.#scripts.push(() => script(given as Given));
  }

  async goBack(): Promise<void> {
    history.back();
    await drawn();
  }

  async goForward(): Promise<void> {
    history.forward();
    await drawn();
  }

  url(): string {
    return location.href;
  }

  async title(): Promise<string> {
    return document.title;
  }

  readonly keyboard = {
    press: async (keys: string) => {
      await press(this.user, keys);
      await drawn();
    },
    type: async (text: string) => {
      await type(this.user, text);
      await drawn();
    },
    insertText: async (text: string) => {
      await type(this.user, text);
      await drawn();
    },
  };

  async evaluate<Result, Given>(run: (given: Given) => Result, given?: Given): Promise<Result> {
    const result = await run(given as Given);
    await drawn();
    return result;
  }

  async setViewportSize(size: { width: number; height: number }): Promise<void> {
    this.#window?.window.happyDOM.setViewport(size);
    await drawn();
  }

  async waitForEvent(event: 'download'): Promise<Download> {
    if (event !== 'download') throw new TypeError(`not told here: ${event}`);
    return this.downloads.next();
  }

  async close(): Promise<void> {
    await this.#window?.close();
    this.#window = undefined;
    this.downloads.clear();
  }

  toString(): string {
    return 'page';
  }
}
