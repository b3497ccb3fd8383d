import { computed, effect } from '@preact/signals-core';
import { type Checksum, checksum, checksums } from '../modbus/index.ts';
import { formatBytes } from '../notation/index.ts';
import {
  algorithmRow,
  type ChecksumShown,
  CRC_MODBUS,
  checkedBytes,
  checksumNamed,
  checksumParts,
  finder,
  LRC,
  ownChecksum,
  readChecksumParts,
  sortedRows,
} from '../workbench/index.ts';
import { AddressedView } from './addressed-view.ts';
import { Digester, type DigestWorkers, type Source, type WholeFile } from './digester.ts';
import type { Page } from './page.ts';

/** What the Checksum view shows; a file stands in the place of what is typed, and no address can hold it. */
interface Shown extends ChecksumShown {
  readonly file: WholeFile | undefined;
}

/** The Checksum view: any bytes, and every checksum over them. It begins with the current frame. */
export class ChecksumView extends AddressedView<Shown> {
  /** The current frame without its checksum, and with it; `undefined` if there is no frame. */
  readonly frame;
  readonly search = computed(() => this.shown.value.search);
  readonly sort = computed(() => this.shown.value.sort);
  readonly #ownTexts = computed(() => this.shown.value.own);
  /** The checksum with own parameters, if they make one. */
  readonly own = computed(() => ownChecksum(this.#ownTexts.value));
  /** The chosen checksum, if the name in the address is one. */
  readonly wanted = computed(() => checksumNamed(this.shown.value.algorithm, this.own.value));
  readonly chosen = computed((): Checksum => this.wanted.value ?? CRC_MODBUS);
  readonly source = computed((): Source => {
    const { file, text, kind } = this.shown.value;
    return file ? { kind: 'file', file } : { kind: 'typed', text, as: kind };
  });
  readonly digest;
  readonly computing = computed(() => this.digest.value.kind === 'computing');
  /** The input; `undefined` while it is read, or if it is too large to be held in memory. */
  readonly bytes = computed(() => {
    const { value } = this.digest;
    return value.kind === 'done' ? value.reading?.bytes : undefined;
  });
  readonly #values = computed(() => {
    const { value } = this.digest;
    return value.kind === 'done' || value.kind === 'computing' ? value.values : undefined;
  });
  /** All algorithms with their values, the own one first. */
  readonly rows = computed(() => {
    const [values, bytes, own] = [this.#values.value, this.bytes.value, this.own.value];
    const named = checksums.map((one) => algorithmRow(one, one.name, values?.[one.name]));
    const ownValue = own && (bytes ? checksum(own, bytes) : values?.[own.name]);
    return own ? [algorithmRow(own, this.#ownName, ownValue), ...named] : named;
  });
  /** Those that the search finds, in the order that was chosen. */
  readonly found = computed(() => sortedRows(this.rows.value, this.sort.value).filter(finder(this.search.value)));
  /** CRC-16/MODBUS, the LRC, and the chosen algorithm. */
  readonly results = computed(() =>
    [...new Set([CRC_MODBUS, LRC, this.chosen.value])].flatMap(({ name }) =>
      this.rows.value.filter(({ key }) => key === name),
    ),
  );
  readonly #digester: Digester;
  readonly #ownName: string;
  readonly #stopDigesting: () => void;

  /** @param ownName what the algorithm with own parameters is called */
  constructor(page: Page, workers: DigestWorkers, ownName: string) {
    const frame = computed(() => checkedBytes(page.evaluation.value));
    const body = () => (frame.value ? formatBytes(frame.value.body) : '');
    super(
      page,
      'checksum',
      (parts) => ({ ...readChecksumParts(parts, body()), file: undefined }),
      (shown) => checksumParts(shown),
    );
    this.frame = frame;
    this.#ownName = ownName;
    this.#digester = new Digester(workers);
    this.digest = this.#digester.digest;
    this.#stopDigesting = effect(() => {
      const [source, chosen] = [this.source.value, this.chosen.value];
      // Once a large file is read, an algorithm that was chosen meanwhile is still to be calculated.
      if (this.digest.value) this.#digester.take(source, chosen);
    });
  }

  /** Takes bytes as the input. */
  readonly takeBytes = (bytes: Uint8Array): void => this.takeText(formatBytes(bytes));

  readonly takeText = (text: string): void => this.change({ text, kind: 'bytes', file: undefined });

  /** Chooses a row of `rows`. */
  readonly choose = (key: string): void => this.change({ algorithm: key === this.own.value?.name ? 'own' : key });

  /** Gives up reading; what was known before is gone too. */
  readonly cancel = (): void => this.#digester.cancel();

  /** Reads the input once more. */
  readonly again = (): void => this.#digester.again();

  override stop(): void {
    super.stop();
    this.#stopDigesting();
    this.#digester.stop();
  }
}
