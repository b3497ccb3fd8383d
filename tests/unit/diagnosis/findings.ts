import { readFileSync } from 'node:fs';
import { type DiagnoseContext, diagnose, type Finding, type FindingCode } from '../../../src/diagnosis/index.ts';
import { type Direction, decodeFrame, type Transport, toHex } from '../../../src/modbus/index.ts';
import { characters, hex } from '../modbus/frames.ts';

/** A frame of `tests/vectors/user-frames.json`: what somebody pasted, and what is wrong with it. */
export interface UserFrame {
  readonly id: string;
  readonly transport: 'rtu' | 'ascii' | 'tcp' | 'data';
  readonly hex: string;
  readonly finding: FindingCode;
  readonly repaired?: string;
  readonly answering?: string;
}

export const userFrames = JSON.parse(
  readFileSync(new URL('../../vectors/user-frames.json', import.meta.url), 'utf8'),
) as readonly UserFrame[];

/** What is known beside the bytes, the request in hexadecimal pairs. */
export interface Known {
  readonly transport?: Transport;
  readonly request?: string;
}

export const contextOf = ({ transport, request }: Known): DiagnoseContext => ({
  ...(transport && { transport }),
  ...(request && { request: hex(request) }),
});

/** Hexadecimal pairs, or an ASCII frame as its characters. */
const bytesOf = (text: string) => (text.startsWith(':') ? characters(text) : hex(text));

export const findingsOf = (text: string, known: Known = {}): Finding[] => diagnose(bytesOf(text), contextOf(known));

/** The first finding. */
export function firstOf(text: string, known: Known = {}): Finding {
  const [first] = findingsOf(text, known);
  if (first === undefined) throw new Error(`nothing is found in ${text}`);
  return first;
}

/** The finding's repaired frames in hexadecimal pairs. */
export const repairsOf = ({ repaired }: Finding): string[] => repaired.map(spaced);

export const spaced = (bytes: Uint8Array): string => (toHex(bytes).match(/../g) ?? []).join(' ');

const transports: readonly Transport[] = ['rtu', 'ascii', 'tcp', 'pdu'];
const directions: readonly Direction[] = ['request', 'response'];

/** Whether the bytes are a frame without an error in some transport and direction. */
export const isValid = (frame: Uint8Array): boolean =>
  transports.some((transport) =>
    directions.some((direction) => {
      const { outcome, problems } = decodeFrame(frame, { transport, direction });
      return outcome.kind === 'whole' && !problems.some(({ severity }) => severity === 'error');
    }),
  );
