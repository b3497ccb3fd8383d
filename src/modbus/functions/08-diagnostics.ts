import { type Layout, layout, type Rule } from '../field.ts';
import { echoes, u16 } from '../fields/number.ts';
import { hex } from '../fields/raw-bytes.ts';
import { defineFunction } from '../function-code.ts';

/**
 * The sub-functions of AP 6.8.1, and 13 and 15 of PI, which AP reserves. Those with `access` only answer; the others restart,
 * silence or clear something, or may.
 */
export const diagnosticSubFunctions = [
  { code: 0x00, name: 'Return Query Data', access: 'reads' },
  { code: 0x01, name: 'Restart Communications Option' },
  { code: 0x02, name: 'Return Diagnostic Register', access: 'reads' },
  { code: 0x03, name: 'Change ASCII Input Delimiter' },
  { code: 0x04, name: 'Force Listen Only Mode' },
  { code: 0x0a, name: 'Clear Counters and Diagnostic Register' },
  { code: 0x0b, name: 'Return Bus Message Count', access: 'reads' },
  { code: 0x0c, name: 'Return Bus Communication Error Count', access: 'reads' },
  { code: 0x0d, name: 'Return Bus Exception Error Count', access: 'reads' },
  { code: 0x0e, name: 'Return Server Message Count', access: 'reads' },
  { code: 0x0f, name: 'Return Server No Response Count', access: 'reads' },
  { code: 0x10, name: 'Return Server NAK Count', access: 'reads' },
  { code: 0x11, name: 'Return Server Busy Count', access: 'reads' },
  { code: 0x12, name: 'Return Bus Character Overrun Count', access: 'reads' },
  { code: 0x13, name: 'Return IOP Overrun Count', reserved: true },
  { code: 0x14, name: 'Clear Overrun Counter and Flag' },
  { code: 0x15, name: 'Get/Clear Modbus Plus Statistics', reserved: true },
] as const;

const published = new Set<number>(diagnosticSubFunctions.filter((sub) => !('reserved' in sub)).map(({ code }) => code));

const notReserved: Rule<number> = (got) =>
  published.has(got)
    ? undefined
    : {
        code: 'sub-function-reserved',
        severity: 'warning',
        got,
        section: got >= 5 && got <= 9 ? 'AP 6.8.1' : 'AP Annex A',
      };

const forceListenOnlyIsSilent: Rule<number> = (got) =>
  got === 0x04 ? { code: 'sub-function-without-reply', severity: 'error', got, section: 'AP 6.8.1' } : undefined;

const restartMayBeSilent: Rule<number> = (got) =>
  got === 0x01 ? { code: 'no-reply-in-listen-only', severity: 'note', section: 'AP 6.8.1' } : undefined;

const twoBytes: Rule<string> = ({ length }) =>
  length === 4
    ? undefined
    : { code: 'data-length', severity: 'error', got: length / 2, expected: 2, section: 'AP 6.8.1' };

const wholeWords: Rule<string> = ({ length }) =>
  length % 4 === 0 ? undefined : { code: 'data-length-odd', severity: 'error', got: length / 2, section: 'AP 6.8' };

/** The length is nowhere in the frame, and implementations often take exactly two bytes. */
const lengthOpen: Rule<string> = ({ length }) =>
  length === 4 ? undefined : { code: 'diagnostics-length-open', severity: 'note', got: length / 2, section: 'AP 6.8' };

const oneOf =
  (...allowed: string[]): Rule<string> =>
  (got) =>
    got.length !== 4 || allowed.includes(got)
      ? undefined
      : { code: 'data-not-allowed', severity: 'error', got, allowed, section: 'AP 6.8.1' };

const delimiter: Rule<string> = (got) =>
  got.length !== 4 || got.endsWith('00')
    ? undefined
    : { code: 'data-not-allowed', severity: 'error', got, allowed: ['xx00'], section: 'AP 6.8.1' };

/** Two bytes of data under a rule of their own. */
const word = (rules: Rule<string>[] = [], replyRules: Rule<string>[] = []): Layout =>
  layout([hex('data', { size: () => 2, rules: [twoBytes, ...rules], replyRules })]);

const echo = word([], [echoes('data')]);
const anyWords = layout([hex('data', { usual: 2, rules: [wholeWords, lengthOpen], replyRules: [echoes('data')] })]);
const open = layout([hex('data', { rules: [wholeWords] })]);

/** In these requests the data is 0000. */
const zeroRequests = [0x02, 0x04, 0x0a, 0x0b, 0x0c, 0x0d, 0x0e, 0x0f, 0x10, 0x11, 0x12, 0x13, 0x14];
const counters = [0x02, 0x0b, 0x0c, 0x0d, 0x0e, 0x0f, 0x10, 0x11, 0x12, 0x13];

const each = (codes: readonly number[], then: Layout) => Object.fromEntries(codes.map((code) => [code, then]));

export const diagnostics = defineFunction({
  code: 0x08,
  name: 'Diagnostics',
  section: 'AP 6.8',
  group: 'diagnostics',
  access: {
    by: 'subFunction',
    reads: diagnosticSubFunctions.flatMap((sub) => ('access' in sub ? [sub.code] : [])),
  },
  // Return Query Data.
  probe: { subFunction: 0x00, data: 'A537' },
  serialOnly: true,
  request: layout([u16('subFunction', { kind: 'choice', rules: [notReserved] })], {
    by: 'subFunction',
    cases: {
      ...each(zeroRequests, word([oneOf('0000')])),
      0: anyWords,
      1: word([oneOf('0000', 'FF00')]),
      3: word([delimiter]),
      21: word([oneOf('0003', '0004')]),
    },
    otherwise: open,
  }),
  response: layout(
    [
      u16('subFunction', {
        kind: 'choice',
        rules: [notReserved, forceListenOnlyIsSilent, restartMayBeSilent],
        replyRules: [echoes('subFunction')],
      }),
    ],
    {
      by: 'subFunction',
      cases: {
        ...each(counters, word()),
        ...each([0x01, 0x03, 0x04, 0x0a, 0x14], echo),
        0: anyWords,
      },
      otherwise: open,
    },
  ),
});
