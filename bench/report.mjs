import { quantile } from './quantile.mjs';

const NAME_WIDTH = 54;
const WIDTH = 13;

/**
 * One program's speeds at one subject, a number a run.
 * @typedef {{ subject: import('./subjects.mjs').Subject, program: string, note?: string, speeds: number[] }} Row
 */

/**
 * A table for each subject, as lines of text, and the notes under them all.
 * @param {Row[][]} tables the rows of each subject, ours first
 */
export function report(tables) {
  const notes = [];
  const lines = [];
  let met = 0;
  for (const table of tables) {
    const { subject } = table[0];
    const [ours, ...peers] = table.map((row) => ({ ...row, middle: quantile(row.speeds, 0.5) }));
    const fastest = peers.reduce((best, peer) => (peer.middle > best.middle ? peer : best));
    const ratio = ours.middle / fastest.middle;
    const enough = ratio >= subject.target;
    if (enough) met++;
    lines.push('', line(`${subject.title}, ${subject.unit}`, 'median', 'from', 'to', 'ours / peer'));
    for (const row of [ours, ...peers]) {
      const name = row.note === undefined ? row.program : `${row.program} [${numberOf(notes, row.note)}]`;
      const speeds = [0.5, 0.1, 0.9].map((share) => format(quantile(row.speeds, share)));
      lines.push(line(`  ${name}`, ...speeds, row === ours ? '' : (ours.middle / row.middle).toFixed(2)));
    }
    const verdict = `target ${subject.target}: ${enough ? 'met' : 'NOT MET'}`;
    lines.push(`  ${ratio.toFixed(2)} × ${fastest.program} (undisturbed ${undisturbed(ours, fastest)}), ${verdict}`);
  }
  return [...lines, '', ...notes.map((note, i) => `[${i + 1}] ${note}`), '', `${met} of ${tables.length} targets met`];
}

/** The ratio of the fastest tenths: nearly what it would be on an idle machine. */
const undisturbed = (ours, peer) => (quantile(ours.speeds, 0.9) / quantile(peer.speeds, 0.9)).toFixed(2);

const line = (name, ...columns) =>
  (name.padEnd(NAME_WIDTH) + columns.map((column) => column.padStart(WIDTH)).join('')).trimEnd();

/** Four digits count; frames have no fractions. */
const format = (value) => value.toLocaleString('en', { maximumFractionDigits: value < 10_000 ? 1 : 0 });

/** The number of a note, counted from one in the order of their first appearance. */
function numberOf(notes, note) {
  if (!notes.includes(note)) notes.push(note);
  return notes.indexOf(note) + 1;
}
