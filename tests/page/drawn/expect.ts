import { getAriaDisabled, getElementAccessibleDescription, getElementAccessibleName } from 'ivya/utils';
import { expect as vitestExpect } from 'vitest';
import { Locator, plain } from './locator.ts';
import { Page } from './page.ts';
import { PATIENCE, until } from './until.ts';
import { isElementVisible } from './visible.ts';

type Text = string | RegExp;
/** Whether it holds, `undefined` where there is nothing of which it could hold or not; and what was found. */
type Told = readonly [holds: boolean | undefined, actual: unknown];

const isText = (actual: string, text: Text) => (typeof text === 'string' ? actual === plain(text) : text.test(actual));
const hasText = (actual: string, text: Text) =>
  typeof text === 'string' ? actual.includes(plain(text)) : text.test(actual);

/** What is asked of one element; an element that is not there has nothing. */
const ofOne =
  (ask: (element: HTMLElement) => Told) =>
  (locator: Locator): Told => {
    const found = locator.elements();
    if (found.length > 1) return [undefined, `${found.length} elements, not one`];
    return found[0] ? ask(found[0] as HTMLElement) : [undefined, 'no element'];
  };

const texts = (locator: Locator, given: Text | readonly Text[], fits: typeof isText): Told => {
  if (!Array.isArray(given)) {
    return ofOne((element) => {
      const actual = plain(element.textContent);
      return [fits(actual, given as Text), actual];
    })(locator);
  }
  const actual = locator.elements().map((element) => plain(element.textContent));
  return [actual.length === given.length && actual.every((text, index) => fits(text, given[index])), actual];
};

const matchers = {
  toBeVisible:
    () =>
    (locator: Locator): Told => {
      const found = locator.elements();
      if (found.length > 1) return [undefined, `${found.length} elements, not one`];
      return [found.some(isElementVisible), found[0] ? 'hidden or shown' : 'no element'];
    },
  toBeHidden:
    () =>
    (locator: Locator): Told => [!locator.elements().some(isElementVisible), 'shown'],
  toBeAttached: () => (locator: Locator) => [locator.elements().length > 0, 'there'],
  toHaveCount:
    (count: number) =>
    (locator: Locator): Told => {
      const actual = locator.elements().length;
      return [actual === count, actual];
    },
  toHaveText: (given: Text | readonly Text[]) => (locator: Locator) => texts(locator, given, isText),
  toContainText: (given: Text | readonly Text[]) => (locator: Locator) => texts(locator, given, hasText),
  toHaveValue: (given: Text) =>
    ofOne((element) => {
      const { value } = element as HTMLInputElement;
      return [typeof given === 'string' ? value === given : given.test(value), value];
    }),
  toBeFocused: () =>
    ofOne((element) => [document.activeElement === element, document.activeElement?.outerHTML.slice(0, 200)]),
  toHaveAttribute: (name: string, given?: Text) =>
    ofOne((element) => {
      const actual = element.getAttribute(name);
      if (given === undefined || actual === null) return [actual !== null && given === undefined, actual];
      return [typeof given === 'string' ? actual === given : given.test(actual), actual];
    }),
  toHaveClass: (given: Text) => ofOne((element) => [isText(element.className, given), element.className]),
  toHaveAccessibleName: (given: Text) =>
    ofOne((element) => {
      const actual = plain(getElementAccessibleName(element, false));
      return [isText(actual, given), actual];
    }),
  toHaveAccessibleDescription: (given: Text) =>
    ofOne((element) => {
      const actual = plain(getElementAccessibleDescription(element, false));
      return [isText(actual, given), actual];
    }),
  toBeDisabled: () => ofOne((element) => [getAriaDisabled(element), 'enabled']),
  toBeEnabled: () => ofOne((element) => [!getAriaDisabled(element), 'disabled']),
  toBeChecked: (given: { checked?: boolean } = {}) =>
    ofOne((element) => {
      const { checked = true } = given;
      const actual = (element as HTMLInputElement).checked ?? element.getAttribute('aria-checked') === 'true';
      return [actual === checked, actual];
    }),
  toBeEmpty: () =>
    ofOne((element) => {
      const actual = (element as HTMLInputElement).value ?? plain(element.textContent);
      return [actual === '', actual];
    }),
  toHaveURL: (given: Text) => (): Told => [
    typeof given === 'string' ? new URL(given, location.href).href === location.href : given.test(location.href),
    location.href,
  ],
  toHaveTitle: (given: Text) => (): Told => [isText(plain(document.title), given), document.title],
};

/** Vitest's `expect`, and Playwright's for what is in the page: it waits until the page is so. */
export const expect = Object.assign(
  (subject: unknown, message?: string) =>
    subject instanceof Locator || subject instanceof Page ? ofPage(subject, message) : vitestExpect(subject, message),
  vitestExpect,
  {
    poll: (read: () => unknown, message?: string | { message?: string }) =>
      vitestExpect.poll(read, {
        timeout: PATIENCE,
        interval: 10,
        message: typeof message === 'string' ? message : (message?.message ?? ''),
      }),
  },
);

function ofPage(subject: Locator | Page, message = ''): unknown {
  const build = (isNot: boolean) =>
    Object.fromEntries(
      Object.entries(matchers).map(([name, make]) => [
        name,
        async (...given: unknown[]) => {
          const ask = (make as (...given: unknown[]) => (subject: unknown) => Told)(...given);
          let told: Told = [false, undefined];
          await until(
            () => {
              told = ask(subject);
              return told[0] === !isNot;
            },
            () =>
              `${message} expect(${subject})${isNot ? '.not' : ''}.${name}(${given.map(String).join(', ')}): ${JSON.stringify(told[1])}`,
          );
        },
      ]),
    );
  return { ...build(false), not: build(true) };
}
