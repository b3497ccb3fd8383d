import type { VNode } from 'preact';
import { bitsTime, type Section, type SerialMode } from '../../modbus/index.ts';
import { KeptChoice } from '../../store/index.ts';
import { loadTimingWords, type TimingWords } from '../../words/index.ts';
import {
  charactersEntry,
  devicesEntry,
  type Entry,
  type ExchangeInputs,
  exchangeSizes,
  firstTimingTexts,
  keptTexts,
  knownOf,
  missingEntry,
  readLink,
  type SetLine,
  storedTexts,
  type TimingName,
  type TimingTexts,
  timeEntry,
  timingLine,
  timingMode,
  timingTexts,
  writeLink,
} from '../../workbench/index.ts';
import { AddressedView } from '../parts/addressed-view.ts';
import { words } from '../parts/page-words.ts';
import { draft, evaluation, storage } from '../parts/store.ts';
import { EntryField } from './entry-field.tsx';
import { ExchangePanel, RoundPanel } from './exchange-panel.tsx';
import { GapPanel } from './gap-panel.tsx';
import { LineForm } from './line-form.tsx';
import { SilencePanel } from './silence-panel.tsx';
import { SpeedTable } from './speed-table.tsx';
import './timing.css';

interface TimingProps {
  readonly text: TimingWords;
}

/** The view with its words. */
export async function load(): Promise<() => VNode> {
  const text = await loadTimingWords();
  return () => <TimingView text={text} />;
}

/** The line and the devices as typed last. */
const lastTexts = new KeptChoice<TimingTexts>(storage, 'timing', firstTimingTexts, storedTexts);

/** Where the most characters of a frame stand. */
const SIZE_SECTION: Readonly<Record<SerialMode, Section>> = { rtu: 'SL 2.5.1', ascii: 'SL 2.5.2.1' };

const frameLink = () => writeLink(draft.value, evaluation.value.controls);

/** How long characters, silences, exchanges and rounds take on a serial line. Its address has the current frame too. */
class TimingView extends AddressedView<TimingProps, TimingTexts> {
  protected readonly name = 'timing';
  protected readonly title = this.props.text.title;
  /** The frame that the address names. */
  private linked = '';

  protected read(query: ReadonlyMap<string, string>) {
    const frame = query.get('frame');
    const read = frame ? readLink(frame) : undefined;
    if (read && frame !== frameLink()) draft.value = read.draft;
    // An address that leaves something out is completed, so that it says the same to others.
    this.linked = '';
    return timingTexts((name) => query.get(name) ?? undefined, lastTexts.value);
  }

  protected write(texts: TimingTexts) {
    return { ...texts, frame: frameLink() };
  }

  override componentDidMount() {
    super.componentDidMount();
    this.nameFrame();
  }

  /** A frame is pasted here too, and a link is to find it. */
  override componentDidUpdate() {
    this.nameFrame();
  }

  private nameFrame(): void {
    const link = frameLink();
    if (link === this.linked) return;
    this.linked = link;
    this.change({});
  }

  private readonly set = (name: TimingName, value: string) => {
    this.change({ [name]: value });
    lastTexts.value = keptTexts({ ...this.state, [name]: value });
  };

  render() {
    const { text } = this.props;
    const texts: TimingTexts = this.state;
    const { set } = this;
    const mode = timingMode(texts, draft.value.transport);
    const line = timingLine(texts);
    const sizes = exchangeSizes(draft.value, mode);
    const request = charactersEntry(texts.request, mode, 1, sizes.request);
    const reply = charactersEntry(texts.reply, mode, 0, sizes.reply);
    const answered = knownOf(reply) !== 0;
    const delay = timeEntry(answered ? texts.delay : texts.turnaround, line);
    const devices = devicesEntry(texts);
    const missing = missingEntry(texts, knownOf(devices) ?? 0);
    const timeout = timeEntry(texts.timeout, line);
    const inputs = inputsOf(line, mode, [request, reply, delay]);
    const field = { onText: set };
    const hint = (entry: Entry, said: string) => timeHint(entry, line, text, said);
    return (
      <main class="timing" onFocusOut={this.follow}>
        <div class="columns">
          <div class="stack">
            <section class="panel" aria-labelledby="timing-line">
              <h2 id="timing-line">{text.line}</h2>
              <LineForm texts={texts} mode={mode} text={text} set={set} />
            </section>
            <section class="panel" aria-labelledby="timing-frames">
              <h2 id="timing-frames">{text.exchange}</h2>
              <EntryField
                {...field}
                name="request"
                label={text.request(mode)}
                text={texts.request}
                entry={request}
                hint={text.requestHint(sizes.request)}
                section={SIZE_SECTION[mode]}
                placeholder={sizes.request?.toString()}
              />
              <EntryField
                {...field}
                name="reply"
                label={text.reply(mode)}
                text={texts.reply}
                entry={reply}
                hint={text.replyHint(texts.reply.trim() === '' ? sizes.source : 'typed', sizes.reply)}
                section={SIZE_SECTION[mode]}
                placeholder={sizes.reply?.toString()}
              />
              {answered ? (
                <EntryField
                  {...field}
                  name="delay"
                  label={text.delay}
                  text={texts.delay}
                  entry={delay}
                  hint={hint(delay, text.delayHint)}
                />
              ) : (
                <EntryField
                  {...field}
                  name="turnaround"
                  label={text.turnaround}
                  text={texts.turnaround}
                  entry={delay}
                  hint={hint(delay, `${text.turnaroundHint} ${words.section('SL 2.4.1')}`)}
                  section="SL 2.4.1"
                />
              )}
            </section>
            <section class="panel" aria-labelledby="timing-devices">
              <h2 id="timing-devices">{text.devices}</h2>
              <EntryField
                {...field}
                name="devices"
                label={text.devicesCount}
                text={texts.devices}
                entry={devices}
                hint={`${text.devicesHint} ${words.section('SL 2.2')}`}
                section="SL 2.2"
              />
              <EntryField {...field} name="missing" label={text.missing} text={texts.missing} entry={missing} />
              <EntryField
                {...field}
                name="timeout"
                label={text.timeout}
                text={texts.timeout}
                entry={timeout}
                hint={hint(timeout, `${text.timeoutHint} ${words.section('SL 2.4.1')}`)}
                section="SL 2.4.1"
              />
            </section>
          </div>
          <div class="stack">
            <SilencePanel line={line} mode={mode} text={text} />
            <ExchangePanel mode={mode} inputs={inputs} text={text} />
            <RoundPanel
              inputs={inputs}
              devices={knownOf(devices)}
              missing={knownOf(missing)}
              timeout={knownOf(timeout)}
              text={text}
            />
            <GapPanel texts={texts} line={line} mode={mode} text={text} set={set} />
          </div>
        </div>
        <SpeedTable texts={texts} baud={line?.baud} text={text} />
      </main>
    );
  }
}

type Sizes = readonly [request: Entry<number | undefined>, reply: Entry<number | undefined>, delay: Entry];

function inputsOf(line: SetLine | undefined, mode: SerialMode, sizes: Sizes): ExchangeInputs | undefined {
  const [request, reply, delay] = sizes.map(knownOf);
  const known = line !== undefined && request !== undefined && reply !== undefined && delay !== undefined;
  return known ? { line, mode, request, reply, delay } : undefined;
}

/** The time in other units, and a hint. */
function timeHint(entry: Entry, line: SetLine | undefined, text: TimingWords, said: string): string {
  const time = knownOf(entry);
  return time && line ? `${text.timeHint(time, time / bitsTime(line.baud, 1))} ${said}` : said;
}
