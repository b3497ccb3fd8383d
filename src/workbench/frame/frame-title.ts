import { type Reading, toHex } from '../../modbus/index.ts';

/** Fields that are named: the unit, the function, and what follows it, mostly the address. */
const FIELDS = 3;
/** Bytes of a field, and characters of an ASCII frame, that are shown. */
const MOST_BYTES = 4;
const MOST_CHARACTERS = 9;

/** The beginning of a frame, by which it is found among other windows: `06 06 02AB …`. The MBAP header is left out. */
export function frameBeginning({ transport, spans }: Reading, bytes: Uint8Array): string {
  if (transport === 'ascii') {
    const text = String.fromCharCode(...bytes.subarray(0, MOST_CHARACTERS)).trimEnd();
    return bytes.length > MOST_CHARACTERS ? `${text}…` : text;
  }
  const fields = spans.filter(({ kind }) => kind !== 'envelope').slice(0, FIELDS);
  const shown = fields.map(({ from, to }) => toHex(bytes.subarray(from, Math.min(to, from + MOST_BYTES))));
  const last = fields.at(-1);
  const all = last === undefined || (last.to === bytes.length && last.to - last.from <= MOST_BYTES);
  return [...shown, ...(all ? [] : ['…'])].join(' ');
}
