/** As much of a document as Preact needs to draw into: elements, texts, their order, attributes, and listeners. */
class SmallNode {
  parentNode: SmallElement | null = null;
  readonly nodeType: number;

  constructor(nodeType: number) {
    this.nodeType = nodeType;
  }

  get nextSibling(): SmallNode | null {
    const siblings = this.parentNode?.childNodes ?? [];
    return siblings[siblings.indexOf(this) + 1] ?? null;
  }

  remove(): void {
    this.parentNode?.removeChild(this);
  }
}

class SmallText extends SmallNode {
  data: string;

  constructor(data: string) {
    super(3);
    this.data = data;
  }
}

export class SmallElement extends SmallNode {
  readonly localName: string;
  readonly childNodes: SmallNode[] = [];
  readonly attributes = new Map<string, string>();
  readonly #listeners = new Map<string, (event: unknown) => void>();
  readonly style = { cssText: '', setProperty: () => undefined };
  readonly ownerDocument: unknown;
  /** Enough for twelve lines of a list. */
  readonly clientHeight = 384;
  readonly namespaceURI = 'http://www.w3.org/1999/xhtml';

  constructor(localName: string, ownerDocument: unknown) {
    super(1);
    this.localName = localName;
    this.ownerDocument = ownerDocument;
  }

  /** Nothing has the focus in this document. */
  contains(_: SmallNode | undefined): boolean {
    return false;
  }

  get firstChild(): SmallNode | null {
    return this.childNodes[0] ?? null;
  }

  insertBefore(child: SmallNode, before: SmallNode | null): SmallNode {
    child.remove();
    const at = before === null ? this.childNodes.length : this.childNodes.indexOf(before);
    this.childNodes.splice(at, 0, child);
    child.parentNode = this;
    return child;
  }

  appendChild(child: SmallNode): SmallNode {
    return this.insertBefore(child, null);
  }

  removeChild(child: SmallNode): SmallNode {
    this.childNodes.splice(this.childNodes.indexOf(child), 1);
    child.parentNode = null;
    return child;
  }

  setAttribute(name: string, value: unknown): void {
    this.attributes.set(name, String(value));
  }

  removeAttribute(name: string): void {
    this.attributes.delete(name);
  }

  addEventListener(name: string, listener: (event: unknown) => void): void {
    this.#listeners.set(name, listener);
  }

  removeEventListener(name: string): void {
    this.#listeners.delete(name);
  }

  /** Tells the listener of this element, as a browser does when somebody types. */
  dispatch(type: string, currentTarget: object): void {
    this.#listeners.get(type)?.call(this, { type, currentTarget: Object.assign(this, currentTarget), target: this });
  }

  /** The element below this one with an id. */
  byId(id: string): SmallElement | undefined {
    for (const child of this.childNodes) {
      if (!(child instanceof SmallElement)) continue;
      const found = child.attributes.get('id') === id || Reflect.get(child, 'id') === id ? child : child.byId(id);
      if (found) return found;
    }
    return undefined;
  }

  get textContent(): string {
    return this.childNodes
      .map((child) =>
        child instanceof SmallElement ? child.textContent : child instanceof SmallText ? child.data : '',
      )
      .join('');
  }
}

export class SmallDocument {
  readonly createElement = (name: string) => new SmallElement(name, this);
  readonly createElementNS = (_: string, name: string) => new SmallElement(name, this);
  readonly createTextNode = (text: string) => new SmallText(text);
  readonly getElementById = () => null;
  readonly addEventListener = () => undefined;
  readonly documentElement = this.createElement('html');
}
