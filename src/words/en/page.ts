import type { CodeRange, Direction, Reading, Section, Severity, Transport } from '../../modbus/index.ts';
import type { FrameTab } from '../../workbench/index.ts';
import { code, codeWithin, plural } from './numbers.ts';

const transports: Readonly<Record<Transport, string>> = { rtu: 'RTU', ascii: 'ASCII', tcp: 'TCP', pdu: 'PDU' };
const directions: Readonly<Record<Direction, string>> = { request: 'request', response: 'reply' };
const severities: Readonly<Record<Severity, string>> = { error: 'Error', warning: 'Warning', note: 'Note' };

const codeRanges: Readonly<Record<CodeRange, string>> = {
  public: 'public',
  'user-defined': 'user-defined',
  reserved: 'reserved',
  unassigned: 'not assigned',
  zero: 'not valid',
  exception: 'the range of exceptions',
};

/** A function, a part of one, or a code without a name. */
export interface FunctionShown {
  readonly code: number;
  readonly part?: number | undefined;
  readonly name?: string | undefined;
  readonly range?: CodeRange | undefined;
  readonly serialOnly?: boolean | undefined;
}

/** The labels and sentences of the page itself. */
export const page = {
  transports,
  directions,
  transportHints: {
    rtu: 'Serial line, and RTU over TCP',
    ascii: 'Serial line, as characters',
    tcp: 'Modbus TCP, with MBAP header',
    pdu: 'Function code and data alone',
  } satisfies Record<Transport, string>,
  severities,
  build: 'Build',
  transport: 'Transport',
  kind: 'Kind of frame',
  kinds: { request: 'Request', reply: 'Reply', exception: 'Exception' },
  functionLabel: 'Function',
  /** A function as it is offered: its codes in both bases, and its name or who it is for. */
  functionIn: ({ code: of, part, name, range, serialOnly }: FunctionShown): string => {
    const codes = part === undefined ? code(of) : codeWithin(of, part);
    return `${codes}${name === undefined ? '' : ` ${name}`}${range === undefined ? '' : `, ${codeRanges[range]}`}${serialOnly ? ' (serial line only)' : ''}`;
  },
  noFunction: 'No function matches.',
  exceptionTo: 'Function that was refused',
  device: {
    label: 'Device',
    none: 'none',
    chosen: (name: string) => `Device: ${name}`,
  },
  bytes: 'The frame',
  everyByte: 'Every byte',
  tabs: {
    label: 'Of this frame',
    names: {
      bytes: 'Bytes',
      values: 'Values',
      reply: 'Reply',
      wire: 'On the wire',
      crc: 'CRC',
      compare: 'Compare',
      program: 'Program',
    } satisfies Record<FrameTab, string>,
  },
  panels: {
    device: { title: 'Device', intro: undefined },
  },
  writeValues: 'Write as typed values',
  columns: { byte: 'byte', hex: 'hex', decimal: 'dec.', bits: 'bits', means: 'means', section: 'section' },
  characterColumn: 'char.',
  legal: (least: number, most: number) => `legal ${least} to ${most}`,
  derived: 'calculated',
  force: 'Force…',
  forceField: (label: string) => `Force ${label}`,
  forced: 'forced',
  unforce: 'Calculate again',
  unforceField: (label: string) => `Calculate again: ${label}`,
  codeRanges,
  add: 'Add',
  remove: 'Remove',
  on: 'ON, FF 00',
  off: 'OFF, 00 00',
  other: 'Another value…',
  high: 'hi',
  low: 'lo',
  codeIn: code,
  summary: ({ functionCode = 0, description, unitId }: Reading, size: number, transport: Transport): string => {
    const name =
      functionCode > 0x7f
        ? `Exception to function ${code(functionCode & 0x7f)}`
        : `${code(functionCode)} ${description?.name ?? ''}`;
    const unit = unitId === undefined ? '' : `, unit ${unitId}`;
    return `${name}${unit}, ${plural(size, transport === 'ascii' ? 'character' : 'byte')}`;
  },
};

/** What the section of a rule is called. */
export function section(of: Section): string {
  const [document, ...rest] = of.split(' ');
  const place = rest.join(' ').replace(/^(?=\d)/, '§');
  switch (document) {
    case 'SL':
      return `Serial Line ${place}`;
    case 'TG':
      return `TCP guide ${place}`;
    case 'PI':
      return `Modicon guide ${place}`;
    default:
      return place;
  }
}
