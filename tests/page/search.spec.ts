import { Ivya } from 'ivya';
import { getAriaRole } from 'ivya/utils';
import { descendants, ELEMENTS_OF_ROLE, mayHaveRole, search } from './drawn/search.ts';
import { expect, test } from './page.ts';

const NAMES =
  'a area article aside blockquote button caption code datalist dd del details dfn dialog div dl dt em fieldset figure footer form h1 h2 h3 h4 h5 h6 header hr img input ins label li main mark math menu meter nav ol optgroup option output p progress section select span strong sub summary sup svg table tbody td textarea tfoot th thead time tr ul'.split(
    ' ',
  );

const ATTRIBUTES: readonly Readonly<Record<string, string>>[] = [
  {},
  { href: '#' },
  { 'aria-label': 'Name' },
  { alt: '' },
  { multiple: '' },
  { scope: 'col' },
  { scope: 'row' },
  { list: 'list' },
  ...['button', 'checkbox', 'file', 'image', 'number', 'radio', 'range', 'search', 'submit'].map((type) => ({ type })),
  { type: 'search', list: 'list' },
];

test('whatever has a role is among the elements that may have it', async ({ page }) => {
  await page.goto('./kit.html');
  const found = new Set<string>();
  const grid = document.createElement('table');
  grid.setAttribute('role', 'grid');
  const list = Object.assign(document.createElement('datalist'), { id: 'list' });
  document.body.append(grid, list);
  for (const parent of [document.body, grid]) {
    for (const name of NAMES) {
      for (const attributes of ATTRIBUTES) {
        const element = document.createElement(name);
        for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
        parent.append(element);
        const role = getAriaRole(element) ?? '';
        element.remove();
        found.add(role);
        if (!mayHaveRole(role)(element)) expect(`${role}: ${element.outerHTML}`).toBe('not left out');
      }
    }
  }
  // Each role that some element has without saying so was met.
  for (const [role, names] of Object.entries(ELEMENTS_OF_ROLE)) if (names.length > 0) expect(found).toContain(role);
});

test('a search finds in a page what the engine finds in all of it', async ({ page }) => {
  await page.goto('./kit.html');
  await expect(page.getByRole('heading').first()).toBeVisible();
  const engine = Ivya.create({ browser: 'chromium' });
  const selectors = [
    ...Object.keys(ELEMENTS_OF_ROLE).map((role) => `internal:role=${role}`),
    'internal:role=button[name="o"i]',
    'internal:label="e"i',
    'internal:text="e"i',
    'internal:text=/^[A-Z]/',
    '.field',
  ];
  let found = 0;
  for (const root of [document, ...document.querySelectorAll('section')]) {
    const elements = descendants(root);
    expect([...root.querySelectorAll('*')].every((element, at) => element === elements[at])).toBe(true);
    for (const selector of selectors) {
      const all = engine.queryLocatorSelectorAll(selector, root as Element);
      found += all.length;
      const same = search(selector, root);
      expect(same.length === all.length && same.every((element) => all.includes(element)), selector).toBe(true);
    }
  }
  expect(found).toBeGreaterThan(100);
});
