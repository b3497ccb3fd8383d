import type { VNode } from 'preact';
import { type Checksum, checksum, checksums, crcChecksum } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import { AddressedView } from '../parts/addressed-view.ts';
import { Slot } from '../parts/slot.tsx';
import { evaluation } from '../parts/store.ts';
import { AlgorithmTable } from './algorithm-table.tsx';
import { loadCard } from './card/load-card.ts';
import './checksum.css';
import type { ChecksumValues } from '../../workbench/index.ts';
import {
  type AlgorithmRow,
  algorithmRow,
  checkedBytes,
  type InputKind,
  inputKinds,
  noOwn,
  type OwnTexts,
  polynomialKinds,
  readOwn,
  readSort,
  type Sort,
  sortText,
} from '../../workbench/index.ts';
import { loadWords, checksumWords as words } from './checksum-words.ts';
import { copied, copy } from './copied-value.tsx';
import { Digester, type Source } from './digest.ts';
import { INPUT, InputPanel } from './input-panel.tsx';
import { OwnPanel } from './own-panel.tsx';
import { Folded } from './remembered-fold.tsx';
import { ResultPanel } from './result-panel.tsx';
import { StepsPlace } from './steps-place.tsx';
import { WhichPanel } from './which-panel.tsx';

interface ChecksumState {
  /** What was typed; the current frame if the address has nothing. */
  readonly text: string;
  readonly kind: InputKind;
  /** The name of the algorithm, or `own`. */
  readonly algorithm: string;
  readonly search: string;
  readonly sort: Sort | undefined;
  readonly own: OwnTexts;
  /** The value of which the algorithm is looked for. */
  readonly claim: string;
  /** Stands in the place of what is typed; no address can hold it. */
  readonly file: File | undefined;
}

const MODBUS = checksums.find(({ name }) => name === 'CRC-16/MODBUS') as Checksum;
const LRC = checksums.find(({ name }) => name === 'LRC') as Checksum;
const OWN = 'own';

/** The view with its words. */
export async function load(): Promise<() => VNode> {
  await loadWords();
  return () => <ChecksumView />;
}

/** Any bytes, and every checksum over them. */
class ChecksumView extends AddressedView<object, ChecksumState> {
  protected readonly name = 'checksum';
  protected readonly title = words.title;
  private readonly digester = new Digester(() => this.forceUpdate());

  protected read(query: ReadonlyMap<string, string>): ChecksumState {
    const frame = checkedBytes(evaluation.value);
    const text = (name: string) => query.get(name) ?? '';
    return {
      text: query.get('bytes') ?? (frame ? formatBytes(frame.body) : ''),
      kind: inputKinds.find((kind) => kind === query.get('as')) ?? 'bytes',
      algorithm: query.get('algorithm') ?? MODBUS.name,
      search: text('search'),
      sort: readSort(query.get('sort')),
      own: {
        width: text('width'),
        poly: text('poly'),
        init: text('init'),
        xorout: text('xorout'),
        refin: query.has('refin'),
        refout: query.has('refout'),
        polyAs: polynomialKinds.find((kind) => kind === query.get('polyAs')) ?? noOwn.polyAs,
      },
      claim: text('claim'),
      file: undefined,
    };
  }

  protected write({ text, kind, algorithm, search, sort, own, claim }: ChecksumState) {
    return {
      bytes: text,
      as: kind === 'bytes' ? '' : kind,
      algorithm: algorithm === MODBUS.name ? '' : algorithm,
      search,
      sort: sortText(sort),
      ...own,
      refin: own.refin ? '1' : '',
      refout: own.refout ? '1' : '',
      polyAs: own.polyAs === noOwn.polyAs ? '' : own.polyAs,
      claim,
    };
  }

  override componentDidMount() {
    super.componentDidMount();
    copied.value = '';
    document.addEventListener('drop', this.takeDrop, true);
    document.addEventListener('paste', this.takePaste, true);
  }

  override componentWillUnmount() {
    super.componentWillUnmount();
    this.digester.stop();
    document.removeEventListener('drop', this.takeDrop, true);
    document.removeEventListener('paste', this.takePaste, true);
  }

  private readonly takeDrop = (event: DragEvent) => this.take(event, event.dataTransfer);
  private readonly takePaste = (event: ClipboardEvent) => this.take(event, event.clipboardData);

  /** What is dropped or pasted here is the input; elsewhere on the page it would be read as frames. */
  private take(event: Event, data: DataTransfer | null) {
    const file = data?.files[0];
    const typed = event.target instanceof Element && event.target.closest('input, textarea, select') !== null;
    const text = data?.getData('text/plain') ?? '';
    if (file === undefined && (typed || text === '')) return;
    event.preventDefault();
    event.stopPropagation();
    if (file) this.setState({ file });
    else this.change({ text, kind: 'bytes', file: undefined });
  }

  private rows: { readonly of: readonly unknown[]; readonly rows: readonly AlgorithmRow[] } = { of: [], rows: [] };

  /** The lines of the table; the same ones as long as nothing has changed. */
  private rowsOf(
    values: ChecksumValues | undefined,
    bytes: Uint8Array | undefined,
    own: Checksum | undefined,
  ): readonly AlgorithmRow[] {
    const of = [values, bytes, own?.name];
    if (this.rows.rows.length === 0 || of.some((one, index) => one !== this.rows.of[index])) {
      const named = checksums.map((one) => algorithmRow(one, one.name, values?.[one.name]));
      const ownValue = own && (bytes ? checksum(own, bytes) : values?.[own.name]);
      this.rows = { of, rows: own ? [algorithmRow(own, words.own, ownValue), ...named] : named };
    }
    return this.rows.rows;
  }

  private readonly type = (text: string) => this.change({ text });

  render() {
    const { text, kind, search, sort, own, claim, file } = this.state;
    const ownCrc = readOwn(own).crc;
    const ownChecksum = ownCrc && crcChecksum(ownCrc);
    const ownChosen = this.state.algorithm === OWN;
    const wanted = ownChosen ? ownChecksum : named(this.state.algorithm);
    const chosen = wanted ?? MODBUS;
    const source: Source = file ? { kind: 'file', file } : { kind: 'typed', text, as: kind };
    const digest = this.digester.of(source, chosen);
    const bytes = digest.kind === 'done' ? digest.reading?.bytes : undefined;
    const values = digest.kind === 'done' || digest.kind === 'computing' ? digest.values : undefined;
    const rows = this.rowsOf(values, bytes, ownChecksum);
    const of = ({ name }: Checksum) => rows.find(({ key }) => key === name) as AlgorithmRow;
    const shown = [MODBUS, LRC, ...(chosen === MODBUS || chosen === LRC ? [] : [chosen])].map(of);
    const onLeave = this.follow;
    return (
      <main class="checksum-view">
        <output class="copied">{copied.value}</output>
        <div class="columns">
          <InputPanel
            source={source}
            text={text}
            kind={kind}
            digest={digest}
            onText={this.type}
            onKind={(as) => this.change({ kind: as })}
            onFile={(next) => this.setState({ file: next })}
            onCancel={this.digester.cancel}
            onAgain={this.digester.again}
            onLeave={onLeave}
          />
          <ResultPanel digest={digest} shown={shown} />
        </div>
        {wanted === undefined && <p class="error">{words.unknown(this.state.algorithm, ownChosen, MODBUS.name)}</p>}
        {bytes && chosen.crc && <StepsPlace bytes={bytes} algorithm={chosen.crc} />}
        <Folded name="checksum-which" title={words.which} hint={words.whichHint} filled={claim !== ''}>
          {() => (
            <WhichPanel
              bytes={bytes}
              computing={digest.kind === 'computing'}
              claim={claim}
              onClaim={(next) => this.change({ claim: next })}
              onChoose={(algorithm) => this.change({ algorithm })}
              onLeave={onLeave}
            />
          )}
        </Folded>
        <Folded name="checksum-own" title={words.ownTitle} hint={words.ownHint} filled={own.width + own.poly !== ''}>
          {() => (
            <OwnPanel
              texts={own}
              chosen={chosen.crc}
              onTexts={(texts) => this.change({ own: texts })}
              onUse={() => this.change({ algorithm: OWN })}
              onLeave={onLeave}
            />
          )}
        </Folded>
        <Folded name="checksum-card" title={words.card} hint={words.cardHint}>
          {() => (
            <Slot
              part={loadCard}
              with={{
                onUse: (text, algorithm) => {
                  this.change({ text, kind: 'bytes', algorithm, file: undefined });
                  document.getElementById(INPUT)?.focus();
                },
                onCopy: (copyable, what) => void copy(copyable, what),
              }}
            />
          )}
        </Folded>
        <AlgorithmTable
          rows={rows}
          chosen={chosen.name}
          computing={digest.kind === 'computing'}
          search={search}
          sort={sort}
          onSearch={(next) => this.change({ search: next })}
          onSort={(next) => this.change({ sort: next })}
          onChoose={({ key }) => this.change({ algorithm: key === ownChecksum?.name ? OWN : key })}
          onLeave={onLeave}
        />
      </main>
    );
  }
}

/** The algorithm that has this name, or has it as an alias. */
const named = (name: string): Checksum | undefined =>
  checksums.find((one) => one.name === name) ?? checksums.find(({ aliases }) => aliases.includes(name));
