import { PropertySymbol } from 'happy-dom';
import { Ivya } from 'ivya';

/** The elements that may have a role without the attribute that says so; a role that is not here may be anywhere. */
export const ELEMENTS_OF_ROLE: Readonly<Record<string, readonly string[]>> = {
  alert: [],
  banner: ['header'],
  button: ['button', 'input'],
  cell: ['td', 'th'],
  checkbox: ['input'],
  columnheader: ['th'],
  combobox: ['input', 'select'],
  definition: ['dd'],
  dialog: ['dialog'],
  form: ['form'],
  grid: [],
  group: ['details', 'fieldset', 'optgroup'],
  heading: ['h1', 'h2', 'h3', 'h4', 'h5', 'h6'],
  img: ['img', 'svg'],
  link: ['a', 'area'],
  list: ['menu', 'ol', 'ul'],
  listbox: ['datalist', 'select'],
  listitem: ['li'],
  main: ['main'],
  menuitem: [],
  navigation: ['nav'],
  option: ['option'],
  progressbar: ['progress'],
  radio: ['input'],
  region: ['section'],
  row: ['tr'],
  rowheader: ['th'],
  searchbox: ['input'],
  slider: ['input'],
  status: ['output'],
  tab: [],
  table: ['table'],
  tablist: [],
  tabpanel: [],
  textbox: ['input', 'textarea'],
  treegrid: [],
};

/** The elements that have labels. */
const LABELLED = ['button', 'input', 'meter', 'output', 'progress', 'select', 'textarea'];

type Root = Element | Document;
type MayBe = (element: Element) => boolean;

export function mayHaveRole(role: string): MayBe {
  const names = ELEMENTS_OF_ROLE[role];
  return names ? (element) => names.includes(element.localName) || element.hasAttribute('role') : () => true;
}

const mayBeLabelled: MayBe = (element) =>
  LABELLED.includes(element.localName) || element.hasAttribute('aria-label') || element.hasAttribute('aria-labelledby');

/** What stands in an element, in the order of the document: as `querySelectorAll('*')`, which keeps a list in each of them. */
export function descendants(root: Root, mayBe: MayBe = () => true): Element[] {
  const found: Element[] = [];
  const add = (parent: Root) => {
    for (const child of (parent as unknown as Record<symbol, Element[]>)[PropertySymbol.elementArray] ?? []) {
      if (mayBe(child)) found.push(child);
      add(child);
    }
  };
  add(root);
  return found;
}

/** A document for Playwright's engine that has these elements only. */
const only = (elements: readonly Element[]) =>
  ({ nodeType: Node.DOCUMENT_NODE, querySelectorAll: () => elements }) as unknown as Document;

const engine = Ivya.create({ browser: 'chromium' });

/** What a selector of Playwright finds in an element: the engine is given as few elements as it can find anything in. */
export function search(selector: string, root: Root): Element[] {
  if (/^[\w.#[\]="-]+$/.test(selector)) return [...root.querySelectorAll(selector)];
  const [, kind, sought = ''] = /^internal:(role|label|text)=(.*)$/s.exec(selector) ?? [];
  if (!kind || sought.includes('>>')) return engine.queryLocatorSelectorAll(selector, root);
  if (kind === 'text') {
    const itself = root.nodeType === Node.ELEMENT_NODE ? [root as Element] : [];
    return engine.queryLocatorSelectorAll(selector, only([...itself, ...descendants(root)]));
  }
  const mayBe = kind === 'role' ? mayHaveRole(/^\w*/.exec(sought)?.[0] ?? '') : mayBeLabelled;
  return engine.queryLocatorSelectorAll(selector, only(descendants(root, mayBe)));
}
