import { makeCase } from '../../../src/diagnosis/case.ts';
import { ofOthers, ofSoundFrames } from '../../../src/diagnosis/hypotheses/index.ts';
import {
  type DiagnoseContext,
  diagnose,
  type Finding,
  type IdentifyContext,
  identify,
  type Reason,
} from '../../../src/diagnosis/index.ts';
import type { Direction, Transport } from '../../../src/modbus/index.ts';
import { characters, hex } from '../modbus/frames.ts';
import { spaced } from './findings.ts';

/** Bytes and what is known beside them, as `tests/vectors/diagnosed.txt` writes them down. */
export interface Pinned {
  readonly what: string;
  readonly bytes: Uint8Array;
  readonly context: DiagnoseContext & IdentifyContext;
}

const TRANSPORTS: readonly string[] = ['rtu', 'tcp', 'ascii', 'pdu'];
const isCharacter = (byte: number) => (byte >= 0x20 && byte < 0x7f) || byte === 0x0d || byte === 0x0a;

/** Hexadecimal pairs; ASCII frames, and what begins like one, as a string. */
const written = (bytes: Uint8Array): string =>
  bytes[0] === 0x3a && bytes.every(isCharacter) ? JSON.stringify(String.fromCharCode(...bytes)) : spaced(bytes);

const bytesOf = (text: string): Uint8Array =>
  text.startsWith('"') ? characters(JSON.parse(text) as string) : hex(text);

/** The cases of the file: a block each, with blank lines between. What was found is not read. */
export const readPinned = (file: string): Pinned[] =>
  file
    .split(/\n\n+/)
    .filter((block) => block.startsWith('#'))
    .map((block) => {
      const lines = block.split('\n');
      const labelled = (label: string) =>
        lines.filter((line) => line.startsWith(`  ${label} `)).map((line) => line.slice(label.length + 3));
      const after = (label: string) => labelled(label).map(bytesOf);
      const [, transport = '', bytes = ''] = /^(\S+): (.*)$/.exec(lines[1] ?? '') ?? [];
      const [request] = after('asked');
      const [direction] = labelled('given');
      return {
        what: (lines[0] ?? '').slice(2),
        bytes: bytesOf(bytes),
        context: {
          ...(TRANSPORTS.includes(transport) && { transport: transport as Transport }),
          ...(request && { request }),
          ...(direction !== undefined && { direction: direction as Direction }),
          ...(after('before').length > 0 && { preceding: after('before') }),
          ...(after('after').length > 0 && { following: after('after') }),
        },
      };
    });

/** The block of a case with all that is found of it. */
export const writePinned = ({ what, bytes, context }: Pinned): string =>
  [
    `# ${what}`,
    `${context.transport ?? 'any'}: ${written(bytes)}`,
    ...(context.request ? [`  asked ${written(context.request)}`] : []),
    ...(context.direction ? [`  given ${context.direction}`] : []),
    ...(context.preceding ?? []).map((piece) => `  before ${written(piece)}`),
    ...(context.following ?? []).map((piece) => `  after ${written(piece)}`),
    ...foundIn(bytes, context).map((line) => `  ${line}`),
  ].join('\n');

/** A line for each finding and what was weighed and not told, and one for each identity. */
function foundIn(bytes: Uint8Array, context: Pinned['context']): string[] {
  const offers = bitsOf(bytes, context);
  const findings = diagnose(bytes, context);
  const told = new Set<string>(findings.map(({ code }) => code));
  const { transport, request, direction: given } = context;
  return [
    ...findings.map((finding) => sayFinding(finding, offers.get(finding.code))),
    ...[...offers].filter(([code]) => !told.has(code)).map(([code, bits]) => `(${code} ${bits.toFixed(2)})`),
    ...identify(bytes, { transport, request, direction: given }).map(
      ({ direction, weight, reasons, ...identity }) =>
        `= ${identity.transport} ${direction} ${weight}: ${reasons.map(sayReason).join(', ')}`,
    ),
  ];
}

/** The most bits that any hypothesis has for each finding, the most first. */
export function bitsOf(bytes: Uint8Array, context: DiagnoseContext): Map<string, number> {
  const item = makeCase(bytes, context);
  const best = new Map<string, number>();
  for (const { code, bits } of [...ofSoundFrames, ...ofOthers].flatMap((hypothesis) => hypothesis.offer(item))) {
    best.set(code, Math.max(best.get(code) ?? Number.NEGATIVE_INFINITY, bits));
  }
  return new Map([...best].sort(([, a], [, b]) => b - a));
}

function sayFinding({ code, confidence, from, to, repaired, ...data }: Finding, bits = Number.NaN): string {
  const mended = repaired.length === 0 ? '' : ` → ${repaired.map(written).join(' | ')}`;
  return `${code} ${confidence} ${bits.toFixed(2)} at ${from}-${to}${sayData(data)}${mended}`;
}

const sayReason = ({ code, ...data }: Reason): string => `${code}${sayData(data)}`;

const sayData = (data: object): string => {
  const said = Object.entries(data).filter(([, value]) => value !== undefined);
  return said.map(([key, value]) => ` ${key}=${JSON.stringify(value)}`).join('');
};
