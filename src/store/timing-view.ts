import { computed, effect } from '@preact/signals-core';
import {
  keptTexts,
  lineTexts,
  readTiming,
  saidOfLine,
  type TimingName,
  type TimingTexts,
  timingTexts,
} from '../workbench/index.ts';
import { AddressedView } from './addressed-view.ts';
import type { Line } from './line.ts';
import type { Page } from './page.ts';
import { same } from './steady.ts';
import type { KeptChoice } from './storage.ts';

/** The Timing view: the page's line as typed, and the current frame on it. Its address names the frame too. */
export class TimingView extends AddressedView<TimingTexts> {
  readonly reading;
  readonly #last: KeptChoice<TimingTexts>;
  readonly #line: Line;
  readonly #stops: readonly (() => void)[];

  /** @param last the devices as typed last */
  constructor(page: Page, last: KeptChoice<TimingTexts>, line: Line) {
    super(
      page,
      'timing',
      (parts) => {
        page.takeFrame(parts.get('frame') ?? '');
        const texts = timingTexts((name) => parts.get(name), { ...last.value, ...lineTexts(line.setting.peek()) });
        // An address that names a line sets it for the whole page.
        if (parts.has('baud') || parts.has('format')) setLine(line, texts);
        return texts;
      },
      (texts) => ({ ...texts, frame: page.frameLink.peek() }),
    );
    this.#last = last;
    this.#line = line;
    this.reading = computed(() => readTiming(this.shown.value, page.draft.value));
    let before = line.setting.peek();
    this.#stops = [
      // A frame is pasted here too, and a link is to find it. An address that leaves something out is completed.
      effect(() => {
        if (page.frameLink.value && page.address.given.value && page.view.value === 'timing') this.follow();
      }),
      line.setting.subscribe((setting) => {
        if (setting === before) return;
        before = setting;
        if (!same({ ...setting, ...saidOfLine(this.shown.peek()) }, setting)) this.change(lineTexts(setting));
      }),
    ];
  }

  readonly set = (name: TimingName, text: string): void => {
    this.change({ [name]: text });
    this.#last.value = keptTexts(this.shown.value);
    if (name === 'baud' || name === 'format') setLine(this.#line, this.shown.value);
  };

  override stop(): void {
    super.stop();
    for (const stop of this.#stops) stop();
  }
}

/** Sets the line to what the texts say of it, if that is something else. */
function setLine(line: Line, texts: TimingTexts): void {
  const before = line.setting.peek();
  const said = { ...before, ...saidOfLine(texts) };
  if (!same(before, said)) line.set(said);
}
