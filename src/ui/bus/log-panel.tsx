import { computed, type ReadonlySignal, useComputed } from '@preact/signals';
import { useMemo, useState } from 'preact/hooks';
import {
  type LogLine,
  logAsCsv,
  logAsJson,
  logAsPcapng,
  logAsText,
  logFromJson,
  logFromPcapng,
  logFromRows,
  MOST_LINES,
} from '../../bus/index.ts';
import { type BusView, MOST_KEPT } from '../../store/index.ts';
import { csvRows, LineSearch, type LogFilter, lineBytes, lineReading } from '../../workbench/index.ts';
import { optionsOf, Select } from '../kit/choice.tsx';
import { disabledFor } from '../kit/disabled-for.ts';
import { download, timedName } from '../kit/download.ts';
import { FileButton } from '../kit/file-button.tsx';
import { useSteady } from '../parts/steady.ts';
import { page } from '../parts/store.ts';
import { useWords } from '../parts/words.ts';
import { bus } from './bus.ts';
import { LogList, type LogWords } from './log-list.tsx';

/** Files that a log is saved as. */
const FORMATS = {
  text: { type: 'text/plain', ending: 'txt', write: logAsText },
  csv: { type: 'text/csv', ending: 'csv', write: logAsCsv },
  json: { type: 'application/json', ending: 'json', write: logAsJson },
  pcapng: { type: 'application/octet-stream', ending: 'pcapng', write: logAsPcapng },
} as const;
type Format = keyof typeof FORMATS;

function save(lines: readonly LogLine[], format: Format): void {
  const { type, ending, write } = FORMATS[format];
  download(write(lines), timedName('modbus', ending), type);
}

/** Everything that was sent and received. */
export function LogPanel({ view }: { readonly view: BusView }) {
  const { log: text } = useWords('bus');
  const { summary } = useWords('page').page;
  const words = useMemo((): LogWords => ({ ...text, frame: summary }), [text, summary]);
  const [filter, setFilter] = useState<LogFilter>('all');
  const [follow, setFollow] = useState(true);
  /** What was shown when somebody pressed Pause. */
  const [paused, setPaused] = useState<readonly LogLine[]>();
  const [unreadable, setUnreadable] = useState<string>();
  const { all, lines } = useMemo(() => {
    const search = computed(() => new LineSearch(filter, view.shown.value.search, words));
    const all = computed(() => {
      bus.log.revision.value;
      return paused ?? bus.log.lines;
    });
    return { all, lines: computed(() => search.value.shown(all.value)) };
  }, [filter, paused, view, words]);

  const open = async (file: File) => {
    const read = await logOf(new Uint8Array(await file.arrayBuffer()));
    const found = read !== undefined && read.length > 0;
    setUnreadable(found ? undefined : file.name);
    if (!found) return;
    bus.log.open(read);
    setFollow(false);
    setPaused(undefined);
  };

  return (
    <section class="panel log" aria-labelledby="log">
      <h2 id="log">{text.heading}</h2>
      <Count all={all} lines={lines} />
      <div class="tools in-row">
        <label>
          {text.show} <Select value={filter} options={optionsOf(text.filters)} onChoose={setFilter} />
        </label>
        <Search view={view} />
        <label>
          <input type="checkbox" checked={follow} onChange={({ currentTarget }) => setFollow(currentTarget.checked)} />{' '}
          {text.follow}
        </label>
        <button
          type="button"
          aria-pressed={paused !== undefined}
          onClick={() => setPaused(paused ? undefined : bus.log.lines)}
        >
          {text.pause}
        </button>
        <ClearButton />
      </div>
      <Lines all={all} lines={lines} words={words} follow={follow && paused === undefined} />
      <div class="tools in-row">
        <span>{text.save}</span>
        <SaveButtons lines={lines} />
        <FileButton label={text.open} accept=".json,.csv,.pcapng" onFile={(file) => void open(file)} />
      </div>
      <p class="said" role="status">
        {unreadable !== undefined && <span class="error">{text.unreadable(unreadable)}</span>}
      </p>
    </section>
  );
}

interface LinesProps {
  readonly all: ReadonlySignal<readonly LogLine[]>;
  /** Those that are shown. */
  readonly lines: ReadonlySignal<readonly LogLine[]>;
}

function Search({ view }: { readonly view: BusView }) {
  const text = useWords('bus').log;
  return (
    <label>
      {text.search}{' '}
      <input
        type="search"
        value={view.shown.value.search}
        placeholder={text.searchHint}
        autocomplete="off"
        spellcheck={false}
        onInput={({ currentTarget }) => view.change({ search: currentTarget.value })}
      />
    </label>
  );
}

function ClearButton() {
  const text = useWords('bus').log;
  const isEmpty = useComputed(() => {
    bus.log.revision.value;
    return bus.log.lines.length === 0;
  });
  return bus.log.cleared.value ? (
    <button type="button" onClick={() => bus.log.bringBack()}>
      {text.undo}
    </button>
  ) : (
    <button type="button" {...disabledFor(isEmpty.value ? text.empty : undefined)} onClick={() => bus.log.clear()}>
      {text.clear}
    </button>
  );
}

function Count({ all, lines }: LinesProps) {
  const text = useWords('bus').log;
  const count = all.value.length;
  const restored = bus.log.restored.value;
  return (
    <span class="said" aria-live="off">
      {count > 0 && text.of(lines.value.length, count)} {count >= MOST_LINES && text.oldest(MOST_LINES)}{' '}
      {restored > 0 && text.restored(restored)} {count > 1000 && text.survives(MOST_KEPT)}
    </span>
  );
}

function Lines({ all, lines, words, follow }: LinesProps & { readonly words: LogWords; readonly follow: boolean }) {
  const text = useWords('bus').log;
  if (lines.value.length === 0) return <p class="said none">{all.value.length === 0 ? text.empty : text.nothing}</p>;
  return <LogList lines={lines.value} words={words} follow={follow} onOpen={openLine} />;
}

function SaveButtons({ lines }: Pick<LinesProps, 'lines'>) {
  const { formats, nothing } = useWords('bus').log;
  const isEmpty = useSteady(() => lines.value.length === 0, [lines]);
  return (Object.keys(FORMATS) as Format[]).map((format) => (
    <button
      key={format}
      type="button"
      {...disabledFor(isEmpty.value ? nothing : undefined)}
      onClick={() => save(lines.peek(), format)}
    >
      {formats[format]}
    </button>
  ));
}

/** Shows the frame of a line in the Frame view. */
function openLine(line: LogLine): void {
  const asked = line.answers === undefined ? undefined : bus.log.lines.find(({ number }) => number === line.answers);
  const request = asked && lineBytes(asked);
  const reading = lineReading(line, request);
  if (reading) page.showReading(reading, request, 'step');
}

/** The log in a file: one that this page has saved, or a table that has been through a spreadsheet since. */
async function logOf(bytes: Uint8Array): Promise<LogLine[] | undefined> {
  const text = new TextDecoder().decode(bytes);
  const lines = logFromPcapng(bytes) ?? logFromJson(text);
  if (lines) return lines;
  const { parseCsv } = await import('../parts/csv.ts');
  const plain = text.replace(/^\uFEFF/, '');
  for (const delimiter of [',', ';', '\t']) {
    const rows = logFromRows(csvRows(plain, delimiter, parseCsv).map(({ cells }) => cells));
    if (rows) return rows;
  }
  return undefined;
}
