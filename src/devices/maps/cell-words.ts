import type { Access, EntityTable } from '../profile.ts';
import { plainHeader } from './plain-header.ts';

const byPhrase = <T>(rows: readonly (readonly [T, string])[]): ReadonlyMap<string, T> =>
  new Map(
    rows.flatMap(([meant, phrases]) => phrases.split('|').map((phrase) => [plainHeader(phrase), meant] as const)),
  );

/** Words for the four tables, in the eight languages. Plural and singular, with and without "register", are looked up alike. */
const TABLES = byPhrase<EntityTable>([
  [
    'coil',
    'coil|co|0x|0xxxx|digital output|discrete output|do|output coil|binary output|relay|relay output|read coil|write coil|spule|spulen|digitaler ausgang|bobine|bobina|sortie tout ou rien|uscita digitale|salida digital|spoel|cewka|wyjscie cyfrowe|线圈|线圈状态|输出线圈|coil status',
  ],
  [
    'discrete-input',
    'discrete input|discrete|di|1x|1xxxx|digital input|contact|input contact|binary input|status input|input status|read discrete input|discretes input|digitaler eingang|diskreter eingang|entree discrete|entree tor|entrada discreta|entrada digital|ingresso discreto|ingresso digitale|discrete ingang|wejscie dyskretne|wejscie cyfrowe|离散输入|输入状态|离散量输入|discrete input contact',
  ],
  [
    'input-register',
    'input|input register|ir|3x|3xxxx|analog input|analogue input|ai|inputregister|input reg|input registry|read input register|modbus input register|eingangsregister|eingang|registre d entree|registre entree|registro de entrada|entrada analogica|registro di ingresso|registro ingresso|ingresso analogico|ingangsregister|invoerregister|rejestr wejsciowy|wejsciowy|输入寄存器|模拟量输入|只读寄存器',
  ],
  [
    'holding-register',
    'holding|holding register|hr|4x|4xxxx|analog output|analogue output|ao|holdingregister|hold|hold register|holding reg|holding registry|read holding register|write holding register|modbus holding register|output register|write register|write single register|write multiple register|halteregister|holding register rw|registre de maintien|registre holding|registre interne|registro de retencion|registro holding|registro di mantenimento|registro mantenimento|registro di memorizzazione|vasthoudregister|rejestr przechowujacy|rejestr pamieciowy|保持寄存器|模拟量输出',
  ],
]);

/** The table that words name; `undefined` if they do not name one. */
export function tableNamed(text: string): EntityTable | undefined {
  const words = plainHeader(text);
  if (words === '') return undefined;
  const singular = words.replace(/s(?= |$)/g, '');
  return (
    TABLES.get(words) ??
    TABLES.get(singular) ??
    TABLES.get(
      singular
        .replace(/^(fc|function|fn|code|funktion|read|fonction)? ?0?x?\d+ (?:r |read )?/, '')
        .replace(/ ?(fc|function|code)? ?0?x?\d+$/, ''),
    )
  );
}

/** The table that a longer text speaks of: a title, a heading, the name of a worksheet. `undefined` if it names none, or two. */
export function tableSpokenOf(text: string): EntityTable | undefined {
  const words = plainHeader(text).replace(/([a-z])s(?= |$)/g, '$1');
  const found = new Set<EntityTable>();
  for (const [phrase, table] of TABLES)
    if (
      (phrase.length > 7 || /[\u4e00-\u9fff]|^coil$/.test(phrase)) &&
      ` ${words} `.includes(/[\u4e00-\u9fff]/.test(phrase) ? phrase : ` ${phrase} `)
    )
      found.add(table);
  return found.size === 1 ? [...found][0] : undefined;
}

const ACCESSES = byPhrase<Access>([
  [
    'r',
    'r|ro|rd|read|read only|readonly|r o|readable|get|monitor|lesen|nur lesen|l|lesend|leseparameter|lecture|lecture seule|lectura|solo lectura|lettura|sola lettura|solo lettura|lezen|alleen lezen|odczyt|tylko odczyt|o|只读|读|read measurement|status|r r|no|false|nein|non',
  ],
  [
    'w',
    'w|wo|wr|write|write only|writeonly|w o|writable|set|command|schreiben|nur schreiben|s|ecriture|ecriture seule|e|escritura|solo escritura|scrittura|sola scrittura|schrijven|alleen schrijven|zapis|tylko zapis|z|只写|写',
  ],
  [
    'rw',
    'rw|r w|wr|w r|read write|readwrite|write read|read and write|read or write|get set|rws|rwp|r w s|ls|l s|lesen schreiben|lesen und schreiben|lesen u schreiben|schreiben lesen|le|l e|lecture ecriture|lecture et ecriture|l e|lectura escritura|lectura y escritura|lettura scrittura|lettura e scrittura|lezen schrijven|lezen en schrijven|odczyt zapis|o z|读写|可读写|读 写|读 写属性|可读可写|r w nv|control|yes|true|ja|oui|si',
  ],
]);

/** The access that a cell names; `undefined` if it names none. */
export function accessNamed(text: string): Access | undefined {
  const words = plainHeader(text);
  const found = ACCESSES.get(words);
  if (found !== undefined || words === '') return found;
  // `R/-`, `-/W`, `R (W)`, `R, W`, `RO*`.
  const letters = words.replace(/ /g, '');
  return /^[rw]{1,3}$/.test(letters) ? (letters.includes('r') ? (letters.includes('w') ? 'rw' : 'r') : 'w') : undefined;
}

/** The tables that a function code reads or writes (AP 6). */
const FUNCTION_TABLES: ReadonlyMap<number, EntityTable> = new Map([
  [1, 'coil'],
  [2, 'discrete-input'],
  [3, 'holding-register'],
  [4, 'input-register'],
  [5, 'coil'],
  [6, 'holding-register'],
  [15, 'coil'],
  [16, 'holding-register'],
  [22, 'holding-register'],
  [23, 'holding-register'],
]);

/** The tables of the digits in front of numbers (PI ch. 2). */
export const digitTables: ReadonlyMap<string, EntityTable> = new Map([
  ['0', 'coil'],
  ['1', 'discrete-input'],
  ['3', 'input-register'],
  ['4', 'holding-register'],
]);

/** The function codes that a cell lists: `03`, `0x03`, `FC3`, `3, 6, 16`, `03H/06H/10H`, `Read Holding Registers (03)`. */
export function functionCodes(text: string): readonly number[] | undefined {
  const plain = text.trim().toLowerCase();
  if (plain === '') return undefined;
  const bare = plain
    .replace(
      /\b(?:modbus|function|funktion|fonction|funcion|funzione|code|fc|fn|f|fct|read|write|r|w|and|und|et|y|e|or|only)\b\.?|功能码|读|写|[读写]/g,
      ' ',
    )
    .replace(/\bf(?:c|n)?(?=\d)/g, ' ');
  if (!/^[\s\d,;/&+|.\-xh()#:=]*$/.test(bare) || !/\d/.test(bare)) return undefined;
  const hex = /0x|h\b|\b10\b/.test(bare) && !/\b1[56]\b/.test(bare);
  const codes: number[] = [];
  for (const [, digits = ''] of bare.matchAll(/(?:0x)?([\da-f]+)h?/g)) {
    const code = Number.parseInt(digits, hex ? 16 : 10);
    if (!FUNCTION_TABLES.has(code)) return undefined;
    codes.push(code);
  }
  return codes.length === 0 ? undefined : codes;
}

/** The table of all these functions; `undefined` if they are of two. */
export function tableOfFunctions(codes: readonly number[]): EntityTable | undefined {
  const tables = new Set(codes.map((code) => FUNCTION_TABLES.get(code)));
  return tables.size === 1 ? [...tables][0] : undefined;
}

/** What stands in a cell that says nothing. */
export const saysNothing = (text: string): boolean =>
  /^[\s\-–—_./\\*]*$/.test(text) ||
  /^(?:n\/?a|none|null|nil|keine?|ohne|sans|aucune?|ninguno|nessuno|geen|brak|无|undefined|nan|dimensionless|unitless|\(none\)|x{3,})$/i.test(
    text.trim(),
  );

/** Names of registers that are not in use. */
export const saysUnused = (text: string): boolean =>
  /^[\s\W]*(?:reserved?|reserv[eé]e?|unused|not used|unknown|spare|free|empty|dummy|nicht (?:verwendet|belegt|benutzt|genutzt)|unbenutzt|unbelegt|reserviert|frei|unbekannt|non utilis[eé]e?|inutilis[eé]e?|libre|no (?:usado|utilizado)|sin uso|reservado|non (?:usato|utilizzato)|riservato|inutilizzato|niet gebruikt|gereserveerd|ongebruikt|nieu[zż]ywan[ey]|zarezerwowan[ey]|rezerwa|未使用|保留|预留|备用|未知)/iu.test(
    text,
  );
