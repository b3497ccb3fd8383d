// Holds the plan of src/ui: a room is a folder or a code file right in src/ui, and imports only rooms below its own floor.
// The kit imports nothing but itself and packages. Static and dynamic imports count, and imports of types too. Words are
// imported by value where the page's language is chosen, and nowhere else: the others are given theirs (`useWords`). No layer
// has two files of one name.
import { readdirSync, readFileSync } from 'node:fs';
import { join, posix } from 'node:path';

const MOST_ROOMS = 12;
const MOST_FLOORS = 8;

/** The floors, the highest first. A new room gets its place here; the rooms of one floor do not import each other. */
const floors = [
  ['main.tsx'],
  ['app.tsx'],
  ['views.tsx'],
  ['frame', 'trace', 'bus', 'devices', 'checksum', 'timing', 'reference'],
  ['parts'],
  ['kit'],
];

const withWords = new Set(['main.tsx', 'app.tsx', 'parts/words.ts', 'parts/workers/trace-worker.ts']);

const house = 'src/ui';
const imported = /(?:\bfrom\s*|\bimport\s*\(\s*|\bimport\s+|@import\s+|\bnew URL\(\s*)(['"])(\.[^'"]*)\1/g;
/** Imports and exports that are not of types alone; the linter has those written as `import type`. */
const byValue =
  /(?:^|\n)(?:import|export)\s+(?!type\b)[^'"]*?\bfrom\s*(['"])(\.[^'"]*)\1|\bimport\s*\(\s*(['"])(\.[^'"]*)\3/g;

const files = readdirSync(house, { recursive: true, encoding: 'utf8' })
  .map((name) => name.replaceAll('\\', '/'))
  .filter((name) => /\.(tsx?|css)$/.test(name));
const rooms = new Set(files.filter((name) => !/^[^/]*\.css$/.test(name)).map(roomOf));

/** @param {string} file relative to the house */
function roomOf(file) {
  return file.split('/')[0] ?? file;
}

/** @param {string} room */
const floorOf = (room) => floors.findIndex((floor) => floor.includes(room));

/** @type {string[]} */
const offences = [];
let back = 0;
for (const file of files) {
  const room = roomOf(file);
  const text = readFileSync(join(house, file), 'utf8');
  for (const [, , specifier = ''] of text.matchAll(imported)) {
    const target = posix.join(posix.dirname(file), specifier);
    const outside = target.startsWith('..');
    if (room === 'kit' && outside) offences.push(`${house}/${file}: kitImports: ${specifier} is outside of the kit.`);
    const other = roomOf(target);
    if (outside || other === room || !rooms.has(other) || floorOf(other) > floorOf(room)) continue;
    back += 1;
    offences.push(`${house}/${file}: arrowBack: ${room} imports ${other}, which does not stand below it.`);
  }
  if (withWords.has(file)) continue;
  for (const [, , imports, , loads] of text.matchAll(byValue)) {
    if (posix.join(posix.dirname(file), imports ?? loads ?? '').startsWith('../words/'))
      offences.push(`${house}/${file}: wordsByValue: the words of the page's language come with useWords.`);
  }
}
for (const room of rooms) {
  if (floorOf(room) < 0) offences.push(`${house}/${room}: noFloor: the room has no floor in scripts/page-rooms.mjs.`);
}

for (const layer of readdirSync('src')) {
  if (layer.includes('.')) continue;
  /** @type {Map<string, string>} */
  const named = new Map();
  for (const file of readdirSync(`src/${layer}`, { recursive: true, encoding: 'utf8' })) {
    const name = posix.basename(file.replaceAll('\\', '/'));
    if (!/\.(tsx?|css)$/.test(name) || name === 'index.ts' || name === 'view.ts') continue;
    const first = named.get(name);
    if (first === undefined) named.set(name, file);
    else offences.push(`src/${layer}/${file}: sameName: src/${layer}/${first} has the same name.`);
  }
}

const used = floors.filter((floor) => floor.some((room) => rooms.has(room))).length;
console.log(
  `${house}: ${rooms.size} rooms of at most ${MOST_ROOMS}, ${used} floors of at most ${MOST_FLOORS}, ${back} arrows back`,
);
for (const offence of offences) console.error(offence);
process.exitCode = offences.length === 0 && rooms.size <= MOST_ROOMS && used <= MOST_FLOORS ? 0 : 1;
