import { Component } from 'preact';
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
import { csvRows, type LogFilter, lineBytes, lineReading, shownLines } from '../../workbench/index.ts';
import { optionsOf, Select } from '../kit/choice.tsx';
import { download } from '../kit/download.ts';
import { FileButton } from '../kit/file-button.tsx';
import { page } from '../parts/store.ts';
import { type BusState, bus } from './bus.ts';
import { lineWords, busWords as words } from './bus-words.ts';
import { LogList } from './log-list.tsx';

interface PanelProps {
  readonly state: BusState;
  readonly search: string;
  readonly onSearch: (search: string) => void;
}

interface PanelState {
  readonly filter: LogFilter;
  readonly follow: boolean;
  /** What was shown when somebody pressed Pause. */
  readonly paused: readonly LogLine[] | undefined;
  readonly fault: string | undefined;
}

/** Files that a log is saved as. */
const FORMATS = {
  text: { type: 'text/plain', ending: 'txt', write: logAsText },
  csv: { type: 'text/csv', ending: 'csv', write: logAsCsv },
  json: { type: 'application/json', ending: 'json', write: logAsJson },
  pcapng: { type: 'application/octet-stream', ending: 'pcapng', write: logAsPcapng },
} as const;
type Format = keyof typeof FORMATS;

/** Everything that was sent and received. */
export class LogPanel extends Component<PanelProps, PanelState> {
  override state: PanelState = { filter: 'all', follow: true, paused: undefined, fault: undefined };

  private readonly open = (line: LogLine) => {
    const { log } = this.props.state;
    const asked = line.answers === undefined ? undefined : log.find(({ number }) => number === line.answers);
    const request = asked && lineBytes(asked);
    const reading = lineReading(line, request);
    if (reading) page.showReading(reading, request, 'step');
  };

  private save(lines: readonly LogLine[], format: Format) {
    const { type, ending, write } = FORMATS[format];
    const time = new Date().toISOString().slice(0, 19).replaceAll(':', '');
    download(write(lines), `modbus-${time}.${ending}`, type);
  }

  private readonly load = async (file: File) => {
    const bytes = new Uint8Array(await file.arrayBuffer());
    const text = new TextDecoder().decode(bytes);
    const lines = logFromPcapng(bytes) ?? logFromJson(text) ?? (await logFromCsv(text));
    if (lines === undefined || lines.length === 0) this.setState({ fault: words.log.unreadable(file.name) });
    else {
      bus.openLog(lines);
      this.setState({ fault: undefined, follow: false, paused: undefined });
    }
  };

  render() {
    const { state, search, onSearch } = this.props;
    const { filter, follow, paused, fault } = this.state;
    const all = paused ?? state.log;
    const lines = shownLines(all, filter, search, lineWords);
    const text = words.log;
    return (
      <section class="panel log" aria-labelledby="log">
        <h2 id="log">{text.heading}</h2>
        <div class="tools">
          <label>
            {text.show}{' '}
            <Select
              value={filter}
              options={optionsOf(text.filters)}
              onChoose={(chosen) => this.setState({ filter: chosen })}
            />
          </label>
          <label>
            {text.search}{' '}
            <input
              type="search"
              value={search}
              placeholder={text.searchHint}
              autocomplete="off"
              spellcheck={false}
              onInput={({ currentTarget }) => onSearch(currentTarget.value)}
            />
          </label>
          <label>
            <input
              type="checkbox"
              checked={follow}
              onChange={({ currentTarget }) => this.setState({ follow: currentTarget.checked })}
            />{' '}
            {text.follow}
          </label>
          <button
            type="button"
            aria-pressed={paused !== undefined}
            onClick={() => this.setState({ paused: paused ? undefined : state.log })}
          >
            {text.pause}
          </button>
          {state.cleared ? (
            <button type="button" onClick={() => bus.bringLogBack()}>
              {text.undo}
            </button>
          ) : (
            <button type="button" disabled={state.log.length === 0} onClick={() => bus.clearLog()}>
              {text.clear}
            </button>
          )}
        </div>
        <p class="said" aria-live="off">
          {all.length > 0 && text.of(lines.length, all.length)} {all.length >= MOST_LINES && text.oldest(MOST_LINES)}
        </p>
        {lines.length > 0 ? (
          <LogList lines={lines} follow={follow && paused === undefined} onOpen={this.open} />
        ) : (
          <p class="said">{all.length === 0 ? text.empty : text.nothing}</p>
        )}
        <div class="tools">
          <span>{text.save}</span>
          {(Object.keys(FORMATS) as Format[]).map((format) => (
            <button key={format} type="button" disabled={lines.length === 0} onClick={() => this.save(lines, format)}>
              {text.formats[format]}
            </button>
          ))}
          <FileButton label={text.open} accept=".json,.csv,.pcapng" onFile={(file) => void this.load(file)} />
        </div>
        <p class="said" role="status">
          {fault && <span class="error">{fault}</span>}
        </p>
      </section>
    );
  }
}

/** A table saved by this page, or by the spreadsheet it went through. */
async function logFromCsv(text: string): Promise<LogLine[] | undefined> {
  const { parseCsv } = await import('../parts/csv.ts');
  const plain = text.replace(/^\uFEFF/, '');
  for (const delimiter of [',', ';', '\t']) {
    const lines = logFromRows(csvRows(plain, delimiter, parseCsv).map(({ cells }) => cells));
    if (lines) return lines;
  }
  return undefined;
}
