/** What can be wrong with how a page lies on the screen. */
export type LayoutFault =
  | 'wider than the window'
  | 'cut off'
  | 'controls overlap'
  | 'texts overlap'
  | 'target too small'
  | 'under the strip'
  | 'strip too high'
  | 'first fields out of sight'
  | 'tab out of sight';

export interface Fault {
  readonly kind: LayoutFault;
  /** The elements it is about, as a person would look for them. */
  readonly what: string;
}

export interface LayoutRules {
  /** The name of the region of the strip. */
  readonly strip: string;
  /** Also gives each control the focus once, to see whether it is then under the strip. */
  readonly focus: boolean;
  /** Whether the first fields and the beginning of the open tab are to be in sight without scrolling. */
  readonly first?: { readonly form: string } | undefined;
}

/** WCAG 2.5.8, in pixels. */
export const LEAST_TARGET = 24;

/**
 * Every fault of the layout of the page as it stands. It runs in the page, so that it may use nothing from outside itself.
 * Excepted are targets of links within sentences (WCAG 2.5.8), text that ends in an ellipsis, and places that are
 * meant to scroll.
 */
export function layoutFaults({ strip: stripName, focus, first }: LayoutRules): Fault[] {
  const faults: Fault[] = [];
  const seen = new Set<string>();
  const found = (kind: Fault['kind'], what: string) => {
    const key = `${kind} ${what}`;
    if (!seen.has(key)) faults.push({ kind, what });
    seen.add(key);
  };
  const least = 24;
  const root = document.documentElement;

  const isShown = (element: Element) =>
    element.checkVisibility({ visibilityProperty: true, contentVisibilityAuto: true }) &&
    element.closest('[inert], .unstyled') === null;
  const nameOf = (element: Element): string => {
    const label =
      element.getAttribute('aria-label') ??
      ((element as HTMLInputElement).labels?.[0]?.textContent ||
        element.textContent ||
        element.getAttribute('class') ||
        '');
    const inside = element.closest('[aria-label], .panel, main, header')?.getAttribute('aria-label');
    const text = label.trim().replace(/\s+/g, ' ').slice(0, 40);
    return `${element.tagName.toLowerCase()} “${text}”${inside && inside !== label ? ` in ${inside}` : ''}`;
  };
  /** What moves and covers apart from the rest: a sticky or absolutely placed ancestor, a dialog. */
  const layerOf = (element: Element): Element | null => {
    for (let at: Element | null = element; at; at = at.parentElement) {
      if (/^(sticky|fixed|absolute)$/.test(getComputedStyle(at).position) || at.tagName === 'DIALOG') return at;
    }
    return null;
  };
  /** What of a box is left by the ancestors that hide what overflows them; scrolled parts count as hidden too. */
  const clippedTo = (box: DOMRect, within: Element | null, scrollersOnly: boolean) => {
    let { left, top, right, bottom } = box;
    for (let at = within; at && at !== root && at !== document.body; at = at.parentElement) {
      const { overflowX, overflowY, position } = getComputedStyle(at);
      const counts = (how: string) => (scrollersOnly ? /auto|scroll/.test(how) : how !== 'visible');
      const around = at.getBoundingClientRect();
      if (counts(overflowX)) [left, right] = [Math.max(left, around.left), Math.min(right, around.right)];
      if (counts(overflowY)) [top, bottom] = [Math.max(top, around.top), Math.min(bottom, around.bottom)];
      if (position === 'fixed') break;
    }
    return new DOMRect(left, top, Math.max(0, right - left), Math.max(0, bottom - top));
  };
  const common = (a: DOMRect, b: DOMRect) => ({
    x: Math.min(a.right, b.right) - Math.max(a.left, b.left),
    y: Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top),
  });
  const related = (a: Element, b: Element) => a === b || a.contains(b) || b.contains(a);
  /** Calls `act` for each two boxes that may meet. */
  const pairs = <T extends { readonly box: DOMRect }>(of: T[], act: (a: T, b: T) => void) => {
    const sorted = of.toSorted((a, b) => a.box.top - b.box.top);
    sorted.forEach((a, index) => {
      for (let n = index + 1; n < sorted.length; n++) {
        const b = sorted[n];
        if (b === undefined || b.box.top > a.box.bottom) break;
        act(a, b);
      }
    });
  };

  // The page as a whole.
  if (root.scrollWidth > root.clientWidth) {
    const wide = [...document.body.querySelectorAll('*')].filter(
      (element) =>
        isShown(element) &&
        clippedTo(element.getBoundingClientRect(), element.parentElement, false).right + scrollX >
          root.clientWidth + 1 &&
        !element.querySelector(':scope > *'),
    );
    found(
      'wider than the window',
      `${root.scrollWidth} px of ${root.clientWidth}: ${wide.slice(0, 3).map(nameOf).join(', ')}`,
    );
  }

  // Text.
  const texts: { box: DOMRect; element: Element; layer: Element | null }[] = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const element = node.parentElement;
    if (!element || !node.textContent?.trim() || !isShown(element)) continue;
    if (element.closest('option, script, style, noscript, textarea') !== null) continue;
    // What is folded away has boxes all the same.
    if (element.closest('details:not([open])') !== null && element.closest('summary') === null) continue;
    const range = document.createRange();
    range.selectNodeContents(node);
    const layer = layerOf(element);
    for (const box of range.getClientRects()) {
      if (box.width < 1 || box.height < 1) continue;
      const inScroller = clippedTo(box, element, true);
      const left = clippedTo(box, element, false);
      // What is said to those who hear the page alone is a pixel wide.
      if (left.width <= 1 && left.height <= 1) continue;
      const ellipsis = (() => {
        for (let at: Element | null = element; at && at !== document.body; at = at.parentElement) {
          const style = getComputedStyle(at);
          if (style.textOverflow === 'ellipsis' || style.webkitLineClamp !== 'none') return true;
        }
        return false;
      })();
      const cut = Math.max(inScroller.width - left.width, (inScroller.height - left.height) / 2);
      if (cut > 2 && !ellipsis) found('cut off', nameOf(element));
      // The letters themselves fill the middle of their line.
      const inner = new DOMRect(left.left, left.top + left.height * 0.25, left.width, left.height * 0.5);
      if (inner.width > 2 && inner.height > 1) texts.push({ box: inner, element, layer });
    }
  }
  pairs(texts, (a, b) => {
    if (a.element === b.element || a.layer !== b.layer) return;
    const { x, y } = common(a.box, b.box);
    if (x > 2 && y > 1) found('texts overlap', `${nameOf(a.element)} and ${nameOf(b.element)}`);
  });
  // A closed list shows its choice as one line of text.
  const pen = document.createElement('canvas').getContext('2d');
  for (const field of document.querySelectorAll<HTMLSelectElement | HTMLInputElement>('select, input')) {
    if (!isShown(field) || !pen) continue;
    const style = getComputedStyle(field);
    pen.font = style.font;
    const text =
      field instanceof HTMLSelectElement
        ? (field.selectedOptions[0]?.text ?? '')
        : field.value
          ? ''
          : field.placeholder;
    // An arrow stands at the end of a list that has the browser's own look.
    const arrow = field instanceof HTMLSelectElement && style.appearance !== 'none' ? 16 : 0;
    const room =
      field.clientWidth - Number.parseFloat(style.paddingLeft) - Number.parseFloat(style.paddingRight) - arrow;
    if (style.textOverflow !== 'ellipsis' && pen.measureText(text).width > room + 1) {
      found('cut off', `“${text}” in ${nameOf(field)}`);
    }
  }

  // Controls.
  const selector = 'a[href], button, input, select, textarea, summary, [role=tab], [role=button], [tabindex="0"]';
  const controls = [...document.querySelectorAll<HTMLElement>(selector)]
    .filter((element) => isShown(element) && !element.matches('[type=hidden], [type=file]'))
    .flatMap((element) => {
      // A box or a dot is clicked by its label as well.
      const label = element.matches('[type=radio], [type=checkbox]')
        ? (element as HTMLInputElement).labels?.[0]
        : undefined;
      const target = label ?? element;
      const whole = target.getBoundingClientRect();
      const box = clippedTo(whole, target.parentElement, false);
      return box.width > 1 && box.height > 1 ? [{ element, target, whole, box, layer: layerOf(target) }] : [];
    });
  for (const { element, target, whole } of controls) {
    const isPlace = element.matches('[tabindex="0"]:not(button, a, input, select, textarea, summary, [role])');
    // An inline link within a sentence: something else stands in the line.
    const inSentence =
      getComputedStyle(target).display === 'inline' &&
      (target.closest('p, li, dd, td, th, label, span, summary')?.textContent?.trim().length ?? 0) >
        (target.textContent?.trim().length ?? 0);
    if (!isPlace && !inSentence && (whole.width < least - 0.1 || whole.height < least - 0.1)) {
      found('target too small', `${nameOf(element)} ${whole.width.toFixed(1)}×${whole.height.toFixed(1)}`);
    }
  }
  pairs(controls, (a, b) => {
    if (related(a.target, b.target) || related(a.element, b.element) || a.layer !== b.layer) return;
    const { x, y } = common(a.box, b.box);
    if (x > 1 && y > 1) found('controls overlap', `${nameOf(a.element)} and ${nameOf(b.element)}`);
  });

  // The strip, and what is to be in sight at first.
  const strip = document.querySelector(`main section[aria-label="${stripName}"]`);
  const stripBox = strip?.getBoundingClientRect();
  if (stripBox && stripBox.height > innerHeight * 0.35 + 1) {
    found(
      'strip too high',
      `${Math.round(stripBox.height)} px of ${innerHeight}, ${((stripBox.height / innerHeight) * 100).toFixed(0)} %`,
    );
  }
  if (first) {
    const form = document.querySelector(first.form);
    const fields = [...(form?.querySelectorAll<HTMLElement>('input:not([type=radio]), select, fieldset') ?? [])].filter(
      isShown,
    );
    const below = fields.slice(0, 5).filter((field) => field.getBoundingClientRect().bottom > innerHeight);
    if (below.length > 0 || fields.length === 0) found('first fields out of sight', below.map(nameOf).join(', '));
    const open = [...document.querySelectorAll('[role=tabpanel]')].find(isShown);
    const top = open?.getBoundingClientRect().top;
    // Its first line counts as its beginning.
    if (top === undefined || top + 32 > innerHeight) found('tab out of sight', `begins at ${Math.round(top ?? 0)} px`);
  }
  if (focus && strip) {
    const before = document.activeElement;
    for (const { element } of controls) {
      if (strip.contains(element) || element.matches(':disabled')) continue;
      element.focus();
      if (document.activeElement !== element) continue;
      const { x, y } = common(element.getBoundingClientRect(), strip.getBoundingClientRect());
      const box = element.getBoundingClientRect();
      // Not more of it than a line's half may be under the strip.
      if (x > 1 && y > Math.min(8, box.height / 2) && layerOf(element) === null) {
        found('under the strip', `${nameOf(element)}, ${Math.round(y)} px`);
      }
    }
    (before as HTMLElement | null)?.focus?.();
    scrollTo(0, 0);
  }
  return faults;
}
