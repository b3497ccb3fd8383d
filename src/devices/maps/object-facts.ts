import { dictionary } from '../../modbus/index.ts';
import { isScalar, type Loose, numberOf, plainKey, textOf } from './loose.ts';
import type { FactCode, Sheet } from './sheet.ts';

const ORDER = /^(?:endian(?:ness)?|(?:byte|word|register)order)$/;

/** The tables that a key names. */
export function tableNamed(key: string): string | undefined {
  const word = plainKey(key);
  if (/holding|^hold$|^hr$|outputreg|readwriteword/.test(word)) return 'holding-register';
  if (/discrete|^disinput|inputstatus|inputcoil|contact|readonlybool/.test(word)) return 'discrete-input';
  if (/coil|readwritebool/.test(word)) return 'coil';
  return /inputreg|^inputs?$|^ir$|readonlyword/.test(word) ? 'input-register' : undefined;
}

const FACT_KEYS: Readonly<Record<string, FactCode>> = dictionary({
  device: 'device',
  devicename: 'device',
  name: 'device',
  title: 'device',
  source: 'source',
  slave: 'unit',
  slaveid: 'unit',
  unitid: 'unit',
  unitidentifier: 'unit',
});

const WORDED: ReadonlyMap<string, number> = new Map([
  ['zero', 0],
  ['one', 1],
]);

/** `little` of a key for words alone does not mean the bytes. */
export const orderText = (key: string, order: string): string => {
  if (!ORDER.test(key) || !/^(?:word|register)/.test(key)) return order;
  return /^(?:little|low|lsw|le\b)/i.test(order) ? 'CDAB' : /^(?:big|high|msw|be\b)/i.test(order) ? 'ABCD' : order;
};

/** What the scalars beside a list say for all its items. */
export function factsOf(value: Loose): Sheet['facts'] {
  const facts: Partial<Record<FactCode, string>> = {};
  for (const [key, each] of Object.entries(value)) {
    if (!isScalar(each) || each === null || each === '') continue;
    const word = plainKey(key);
    const code = FACT_KEYS[word];
    if (code) facts[code] = textOf(each);
    if (ORDER.test(word)) facts.order = orderText(word, textOf(each));
    const base = /^(?:base)?address(?:es)?base|^baseaddress$|^(?:index)?base$|^startindex$/.test(word)
      ? (WORDED.get(textOf(each).toLowerCase()) ?? numberOf(each))
      : undefined;
    if (base !== undefined && !(base > 1)) facts.counting = base === 0 ? 'zero' : 'one';
    else if (base !== undefined) facts.addressBase = textOf(each);
    // The first of all addresses.
    if (/^(?:min|first|start|from)(?:addr|adr|address|reg|register)$/.test(word) && numberOf(each) === 0)
      facts.counting = 'zero';
    if (/^zerobased/.test(word)) facts.counting = each === true || each === 'true' ? 'zero' : 'one';
    if (/^onebased/.test(word)) facts.counting = each === true || textOf(each) === '1' ? 'one' : 'zero';
  }
  const device =
    facts.device ??
    textOf([value['manufacturer'] ?? value['vendor'] ?? value['brand'], value['model']].filter(Boolean)).replace(
      ', ',
      ' ',
    );
  return { ...facts, ...(device === '' ? {} : { device }) };
}
