import type { UserEvent } from '@testing-library/user-event';
import {
  getByLabelSelector,
  getByPlaceholderSelector,
  getByRoleSelector,
  getByTextSelector,
  getByTitleSelector,
} from 'ivya';
import { press, type } from './keys.ts';
import { look } from './look.ts';
import { search } from './search.ts';
import { until } from './until.ts';
import { isElementVisible, isUsable } from './visible.ts';

type ByText = { exact?: boolean };
interface Filter {
  hasText?: string | RegExp;
  hasNotText?: string | RegExp;
  has?: Locator;
}
type ByRole = Parameters<typeof getByRoleSelector>[1];

/** A file as a test gives it to a field. */
export interface GivenFile {
  readonly name: string;
  readonly mimeType: string;
  readonly buffer: Uint8Array;
}

/** As much of Playwright's locator as the tests use, over a document in this process. */
export class Locator {
  readonly #selectors: readonly Step[];
  readonly #user: () => UserEvent;

  constructor(user: () => UserEvent, selectors: readonly Step[] = []) {
    this.#user = user;
    this.#selectors = selectors;
  }

  #with(step: Step): Locator {
    return new Locator(this.#user, [...this.#selectors, step]);
  }

  getByRole(role: string, options?: ByRole): Locator {
    // The element of this name is younger than the engine's table of roles.
    if (role === 'search') return this.#with('search');
    return this.#with(getByRoleSelector(role, options));
  }

  getByLabel(text: string | RegExp, options?: ByText): Locator {
    return this.#with(getByLabelSelector(text, options));
  }

  getByText(text: string | RegExp, options?: ByText): Locator {
    return this.#with(getByTextSelector(text, options));
  }

  getByTitle(text: string | RegExp, options?: ByText): Locator {
    return this.#with(getByTitleSelector(text, options));
  }

  getByPlaceholder(text: string | RegExp, options?: ByText): Locator {
    return this.#with(getByPlaceholderSelector(text, options));
  }

  locator(selector: string | Locator, options: Filter = {}): Locator {
    const found =
      selector instanceof Locator
        ? new Locator(this.#user, [...this.#selectors, ...selector.#selectors])
        : this.#with(selector);
    return found.filter(options);
  }

  filter({ hasText, has, hasNotText }: Filter): Locator {
    const holds = (element: Element, text: string | RegExp) => {
      const content = plain(element.textContent);
      return typeof text === 'string' ? content.toLowerCase().includes(plain(text).toLowerCase()) : text.test(content);
    };
    return this.#with((elements) =>
      elements.filter(
        (element) =>
          (hasText === undefined || holds(element, hasText)) &&
          (hasNotText === undefined || !holds(element, hasNotText)) &&
          (has === undefined || has.elementsIn(element).length > 0),
      ),
    );
  }

  or(other: Locator): Locator {
    return new Locator(this.#user, [() => [...new Set([...this.elements(), ...other.elements()])]]);
  }

  nth(index: number): Locator {
    return this.#with((elements) => elements.slice(index, index === -1 ? undefined : index + 1));
  }

  first(): Locator {
    return this.nth(0);
  }

  last(): Locator {
    return this.nth(-1);
  }

  /** What it finds now, in the order of the document. */
  elements(): Element[] {
    return this.elementsIn(document);
  }

  elementsIn(root: Element | Document): Element[] {
    return look(() => {
      let found: (Element | Document)[] = [root];
      for (const step of this.#selectors) {
        if (typeof step === 'function') found = step(found as Element[]);
        else found = [...new Set(found.flatMap((parent) => search(step, parent)))];
      }
      return found as Element[];
    });
  }

  /** The one element that it finds; waits for it. */
  async one(): Promise<HTMLElement> {
    let found: Element[] = [];
    await until(
      () => {
        found = this.elements();
        return found.length === 1;
      },
      () => `${found.length} elements, not one: ${this}`,
    );
    return found[0] as HTMLElement;
  }

  /** The one element that it finds, once it is shown and can be used, and whatever else is needed. */
  async #ready(isFit: (element: HTMLElement) => boolean = isElementVisible): Promise<HTMLElement> {
    let found: Element[] = [];
    await until(
      () => {
        found = this.elements();
        const [element] = found as HTMLElement[];
        return found.length === 1 && element !== undefined && isFit(element) && isUsable(element);
      },
      () =>
        found.length === 1 ? `not shown, or not to be used: ${this}` : `${found.length} elements, not one: ${this}`,
    );
    return found[0] as HTMLElement;
  }

  async click(options: { modifiers?: readonly string[]; button?: string; clickCount?: number } = {}): Promise<void> {
    const element = await this.#ready();
    const held = (options.modifiers ?? []).map((key) => (key === 'ControlOrMeta' ? 'Control' : key));
    for (const key of held) await this.#user().keyboard(`{${key}>}`);
    await this.#user().click(element);
    for (const key of held) await this.#user().keyboard(`{/${key}}`);
    await drawn();
  }

  async dblclick(): Promise<void> {
    await this.#user().dblClick(await this.#ready());
    await drawn();
  }

  async hover(): Promise<void> {
    const target = await this.#ready();
    // Every element is somewhere else.
    pointed += 1;
    await this.#user().pointer({ target, coords: { clientX: pointed, clientY: pointed } });
    await drawn();
  }

  async fill(text: string): Promise<void> {
    const element = (await this.#ready(isEditable)) as HTMLInputElement;
    if (!element.matches('input, textarea')) throw new Error(`no field that takes a text: ${this}`);
    const left = document.activeElement;
    element.focus();
    // What was changed in the field before is heard of first, which may put another field in the place of this one.
    if (left && left !== element) {
      await drawn();
      if (!element.isConnected || !isEditable(element) || !isUsable(element)) return this.fill(text);
    }
    const proto = element instanceof HTMLTextAreaElement ? HTMLTextAreaElement : HTMLInputElement;
    Object.getOwnPropertyDescriptor(proto.prototype, 'value')?.set?.call(element, text);
    element.dispatchEvent(new InputEvent('input', { bubbles: true, inputType: 'insertText', data: text }));
    changed.add(element);
    await drawn();
  }

  async clear(): Promise<void> {
    await this.fill('');
  }

  async press(keys: string): Promise<void> {
    (await this.one()).focus();
    await press(this.#user(), keys);
    await drawn();
  }

  async pressSequentially(text: string): Promise<void> {
    (await this.one()).focus();
    await type(this.#user(), text);
    await drawn();
  }

  async focus(): Promise<void> {
    (await this.one()).focus();
    await drawn();
  }

  async blur(): Promise<void> {
    (await this.one()).blur();
    await drawn();
  }

  async check(): Promise<void> {
    await this.#set(true);
  }

  async uncheck(): Promise<void> {
    await this.#set(false);
  }

  async #set(checked: boolean): Promise<void> {
    const element = (await this.#ready()) as HTMLInputElement;
    if (element.checked !== checked) await this.#user().click(element);
    await drawn();
    await until(
      () => ((this.elements()[0] ?? element) as HTMLInputElement).checked === checked,
      () => `${checked ? 'not ' : ''}checked after a click: ${this}`,
    );
  }

  async selectOption(which: string | { label?: string; value?: string; index?: number }): Promise<void> {
    const { label, value, index } = typeof which === 'string' ? { label: which, value: which } : which;
    const option = (select: HTMLElement) =>
      [...(select as HTMLSelectElement).options].find(
        (option, at) =>
          (option.value === value || option.text === label || at === index) && !option.matches(':disabled'),
      );
    const element = await this.#ready((select) => isElementVisible(select) && option(select) !== undefined);
    await this.#user().selectOptions(element, option(element) as HTMLOptionElement);
    await drawn();
  }

  async setInputFiles(given: GivenFile | readonly GivenFile[]): Promise<void> {
    const files = [given]
      .flat()
      .map(({ name, mimeType, buffer }) => new File([buffer as never], name, { type: mimeType }));
    // Who chooses a file clicks what stands for its field, which is hidden.
    await this.#user().upload(await this.#ready(() => true), files);
    await drawn();
  }

  async dispatchEvent(type: string, init: object = {}): Promise<void> {
    (await this.one()).dispatchEvent(Object.assign(new Event(type, { bubbles: true, cancelable: true }), init));
    await drawn();
  }

  async evaluate<Result, Given>(run: (element: HTMLElement, given: Given) => Result, given?: Given): Promise<Result> {
    return run(await this.one(), given as Given);
  }

  async evaluateAll<Result>(run: (elements: HTMLElement[]) => Result): Promise<Result> {
    return run(this.elements() as HTMLElement[]);
  }

  async count(): Promise<number> {
    return this.elements().length;
  }

  async all(): Promise<Locator[]> {
    return this.elements().map((_, index) => this.nth(index));
  }

  async textContent(): Promise<string | null> {
    return (await this.one()).textContent;
  }

  async innerText(): Promise<string> {
    return (await this.one()).innerText;
  }

  async allTextContents(): Promise<string[]> {
    return this.elements().map((element) => element.textContent ?? '');
  }

  async inputValue(): Promise<string> {
    return ((await this.one()) as HTMLInputElement).value;
  }

  async selectText(): Promise<void> {
    ((await this.#ready()) as HTMLInputElement).select();
  }

  async scrollIntoViewIfNeeded(): Promise<void> {
    await this.one();
  }

  async getAttribute(name: string): Promise<string | null> {
    return (await this.one()).getAttribute(name);
  }

  async isVisible(): Promise<boolean> {
    const found = this.elements();
    return found.length === 1 && isElementVisible(found[0] as Element);
  }

  toString(): string {
    return this.#selectors.map((step) => (typeof step === 'string' ? step : 'filter')).join(' >> ');
  }
}

type Step = string | ((elements: Element[]) => Element[]);

/** Fields whose text was changed since they got the focus. */
export const changed = new WeakSet<Element>();

const isEditable = (element: HTMLElement) => isElementVisible(element) && !element.hasAttribute('readonly');

/** How often something was pointed at. */
let pointed = 0;

/** White space as Playwright counts it. */
export const plain = (text: string | null) =>
  (text ?? '')
    .replace(/\u200b/g, '')
    .trim()
    .replace(/\s+/g, ' ');

/** Until what was done is drawn. */
export const drawn = () =>
  new Promise<void>((resolve) =>
    requestAnimationFrame(() => setTimeout(() => requestAnimationFrame(() => setTimeout(resolve)))),
  );
