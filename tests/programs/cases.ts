import fc from 'fast-check';
import {
  decodeFrame,
  encodeFrame,
  type FrameInput,
  functionCodes,
  meiTypes,
  type Transport,
  type Values,
} from '../../src/modbus/index.ts';
import { builtInSequences, readSequence, type Sequence } from '../../src/sequences/index.ts';
import { legalFields } from '../unit/modbus/arbitraries.ts';

/** A request that a program is written for. `name` is unique. */
export interface ProgramCase {
  readonly name: string;
  readonly request: FrameInput;
}

/** For how long programs wait for a reply that is certain to come, in milliseconds: however much else the machine has to do. */
export const PATIENT = 60_000;

/** A reply to it, and what its check must answer: `fault` is anything but 0 or the code of an exception. */
export interface CaseReply {
  readonly what:
    | 'good'
    | 'exception'
    | 'wrong checksum'
    | 'short'
    | 'echo first'
    | 'other unit'
    | 'wrong count'
    | 'other function'
    | 'other transaction'
    | 'no reply';
  readonly bytes: Uint8Array;
  readonly result: number | 'fault';
  /** What the list is filled with, if the reply is good and has one. */
  readonly list: readonly number[] | undefined;
}

const UNIT = 17;
const TRANSACTION = 0x1234;

type Asked = Pick<FrameInput, 'functionCode' | 'fields'>;

/** At least one request of every function: the examples of the specification, and what is at an edge. */
const examples: readonly (readonly [string, number, Values])[] = [
  ['read coils', 0x01, { startAddress: 0x13, quantity: 0x13 }],
  ['read discrete inputs', 0x02, { startAddress: 0xc4, quantity: 0x16 }],
  ['read holding registers', 0x03, { startAddress: 0x6b, quantity: 3 }],
  ['read input registers', 0x04, { startAddress: 8, quantity: 1 }],
  ['read many registers', 0x03, { startAddress: 0, quantity: 125 }],
  ['write coil on', 0x05, { address: 0xac, value: true }],
  ['write coil off', 0x05, { address: 0xac, value: false }],
  ['write register', 0x06, { address: 1, value: 3 }],
  ['read exception status', 0x07, {}],
  ['return query data', 0x08, { subFunction: 0, data: 'A537' }],
  ['return long query data', 0x08, { subFunction: 0, data: 'A5370102' }],
  ['restart communications', 0x08, { subFunction: 1, data: 'FF00' }],
  ['return diagnostic register', 0x08, { subFunction: 2, data: '0000' }],
  ['listen only', 0x08, { subFunction: 4, data: '0000' }],
  ['bus message count', 0x08, { subFunction: 11, data: '0000' }],
  ['event counter', 0x0b, {}],
  ['event log', 0x0c, {}],
  ['write coils', 0x0f, { startAddress: 0x13, bits: [1, 0, 1, 1, 0, 0, 1, 1, 1, 0] }],
  ['write eight coils', 0x0f, { startAddress: 0, bits: [0, 1, 0, 1, 0, 1, 0, 1] }],
  ['write registers', 0x10, { startAddress: 1, registers: [10, 0x102] }],
  ['report server id', 0x11, {}],
  [
    'read file record',
    0x14,
    {
      subRequests: [
        { referenceType: 6, fileNumber: 4, recordNumber: 1, recordLength: 2 },
        { referenceType: 6, fileNumber: 3, recordNumber: 9, recordLength: 2 },
      ],
    },
  ],
  [
    'write file record',
    0x15,
    { subRequests: [{ referenceType: 6, fileNumber: 4, recordNumber: 7, recordData: [0x6af, 0x4be, 0x100d] }] },
  ],
  [
    'write many file records',
    0x15,
    {
      subRequests: [1, 2, 3, 4, 5].map((number) => ({
        referenceType: 6,
        fileNumber: number,
        recordNumber: 7,
        recordData: [number, 2],
      })),
    },
  ],
  ['mask write register', 0x16, { referenceAddress: 4, andMask: 0xf2, orMask: 0x25 }],
  [
    'read and write registers',
    0x17,
    { readStartAddress: 3, readQuantity: 6, writeStartAddress: 14, writeRegisters: [255, 255, 255] },
  ],
  ['read fifo queue', 0x18, { fifoPointerAddress: 0x4de }],
  ['canopen reference', 0x2b, { meiType: 0x0d, meiData: '01020304' }],
  ['read device identification', 0x2b, { meiType: 0x0e, readDeviceIdCode: 1, objectId: 0 }],
  ['read one object', 0x2b, { meiType: 0x0e, readDeviceIdCode: 4, objectId: 2 }],
];

const framed = (transport: Transport, { functionCode, fields }: Asked): FrameInput => ({
  transport,
  direction: 'request',
  unitId: UNIT,
  ...(transport === 'tcp' && { transactionId: TRANSACTION }),
  functionCode,
  fields,
});

/** Legal requests by chance, the same for the same seed. */
export const randomRequests = (transport: Transport, many: number, seed = 16): readonly ProgramCase[] => {
  const codes = functionCodes.map(({ code }) => code as number);
  const any = fc
    .constantFrom(...codes)
    .chain(
      (functionCode) =>
        legalFields[functionCode]?.request.map((fields) => ({ functionCode, fields })) ??
        fc.constant({ functionCode, fields: {} }),
    );
  return fc
    .sample(any, { seed, numRuns: many })
    .map((asked, index) => ({ name: `random ${index + 1}`, request: framed(transport, asked) }));
};

/** What every language is tried with: every function, a broadcast, forced and raw frames, and random requests. */
export function programCases(
  transport: 'rtu' | 'ascii' | 'tcp',
  random = process.env['PROGRAMS_FULL'] === '1' ? 200 : 20,
): readonly ProgramCase[] {
  const own = examples.map(([name, functionCode, fields]) => ({
    name,
    request: framed(transport, { functionCode, fields }),
  }));
  const special: readonly ProgramCase[] = [
    {
      name: 'broadcast',
      request: { ...framed(transport, { functionCode: 0x06, fields: { address: 1, value: 3 } }), unitId: 0 },
    },
    { name: 'raw function', request: framed(transport, { functionCode: 0x41, fields: { data: '010203' } }) },
    {
      name: 'wrong quantity',
      request: {
        ...framed(transport, { functionCode: 0x10, fields: { startAddress: 1, registers: [1] } }),
        force: { quantity: 2 },
      },
    },
  ];
  return [...own, ...special, ...randomRequests(transport, random)];
}

/** The sequences that come with the page. */
export const sequences: readonly Sequence[] = builtInSequences.map((texts) => {
  const reading = readSequence(texts);
  if (reading.kind !== 'sequence') throw new Error(`not a sequence: ${texts.name}`);
  return reading.sequence;
});

const words = (many: number) => Array.from({ length: many }, (_, index) => (0x1234 + 0x0f0f * index) & 0xffff);
const numberOf = (value: unknown) => Number(value);
const listOf = (value: unknown) => value as readonly Values[];

/** The fields of a good reply; `undefined` if nothing answers, or nobody knows how. */
function replyFields(code: number, fields: Values): Values | undefined {
  switch (code) {
    case 0x01:
    case 0x02: {
      const many = numberOf(fields['quantity']);
      // Unused bits are 0.
      return { bits: Array.from({ length: many }, (_, index) => (index % 3 === 0 ? 1 : 0)) };
    }
    case 0x03:
    case 0x04:
      return { registers: words(numberOf(fields['quantity'])) };
    case 0x07:
      return { outputData: 0x6d };
    case 0x08: {
      const counter = [2, 11, 12, 13, 14, 15, 16, 17, 18, 19].includes(numberOf(fields['subFunction']));
      return fields['subFunction'] === 4 ? undefined : counter ? { ...fields, data: '0102' } : fields;
    }
    case 0x0b:
      return { status: 0xffff, eventCount: 0x108 };
    case 0x0c:
      return { status: 0, eventCount: 0x108, messageCount: 0x121, events: [0x20, 0] };
    case 0x0f:
    case 0x10:
      return { startAddress: fields['startAddress'], quantity: fields['quantity'] };
    case 0x11:
      return { data: '01FF4142' };
    case 0x14:
      return {
        subResponses: listOf(fields['subRequests']).map(({ recordLength }) => ({
          referenceType: 6,
          recordData: words(numberOf(recordLength)),
        })),
      };
    case 0x17:
      return { registers: words(numberOf(fields['readQuantity'])) };
    case 0x18:
      return { fifoValues: [0x1b8, 0x1284] };
    case 0x2b:
      if (fields['meiType'] !== meiTypes[1].meiType) return { meiType: fields['meiType'], meiData: '0102' };
      return {
        meiType: 0x0e,
        readDeviceIdCode: fields['readDeviceIdCode'],
        conformityLevel: 1,
        moreFollows: 0,
        nextObjectId: 0,
        objects: [0, 1, 2].slice(0, fields['readDeviceIdCode'] === 4 ? 1 : 3).map((id) => ({
          objectId: fields['readDeviceIdCode'] === 4 ? fields['objectId'] : id,
          valueHex: '4142',
        })),
      };
    case 0x05:
    case 0x06:
    case 0x15:
    case 0x16:
      return fields;
    default:
      return { data: '0102' };
  }
}

/** Functions whose reply has a count that the request decides, with the field that is asked for. */
const COUNTED: Readonly<Record<number, string>> = {
  1: 'quantity',
  2: 'quantity',
  3: 'quantity',
  4: 'quantity',
  23: 'readQuantity',
};

const faults = {
  'too short': -1,
  'other unit': -3,
  'other function': -4,
  'wrong count': -5,
  'wrong checksum': -7,
  'no reply': -8,
  'other transaction': -10,
} as const;

/** The replies that a check of this request is tried with; none if nothing answers it. */
export function repliesTo(request: FrameInput): readonly CaseReply[] {
  const { transport, functionCode = 0, unitId = 0 } = request;
  const sent = encodeFrame(request);
  const { fields: chosen, derived } = decodeFrame(sent, { transport, direction: 'request' });
  const asked: Values = { ...derived, ...chosen };
  const fields = replyFields(functionCode, asked);
  if (fields === undefined || (unitId === 0 && transport !== 'tcp')) return [];
  const reply: FrameInput = {
    transport,
    direction: 'response',
    unitId,
    transactionId: request.transactionId,
    functionCode,
    fields,
  };
  const good = encodeFrame(reply);
  const list = decodeFrame(good, { transport, direction: 'response', request: sent }).fields;
  const records = (list['subResponses'] as readonly { recordData: readonly number[] }[] | undefined)?.flatMap(
    ({ recordData }) => recordData,
  );
  const found =
    ['registers', 'bits', 'events', 'fifoValues'].map((name) => list[name]).find(Array.isArray) ??
    (functionCode === 0x14 ? records : undefined);
  const bad = (what: CaseReply['what'], bytes: Uint8Array, result: number | 'fault'): CaseReply => ({
    what,
    bytes,
    result,
    list: undefined,
  });
  const refused = encodeFrame({ ...reply, functionCode: functionCode | 0x80, fields: { exceptionCode: 2 } });
  // With the checksum made right, so that only what is said is wrong.
  const otherFunction = functionCode === 0x06 ? 0x05 : 0x06;
  const other = encodeFrame({
    ...reply,
    functionCode: otherFunction,
    fields: { address: 1, value: otherFunction === 5 ? true : 3 },
  });
  const name = COUNTED[functionCode];
  const many = name === undefined ? 0 : numberOf(asked[name]);
  const fewer = name !== undefined && many > 8 ? replyFields(functionCode, { ...asked, [name]: many - 8 }) : undefined;
  return [
    { what: 'good', bytes: good, result: 0, list: found },
    bad('exception', refused, 2),
    bad('no reply', new Uint8Array(), faults['no reply']),
    bad(
      'short',
      good.subarray(0, good.length - 1),
      functionCode === 0x08 || functionCode === 0x2b || functionCode === 0x41 ? 'fault' : faults['too short'],
    ),
    bad('echo first', Uint8Array.of(...sent, ...good), 'fault'),
    bad('other unit', encodeFrame({ ...reply, unitId: unitId ^ 1 }), faults['other unit']),
    bad('other function', other, faults['other function']),
    ...(transport === 'tcp'
      ? []
      : [
          bad(
            'wrong checksum',
            encodeFrame({ ...reply, force: { checksum: wrongChecksum(reply) } }),
            faults['wrong checksum'],
          ),
        ]),
    ...(transport === 'tcp'
      ? [
          bad(
            'other transaction',
            encodeFrame({ ...reply, transactionId: numberOf(request.transactionId ?? 0) ^ 1 }),
            faults['other transaction'],
          ),
        ]
      : []),
    ...(fewer === undefined
      ? []
      : [bad('wrong count', encodeFrame({ ...reply, fields: fewer }), faults['wrong count'])]),
  ];
}

/** The checksum with one bit wrong. */
function wrongChecksum(reply: FrameInput): number {
  const { derived } = decodeFrame(encodeFrame(reply), { transport: reply.transport, direction: 'response' });
  return numberOf(derived['checksum']) ^ 1;
}
