import { type MisprintedFrame, type MisprintedFrameId, misprintedFrames } from '../../diagnosis/index.ts';
import type { Transport } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import type { Draft, FrameKind } from '../frame/draft.ts';

/** The manuals and articles that the examples are from. */
export type SourceId = 'weg' | 's7-200' | 'i-8xx7' | 'introduction';

export type ExampleId =
  | 'weg-set-30-hz'
  | 'weg-run'
  | 'weg-stop'
  | 'weg-read-speed'
  | 'weg-speed'
  | 's7-200-read'
  | 's7-200-write'
  | 'i-8xx7-read-bits'
  | 'i-8xx7-bits'
  | 'i-8xx7-write-bit'
  | 'i-8xx7-bit-written'
  | 'i-8xx7-write-words'
  | 'i-8xx7-words-written'
  | 'i-8xx7-tcp-read-word'
  | 'i-8xx7-tcp-word'
  | 'i-8xx7-tcp-read-bits'
  | 'i-8xx7-tcp-bits'
  | 'introduction-read-40108'
  | 'introduction-40108'
  | 'introduction-read-401000'
  | 'introduction-401000';

/** A frame that a manual or an article shows. */
export interface Example {
  readonly id: ExampleId;
  readonly draft: Draft;
  /** The bytes as the source prints them, in hexadecimal: fewer than the frame has where it leaves the last ones out. */
  readonly printed: string;
  /** What is wrong with the printed bytes; absent if nothing is. */
  readonly fault?: MisprintedFrame['wrong'];
}

export interface ExampleSource {
  readonly id: SourceId;
  readonly examples: readonly Example[];
}

const of =
  (transport: Transport, kind: FrameKind) =>
  (texts: Draft['texts'], answering = ''): Draft => ({ transport, kind, texts, force: {}, answering });

const rtuRequest = of('rtu', 'request');
const rtuReply = of('rtu', 'reply');
const tcpRequest = of('tcp', 'request');
const tcpReply = of('tcp', 'reply');

/** What a source prints wrongly, as the diagnosis knows it. */
function misprinted(id: MisprintedFrameId): Pick<Example, 'id' | 'printed' | 'fault'> {
  const frame = misprintedFrames.find((each) => each.id === id);
  return { id, printed: formatBytes(frame?.printed ?? new Uint8Array()), ...(frame && { fault: frame.wrong }) };
}

/** The examples by their sources, each typed as its source speaks of it. */
export const exampleSources: readonly ExampleSource[] = [
  {
    id: 'weg',
    examples: [
      {
        draft: rtuRequest({ unitId: '6', functionCode: '6', address: '683', value: '4096' }),
        ...misprinted('weg-set-30-hz'),
      },
      {
        draft: rtuRequest({ unitId: '6', functionCode: '6', address: '682', value: '1' }),
        ...misprinted('weg-run'),
      },
      {
        draft: rtuRequest({ unitId: '6', functionCode: '6', address: '682', value: '0' }),
        ...misprinted('weg-stop'),
      },
      {
        draft: rtuRequest({ unitId: '6', functionCode: '3', startAddress: '681', quantity: '1' }),
        ...misprinted('weg-read-speed'),
      },
      {
        id: 'weg-speed',
        draft: rtuReply({ unitId: '6', functionCode: '3', registers: '4096' }, '06 03 02 A9 00 01 54 25'),
        printed: '06 03 02 10 00',
      },
    ],
  },
  {
    id: 's7-200',
    examples: [
      {
        id: 's7-200-read',
        draft: rtuRequest({ unitId: '1', functionCode: '3', startAddress: '0', quantity: '5' }),
        printed: '',
      },
      {
        id: 's7-200-write',
        draft: rtuRequest({ unitId: '1', functionCode: '16', startAddress: '5', registers: '1 2' }),
        printed: '',
      },
    ],
  },
  {
    id: 'i-8xx7',
    examples: [
      {
        id: 'i-8xx7-read-bits',
        draft: rtuRequest({ unitId: '1', functionCode: '1', startAddress: '0x1020', quantity: '15' }),
        printed: '01 01 10 20 00 0F 79 04',
      },
      {
        id: 'i-8xx7-bits',
        draft: rtuReply({ unitId: '1', functionCode: '1', bits: '00000000 0100100' }, '01 01 10 20 00 0F 79 04'),
        printed: '01 01 02 00 12 39 F1',
      },
      {
        id: 'i-8xx7-write-bit',
        draft: rtuRequest({ unitId: '1', functionCode: '5', address: '0x0006', value: '1' }),
        printed: '01 05 00 06 FF 00 6C 3B',
      },
      {
        id: 'i-8xx7-bit-written',
        draft: rtuReply({ unitId: '1', functionCode: '5', address: '0x0006', value: '1' }, '01 05 00 06 FF 00 6C 3B'),
        printed: '01 05 00 06 FF 00 6C 3B',
      },
      {
        id: 'i-8xx7-write-words',
        draft: rtuRequest({ unitId: '1', functionCode: '16', startAddress: '0x2100', registers: '0x1234 0x5678' }),
        printed: '01 10 21 00 00 02 04 12 34 56 78 1C CA',
      },
      {
        id: 'i-8xx7-words-written',
        draft: rtuReply(
          { unitId: '1', functionCode: '16', startAddress: '0x2100', quantity: '2' },
          '01 10 21 00 00 02 04 12 34 56 78 1C CA',
        ),
        printed: '01 10 21 00 00 02 4B F4',
      },
      {
        id: 'i-8xx7-tcp-read-word',
        draft: tcpRequest({
          transactionId: '0x0102',
          unitId: '9',
          functionCode: '3',
          startAddress: '4',
          quantity: '1',
        }),
        printed: '01 02 00 00 00 06 09 03 00 04 00 01',
      },
      {
        id: 'i-8xx7-tcp-word',
        draft: tcpReply(
          { transactionId: '0x0102', unitId: '9', functionCode: '3', registers: '8' },
          '01 02 00 00 00 06 09 03 00 04 00 01',
        ),
        printed: '01 02 00 00 00 05 09 03 02 00 08',
      },
      {
        id: 'i-8xx7-tcp-read-bits',
        draft: tcpRequest({
          transactionId: '0x0329',
          unitId: '7',
          functionCode: '1',
          startAddress: '2',
          quantity: '8',
        }),
        printed: '03 29 00 00 00 06 07 01 00 02 00 08',
      },
      {
        id: 'i-8xx7-tcp-bits',
        draft: tcpReply(
          { transactionId: '0x0329', unitId: '7', functionCode: '1', bits: '1001 0010' },
          '03 29 00 00 00 06 07 01 00 02 00 08',
        ),
        printed: '03 29 00 00 00 04 07 01 01 49',
      },
    ],
  },
  {
    id: 'introduction',
    examples: [
      {
        draft: rtuRequest({ unitId: '17', functionCode: '3', startAddress: '0x006B', quantity: '3' }),
        ...misprinted('introduction-read-40108'),
      },
      {
        id: 'introduction-40108',
        draft: rtuReply({ unitId: '17', functionCode: '3', registers: '555 0 100' }, '11 03 00 6B 00 03 76 87'),
        printed: '11 03 06 02 2B 00 00 00 64',
      },
      {
        id: 'introduction-read-401000',
        draft: rtuRequest({ unitId: '33', functionCode: '3', startAddress: '999', quantity: '4' }),
        printed: '21 03 03 E7 00 04 F3 1A',
      },
      {
        id: 'introduction-401000',
        draft: rtuReply(
          { unitId: '33', functionCode: '3', registers: '12345 54321 6666 8888' },
          '21 03 03 E7 00 04 F3 1A',
        ),
        printed: '21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18',
      },
    ],
  },
];
