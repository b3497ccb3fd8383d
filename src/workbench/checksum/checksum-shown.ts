import { type Checksum, checksums, crcChecksum } from '../../modbus/index.ts';
import { readSort, type Sort, sortText } from './algorithm-rows.ts';
import { type InputKind, inputKinds } from './checksum-input.ts';
import { noOwn, type OwnTexts, polynomialKinds, readOwn } from './own-algorithm.ts';

/** What the Checksum view shows, as typed. */
export interface ChecksumShown {
  readonly text: string;
  readonly kind: InputKind;
  /** The name of the algorithm, or `own`. */
  readonly algorithm: string;
  readonly search: string;
  readonly sort: Sort | undefined;
  readonly own: OwnTexts;
  /** The value of which the algorithm is looked for. */
  readonly claim: string;
}

/** The CRC of RTU frames, which stands for any algorithm that is not known. */
export const CRC_MODBUS = checksums.find(({ name }) => name === 'CRC-16/MODBUS') as Checksum;
/** The LRC of ASCII frames. */
export const LRC = checksums.find(({ name }) => name === 'LRC') as Checksum;

/** What the parts of an address show; `text` is the input if the address has none. */
export function readChecksumParts(parts: ReadonlyMap<string, string>, text: string): ChecksumShown {
  const part = (name: string) => parts.get(name) ?? '';
  return {
    text: parts.get('bytes') ?? text,
    kind: inputKinds.find((kind) => kind === part('as')) ?? 'bytes',
    algorithm: parts.get('algorithm') ?? CRC_MODBUS.name,
    search: part('search'),
    sort: readSort(part('sort')),
    own: {
      width: part('width'),
      poly: part('poly'),
      init: part('init'),
      xorout: part('xorout'),
      refin: parts.has('refin'),
      refout: parts.has('refout'),
      polyAs: polynomialKinds.find((kind) => kind === part('polyAs')) ?? noOwn.polyAs,
    },
    claim: part('claim'),
  };
}

/** The parts of the address that shows this; what is usual is left empty. */
export function checksumParts({ text, kind, algorithm, search, sort, own, claim }: ChecksumShown) {
  return {
    bytes: text,
    as: kind === 'bytes' ? '' : kind,
    algorithm: algorithm === CRC_MODBUS.name ? '' : algorithm,
    search,
    sort: sortText(sort),
    ...own,
    refin: own.refin ? '1' : '',
    refout: own.refout ? '1' : '',
    polyAs: own.polyAs === noOwn.polyAs ? '' : own.polyAs,
    claim,
  };
}

/** The checksum with own parameters; `undefined` while they do not make one. */
export function ownChecksum(texts: OwnTexts): Checksum | undefined {
  const { crc } = readOwn(texts);
  return crc && crcChecksum(crc);
}

/** The checksum of a name or alias, a person's own among them; `undefined` if no checksum is called so. */
export const checksumNamed = (name: string, own: Checksum | undefined): Checksum | undefined =>
  name === 'own'
    ? own
    : (checksums.find((one) => one.name === name) ?? checksums.find(({ aliases }) => aliases.includes(name)));
