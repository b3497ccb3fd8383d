import type { Section, SerialMode } from '../../modbus/index.ts';
import { KeptChoice, TimingView } from '../../store/index.ts';
import { firstTimingTexts, storedTexts, type TimingTexts } from '../../workbench/index.ts';
import { line } from '../parts/line.ts';
import { page, storage } from '../parts/store.ts';
import { useView, type ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import { EntryField, TimeField } from './entry-field.tsx';
import { ExchangePanel, RoundPanel } from './exchange-panel.tsx';
import { GapPanel } from './gap-panel.tsx';
import { LineForm } from './line-form.tsx';
import { SilencePanel } from './silence-panel.tsx';
import { SpeedTable } from './speed-table.tsx';
import './timing.css';

/** The devices as typed last. */
const lastTexts = new KeptChoice<TimingTexts>(storage, 'timing', firstTimingTexts, storedTexts);

/** Where the most characters of a frame stand. */
const SIZE_SECTION: Readonly<Record<SerialMode, Section>> = { rtu: 'SL 2.5.1', ascii: 'SL 2.5.2.1' };

/** How long characters, silences, exchanges and rounds take on a serial line. */
export function TimingPanels() {
  const { title } = useWords('timing');
  const view = useView(title, () => new TimingView(page, lastTexts, line));
  return (
    <main class="timing" onFocusOut={() => page.address.now()}>
      <div class="columns">
        <div class="stack">
          <LineForm view={view} />
          <FramesForm view={view} />
          <DevicesForm view={view} />
        </div>
        <div class="stack">
          <SilencePanel view={view} />
          <ExchangePanel view={view} />
          <RoundPanel view={view} />
          <GapPanel view={view} />
        </div>
      </div>
      <SpeedTable view={view} />
    </main>
  );
}

/** How long the frames of the exchange are, and what is between them. */
function FramesForm({ view }: ViewProps<TimingView>) {
  const text = useWords('timing');
  const { mode, sizes, answered } = view.reading.value;
  const source = view.shown.value.reply.trim() === '' ? sizes.source : 'typed';
  return (
    <section class="panel" aria-labelledby="timing-frames">
      <h2 id="timing-frames">{text.exchange}</h2>
      <EntryField
        view={view}
        name="request"
        label={text.request(mode)}
        hint={text.requestHint(sizes.request)}
        section={SIZE_SECTION[mode]}
        placeholder={sizes.request?.toString()}
      />
      <EntryField
        view={view}
        name="reply"
        label={text.reply(mode)}
        hint={text.replyHint(source, sizes.reply)}
        section={SIZE_SECTION[mode]}
        placeholder={sizes.reply?.toString()}
      />
      {answered ? (
        <TimeField view={view} name="delay" label={text.delay} hint={text.delayHint} />
      ) : (
        <TimeField
          view={view}
          name="turnaround"
          label={text.turnaround}
          hint={text.turnaroundHint}
          section="SL 2.4.1"
        />
      )}
    </section>
  );
}

function DevicesForm({ view }: ViewProps<TimingView>) {
  const text = useWords('timing');
  const { section } = useWords('page');
  return (
    <section class="panel" aria-labelledby="timing-devices">
      <h2 id="timing-devices">{text.devices}</h2>
      <EntryField
        view={view}
        name="devices"
        label={text.devicesCount}
        hint={`${text.devicesHint} ${section('SL 2.2')}`}
        section="SL 2.2"
      />
      <EntryField view={view} name="missing" label={text.missing} />
      <TimeField view={view} name="timeout" label={text.timeout} hint={text.timeoutHint} section="SL 2.4.1" />
    </section>
  );
}
