import { Component, type ComponentChildren } from 'preact';
import { dictionary } from '../../../modbus/index.ts';
import type { Scene } from '../../../workbench/index.ts';
import { characterNear, type StripView } from '../../../workbench/index.ts';
import { relight } from '../../parts/lit.ts';
import { GUTTER } from './picture/picture.tsx';
import { wireWords as words } from './wire-words.ts';

interface ScrollerProps {
  readonly scene: Scene;
  /** Draws what is in sight. */
  readonly draw: (view: StripView) => ComponentChildren;
  /** Takes the strip once it stands, to be asked what is in sight, and told what to show. */
  readonly onReady: (scroller: Scroller) => void;
}

interface ScrollerState {
  readonly width: number;
  readonly px: number;
  readonly from: number;
}

/** Widest that browsers scroll without losing pixels, and the most pixels of a bit. */
const WIDEST = 16_000_000;
const MOST_BIT = 400;
/** What a step of the zoom multiplies by. */
const STEP = 1.4;
/** Bits of silence that are shown on either side of a frame. */
const MARGIN = 50;
/** At first a frame fills the width, but bits are no narrower than this. */
const FIRST_BIT = 4;
/** At most this part of the width is the silence before the frame. */
const FIRST_SILENCE = 0.3;
/** Of the width, what a byte shown and a bit shown take. */
const BYTE_SHARE = 0.6;
const BIT_SHARE = 0.3;
/** Pixels of a bit that has room for its name. */
const READABLE_BIT = 16;

export type ZoomTarget = 'all' | 'frame' | 'byte' | 'bit';

/** The line as a strip that scrolls like any other, of which only what is in sight is drawn. */
export class Scroller extends Component<ScrollerProps, ScrollerState> {
  override state: ScrollerState = { width: 0, px: 0, from: 0 };
  private strip: HTMLElement | null = null;
  private readonly resize = new ResizeObserver(() => this.measure());
  /** Where to scroll the strip once it is drawn at its full width. */
  private goTo: number | undefined;

  override componentDidMount() {
    this.props.onReady(this);
    if (this.strip === null) return;
    this.resize.observe(this.strip);
    this.strip.addEventListener('wheel', this.wheel, { passive: false });
    this.measure();
  }

  override componentWillUnmount() {
    this.resize.disconnect();
    this.strip?.removeEventListener('wheel', this.wheel);
  }

  override componentDidUpdate({ scene: before }: ScrollerProps) {
    const { scene } = this.props;
    if (before !== scene && this.reframe(before)) return;
    if (this.goTo !== undefined && this.strip !== null) {
      this.strip.scrollLeft = this.goTo * this.state.px;
      this.goTo = undefined;
    }
    relight();
  }

  /** Another frame is shown from its beginning; the same on another line stays where it is. Whether that draws again. */
  private reframe(before: Scene): boolean {
    const { scene } = this.props;
    const same =
      before.own === scene.own && before.sent[before.own]?.bytes.length === scene.sent[scene.own]?.bytes.length;
    const { from, px } = this.state;
    if (same && this.scale(px) === px) return false;
    if (same) this.look(from, px);
    else this.show('first');
    return true;
  }

  private measure(): void {
    const width = Math.max(0, (this.strip?.clientWidth ?? 0) - GUTTER);
    if (width === this.state.width) return;
    const first = this.state.width === 0;
    this.setState({ width }, () => {
      if (first) this.show('first');
      else this.look(this.state.from, this.state.px);
    });
  }

  /** The nearest scale there is: no smaller than what shows the whole line. */
  private scale(px: number): number {
    const { end } = this.props.scene.line;
    return Math.max(this.state.width / end, Math.min(MOST_BIT, WIDEST / end, px));
  }

  /** Shows the line from a time on, at so many pixels a bit, within what is possible. */
  private look(from: number, px: number): void {
    const { width } = this.state;
    if (width === 0) return;
    const scale = this.scale(px);
    const start = Math.max(0, Math.min(this.props.scene.line.end - width / scale, from));
    this.goTo = start;
    this.setState({ px: scale, from: start });
  }

  /** Zooms so that the time `at` pixels from the left stays where it is. */
  private zoom(factor: number, at = this.state.width / 2): void {
    const { from, px } = this.state;
    const scale = this.scale(px * factor);
    this.look(from + at / px - at / scale, scale);
  }

  private show(what: ZoomTarget | 'first'): void {
    const { scene } = this.props;
    const { width, from, px } = this.state;
    const { line, own } = scene;
    const frame = line.frames[own] ?? { from: 0, to: line.end };
    const middle = from + width / 2 / px;
    if (what === 'all') this.look(0, 0);
    else if (what === 'first' || what === 'frame') {
      const begin = Math.max(line.quiets.find((quiet) => quiet.to === frame.from)?.from ?? 0, frame.from - MARGIN);
      const end = Math.min(line.quiets.find((quiet) => quiet.from === frame.to)?.to ?? line.end, frame.to + MARGIN);
      const fit = width / (end - begin);
      const scale = what === 'first' ? Math.max(fit, FIRST_BIT) : fit;
      // Where the silence before it would take most of the width, the frame begins further left.
      this.look(Math.max(begin, frame.from - (FIRST_SILENCE * width) / scale), scale);
    } else if (what === 'bit') {
      const scale = width * BIT_SHARE;
      this.look(Math.floor(middle) + 0.5 - width / 2 / Math.min(scale, MOST_BIT), scale);
    } else {
      const near = characterNear(line, middle);
      if (near) this.showSpan(near.start, near.end);
    }
  }

  private showSpan(start: number, end: number): void {
    const { width } = this.state;
    const scale = Math.min(Math.max((width * BYTE_SHARE) / (end - start), READABLE_BIT), MOST_BIT);
    this.look((start + end) / 2 - width / 2 / scale, scale);
  }

  /** Brings a byte of the current frame into the middle, large enough for its bits to be read. */
  showByte(index: number): void {
    const { line, own } = this.props.scene;
    const character = line.characters.find((each) => each.frame === own && each.index === index);
    if (character) this.showSpan(character.start, character.end);
    this.strip?.scrollIntoView({ block: 'nearest' });
  }

  get view(): StripView {
    return this.state;
  }

  private readonly wheel = (event: WheelEvent): void => {
    if (!event.ctrlKey || this.strip === null) return;
    event.preventDefault();
    const at = event.clientX - this.strip.getBoundingClientRect().left - GUTTER;
    this.zoom(event.deltaY < 0 ? STEP : 1 / STEP, Math.max(0, at));
  };

  private readonly key = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { line } = this.props.scene;
    const actions: Readonly<Record<string, () => void>> = dictionary({
      '+': () => this.zoom(STEP),
      '=': () => this.zoom(STEP),
      '-': () => this.zoom(1 / STEP),
      '0': () => this.show('all'),
      Home: () => this.look(0, this.state.px),
      End: () => this.look(line.end, this.state.px),
    });
    const action = actions[event.key];
    if (action === undefined) return;
    event.preventDefault();
    action();
  };

  render() {
    const { scene, draw } = this.props;
    const { width, px } = this.state;
    return (
      <>
        <fieldset class="zoom" aria-label={words.zoom}>
          <button type="button" aria-label={words.zoomOut} title={words.zoomOut} onClick={() => this.zoom(1 / STEP)}>
            −
          </button>
          <button type="button" aria-label={words.zoomIn} title={words.zoomIn} onClick={() => this.zoom(STEP)}>
            +
          </button>
          {(['all', 'frame', 'byte', 'bit'] as const).map((what) => (
            <button key={what} type="button" title={words.zoomHints[what]} onClick={() => this.show(what)}>
              {words.zoomTo[what]}
            </button>
          ))}
          <span class="said">{words.zoomHint}</span>
        </fieldset>
        <section
          class="strip-of-line"
          aria-label={words.view}
          // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls has to be reached by the keyboard
          tabIndex={0}
          ref={(strip) => {
            this.strip = strip;
          }}
          onKeyDown={this.key}
          onScroll={({ currentTarget }) => {
            const from = currentTarget.scrollLeft / px;
            // Scrolling rounds to whole pixels; the place that was asked for stays exact.
            if (Math.abs(from - this.state.from) * px >= 1) this.setState({ from });
          }}
        >
          <div class="whole-line" style={{ '--whole': `${GUTTER + Math.ceil(scene.line.end * px)}px` }}>
            {width > 0 && px > 0 && draw(this.state)}
          </div>
        </section>
      </>
    );
  }
}
