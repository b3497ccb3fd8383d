import type { Key, Tab } from './tab.ts';

/** Roles that the steps name, with what has them. */
export type Role =
  | 'button'
  | 'link'
  | 'tab'
  | 'field'
  | 'heading'
  | 'region'
  | 'listbox'
  | 'option'
  | 'row'
  | 'status'
  | 'main'
  | 'list';

/** How long the page may take for anything, on a machine with other work to do. */
const PATIENCE = 20_000;

/**
 * Ten verbs, by role and label, that mean the same in every browser: `open`, `click`, `fill`, `press`, `paste`, `attach`,
 * `read`, `sees`, `reload`, `back`.
 */
export class Driver {
  private readonly tab: Tab;
  private readonly base: string;

  constructor(tab: Tab, base: string) {
    this.tab = tab;
    this.base = base;
  }

  /** Opens the page at a fragment: as a new page, so that nothing is left of the one before but what is stored. */
  async open(hash = '', base = this.base): Promise<void> {
    await this.tab.goto('about:blank');
    await this.tab.goto(`${base}${hash}`);
    await this.tab.run(listen);
    await this.settled();
  }

  async click(role: Role, name: string | RegExp): Promise<void> {
    await this.found(role, name);
    await this.tab.click('[data-driven]');
  }

  /** Types a text into a field in place of what it has, or chooses the option of a list. */
  async fill(name: string | RegExp, text: string): Promise<void> {
    await this.found('field', name);
    if (await this.tab.run(chooseOption, text)) return;
    await this.tab.click('[data-driven]');
    await this.tab.run(selectAll);
    await this.tab.type(text);
  }

  press(key: Key): Promise<void> {
    return this.tab.press(key);
  }

  paste(text: string): Promise<void> {
    return this.tab.run(pasteInto, text);
  }

  async attach(name: string | RegExp, path: string): Promise<void> {
    await this.found('field', name);
    await this.tab.attach('[data-driven]', path);
  }

  /** What a thing says: its text, or what a field holds. */
  async read(role: Role, name?: string | RegExp): Promise<string> {
    await this.found(role, name);
    return this.tab.run(textOf);
  }

  /** Waits until a thing says so. */
  async sees(role: Role, name: string | RegExp | undefined, text: string | RegExp): Promise<void> {
    const says = (said: string | undefined) =>
      said !== undefined && (typeof text === 'string' ? said.includes(text) : text.test(said));
    await until(
      async () => ((await this.tab.run(find, role, pattern(name))) ? this.tab.run(textOf) : undefined),
      says,
      (last) => `${role} ${name ?? ''} does not say ${text}, but ${last?.slice(0, 300)}`,
    );
  }

  /** Loads the page again, after a person's moment: what is typed comes into the address a little later. */
  async reload(): Promise<void> {
    await this.settled();
    await this.tab.reload();
    await this.tab.run(listen);
    await this.settled();
  }

  back(): Promise<void> {
    return this.tab.back();
  }

  /** What the page has complained of since it was opened. */
  complaints(): Promise<readonly string[]> {
    return this.tab.run(() => (window as unknown as { complaints?: string[] }).complaints ?? []);
  }

  /** Runs a question in the page that no person asks: what the browser can do, how wide the page is. */
  ask<T>(question: () => T): Promise<T> {
    return this.tab.run(question);
  }

  /** Waits until a question that no person asks is answered with yes. */
  until(what: string, question: () => boolean): Promise<void> {
    return until(
      () => this.tab.run(question),
      Boolean,
      () => `In vain: ${what}.`,
    );
  }

  /** Waits until the page has come with its parts, and says the same for a while. */
  private async settled(): Promise<void> {
    let [said, same] = ['', 0];
    await until(
      async () => {
        await this.tab.run(find, 'main', null);
        const now = await this.tab.run(textOf);
        same = now !== '' && now === said ? same + 1 : 0;
        said = now;
        return same;
      },
      (times) => times >= 4,
      () => 'The page does not come to rest.',
    );
  }

  private async found(role: Role, name?: string | RegExp): Promise<void> {
    await until(
      () => this.tab.run(find, role, pattern(name)),
      Boolean,
      () => `There is no ${role} ${name ?? ''}.`,
    );
  }
}

const pattern = (name: string | RegExp | undefined): readonly [string, string] | null =>
  name === undefined
    ? null
    : typeof name === 'string'
      ? [`^${name.replace(/[\\^$.*+?()[\]{}|/]/g, '\\$&')}$`, '']
      : [name.source, name.flags];

async function until<T>(
  ask: () => Promise<T>,
  good: (answer: T) => boolean,
  complaint: (last: T) => string,
): Promise<void> {
  const end = Date.now() + PATIENCE;
  for (;;) {
    const answer = await ask();
    if (good(answer)) return;
    if (Date.now() > end) throw new Error(complaint(answer));
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
}

/** In the page: marks the first visible thing of a role and a name; whether there is one. */
function find(role: Role, name: readonly [string, string] | null): boolean {
  const selectors: Readonly<Record<Role, string>> = {
    button: 'button,[role=button],summary,[role=radio],label.choice',
    link: 'a[href]',
    tab: '[role=tab]',
    field: 'input,textarea,select',
    heading: 'h1,h2,h3,h4',
    region: 'section,[role=region],[role=tabpanel]',
    listbox: '[role=listbox]',
    option: '[role=option]',
    row: 'tr,[role=row]',
    status: '[role=status],output',
    main: 'main',
    list: 'ul,ol,[role=list]',
  };
  const byIds = (element: Element, attribute: string) =>
    element
      .getAttribute(attribute)
      ?.split(/\s+/)
      .map((id) => document.getElementById(id)?.textContent ?? '')
      .join(' ');
  const nameOf = (element: Element) => {
    const labels = [...((element as HTMLInputElement).labels ?? [])].map((label) => {
      const copy = label.cloneNode(true) as Element;
      for (const inner of copy.querySelectorAll('input,select,textarea,button')) inner.remove();
      return copy.textContent;
    });
    const said =
      byIds(element, 'aria-labelledby') ??
      element.getAttribute('aria-label') ??
      (labels.length > 0 ? labels.join(' ') : element.textContent);
    return (said ?? '').replace(/\s+/g, ' ').trim();
  };
  document.querySelector('[data-driven]')?.removeAttribute('data-driven');
  const wanted = name && new RegExp(name[0], name[1]);
  const found = [...document.querySelectorAll(selectors[role])].find(
    (element) =>
      ((element as HTMLElement).checkVisibility() || (element as HTMLInputElement).type === 'file') &&
      (wanted === null || wanted.test(nameOf(element))),
  );
  found?.setAttribute('data-driven', '');
  return found !== undefined;
}

/** In the page: keeps what it complains of. */
function listen(): void {
  const complaints: string[] = [];
  Object.assign(window, { complaints });
  addEventListener('error', (event) => complaints.push(String(event.message)));
  addEventListener('unhandledrejection', (event) => complaints.push(String(event.reason)));
  document.addEventListener('securitypolicyviolation', (event) =>
    complaints.push(`${event.violatedDirective}: ${event.blockedURI} ${event.sample}`),
  );
  for (const kind of ['error', 'warn'] as const) {
    const { [kind]: before } = console;
    Object.assign(console, {
      [kind]: (...said: unknown[]) => {
        complaints.push(said.map(String).join(' '));
        before(...said);
      },
    });
  }
}

/** In the page: chooses the option that says so, if what is marked is a list of options. */
function chooseOption(text: string): boolean {
  const field = document.querySelector('[data-driven]');
  if (!(field instanceof HTMLSelectElement)) return false;
  const option = [...field.options].find((each) => each.label === text);
  if (option === undefined) throw new Error(`It has no option ${text}.`);
  field.value = option.value;
  field.dispatchEvent(new Event('input', { bubbles: true }));
  field.dispatchEvent(new Event('change', { bubbles: true }));
  return true;
}

/** In the page. */
function selectAll(): void {
  const field = document.querySelector('[data-driven]') as HTMLInputElement;
  field.focus();
  field.select();
}

/** In the page: what a keyboard's paste brings; no browser lets a driver fill the clipboard everywhere. */
function pasteInto(text: string): void {
  const clipboardData = new DataTransfer();
  clipboardData.setData('text/plain', text);
  if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
  // Firefox fills an event's data from these two, the others from a transfer.
  const data = { clipboardData, dataType: 'text/plain', data: text };
  document.body.dispatchEvent(new ClipboardEvent('paste', { ...data, bubbles: true, cancelable: true }));
}

/** In the page: the text of what is marked. */
function textOf(): string {
  const marked = document.querySelector<HTMLElement>('[data-driven]');
  if (
    marked instanceof HTMLInputElement ||
    marked instanceof HTMLTextAreaElement ||
    marked instanceof HTMLSelectElement
  )
    return marked.value;
  return (marked?.innerText ?? '').replace(/\s+/g, ' ').trim();
}
