import { elementScroll, observeElementOffset, observeElementRect, Virtualizer } from '@tanstack/virtual-core';
import { Component, createRef } from 'preact';
import './virtual-lines.css';

/** A long list of which only the lines in sight are drawn, all of one height. */
export abstract class VirtualLines<P extends object, S extends object = object> extends Component<P, S> {
  /** What scrolls. */
  protected readonly element = createRef<HTMLElement>();
  /** The height of a line, in pixels; the style sheet has the same. */
  protected abstract readonly line: number;
  private list: Virtualizer<HTMLElement, HTMLElement> | undefined;
  private stop: (() => void) | undefined;

  /** How many lines there are. */
  protected abstract count(): number;

  /** How the list is made up; some lists leave room for a head. */
  protected options() {
    return {
      count: this.count(),
      getScrollElement: () => this.element.current,
      estimateSize: () => this.line,
      overscan: 8,
      scrollToFn: elementScroll,
      observeElementRect,
      observeElementOffset,
      onChange: () => this.forceUpdate(),
    };
  }

  override componentDidMount() {
    this.stop = this.lines()._didMount();
    this.lines()._willUpdate();
  }

  override componentDidUpdate(_before: Readonly<P>) {
    this.lines()._willUpdate();
  }

  override componentWillUnmount() {
    this.stop?.();
  }

  /** The list, brought up to what is to be shown: call it first when drawing. */
  protected lines(): Virtualizer<HTMLElement, HTMLElement> {
    this.list ??= new Virtualizer<HTMLElement, HTMLElement>(this.options());
    this.list.setOptions(this.options());
    return this.list;
  }

  /** Where a key leads from a line; `undefined` for keys that lead nowhere. */
  protected placeFor({ key }: KeyboardEvent, from: number): number | undefined {
    const page = Math.floor((this.element.current?.clientHeight ?? this.line) / this.line);
    const last = this.count() - 1;
    const to = {
      ArrowDown: from + 1,
      ArrowUp: from - 1,
      PageDown: from + page,
      PageUp: from - page,
      Home: 0,
      End: last,
    }[key];
    return to === undefined ? undefined : Math.max(0, Math.min(last, to));
  }
}
