import type { Sheet } from '../sheet.ts';
import { esphome } from './esphome.ts';
import { evcc } from './evcc.ts';
import { homeAssistant } from './home-assistant.ts';
import { mbmap } from './mbmap.ts';
import { type NamedFormat, namedSheets } from './named-format.ts';
import { nymea } from './nymea.ts';
import { solarman } from './solarman.ts';
import { sungather } from './sungather.ts';
import { sunspec } from './sunspec.ts';
import { telegraf } from './telegraf.ts';
import { thingsboard } from './thingsboard.ts';

export { knownExport } from './exports.ts';
export { readModpoll } from './modpoll.ts';
export { namedMeanings } from './named-format.ts';
export { FORMAT as OWN_FORMAT, readOwn } from './own.ts';

const FORMATS: readonly NamedFormat[] = [
  mbmap,
  sunspec,
  nymea,
  homeAssistant,
  esphome,
  thingsboard,
  telegraf,
  solarman,
  sungather,
  evcc,
];

/** The sheets of a value whose format is known by name; `undefined` if it is not. */
export function readNamed(value: unknown): readonly Sheet[] | undefined {
  for (const { format, read } of FORMATS) {
    const tables = read(value);
    const sheets = tables && namedSheets(format, tables);
    if (sheets && sheets.length > 0) return sheets;
  }
  return undefined;
}
