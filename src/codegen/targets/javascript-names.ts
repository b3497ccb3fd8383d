import type { NameRules } from '../names.ts';

const KEYWORDS = `abstract arguments async await boolean break byte case catch char class const continue debugger default delete do
double else enum eval export extends false final finally float for function get goto if implements import in instanceof int
interface let long native new null of package private protected public return set short static super switch synchronized this
throw throws transient true try typeof undefined var void volatile while with yield`;

/** What is always there, in browsers too. */
const GLOBAL = `AbortSignal Array Boolean Buffer Date Error Float32Array Infinity Map Math NaN Number Object Promise String Symbol
Uint32Array Uint8Array clearTimeout console event exports global globalThis isNaN location module name parseInt performance
process require self setTimeout status window`;

/** What the programs import and define themselves. */
const OWN = `ModbusRTU SerialPort connect decodeFrame encodeFrame fileURLToPath once sleep HOST PORT LINE PAUSE SILENCE TIMEOUT done
exchange finish frame given line main open receive send show steps verdict waitUntil wantedFor client turn`;

export const javascriptRules: NameRules = {
  styles: { routine: 'camel', variable: 'camel', constant: 'constant', table: 'constant', type: 'pascal' },
  reserved: `${KEYWORDS} ${GLOBAL} ${OWN}`.split(/\s+/),
};
