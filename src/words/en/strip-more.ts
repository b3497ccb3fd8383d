import { formatBytes } from '../../notation/index.ts';
import type { CopyFormat, PairReason } from '../../workbench/index.ts';

/** What the strip says of some frames only, and in its lists. */
export const stripMore = {
  answers: 'Answers',
  answersNothing: 'no request named',
  answering: 'Answers the request',
  answeringHint: 'Hexadecimal, optional. It tells how many bits count and which addresses are answered.',
  /** The name of the button that shows the request, or that none is named. */
  editAnswering: (shown: string) => `The request that it answers: ${shown}`,
  formats: {
    spaced: 'Hexadecimal pairs',
    c: 'C',
    arduino: 'Arduino',
    csharp: 'C#',
    st: 'Structured Text (ST)',
    python: 'Python',
    javascript: 'JavaScript',
    list: '0x list',
    plain: 'Hexadecimal, unbroken',
    decimal: 'Decimal list',
    escapes: 'Escaped string',
    brackets: 'Bracketed bytes',
    'ascii-line': 'ASCII line',
  } satisfies Record<CopyFormat, string>,
  withChecksum: 'With the checksum',
  useChecksum: (bytes: Uint8Array) => `Use ${formatBytes(bytes)}`,
  useRepaired: 'Use the repaired frame',
  looking: 'The repair is still being looked for.',
  addChecksum: (bytes: Uint8Array) => `Add ${formatBytes(bytes)}`,
  explanationAs: {
    markdown: ['Markdown', 'for a forum'],
    table: ['Table', 'for a spreadsheet'],
    png: ['Picture', 'to paste'],
    svg: ['Picture as a file', 'SVG'],
  },
  /** The name of a picture that is saved. */
  pictureFile: 'frame',
  why: (count: number) => (count > 1 ? `Why, ${count - 1} more` : 'Why'),
  open: {
    taken: {
      number: (typed: string, address: number) => `${typed} is taken for the register's number: address ${address}.`,
      address: (typed: string, address: number) => `${typed} is taken for the address ${address} itself.`,
    },
    take: {
      number: (typed: string, address: number) => `Take ${typed} as a number: address ${address}`,
      address: (_typed: string, address: number) => `Take it as address ${address}`,
    },
    keep: 'That is right',
  },
  pair: {
    label: 'Request and reply',
    request: 'Request',
    reply: 'Reply',
    why: {
      transaction: 'The transaction is the same.',
      exception: 'It refuses the function of the request.',
      'same-content': 'It repeats the content of the request.',
      'unit-function-length': 'Unit, function and length agree.',
      differs: 'It does not answer this request.',
    } satisfies Record<PairReason, string>,
    answers: 'It answers the request you built.',
    part: 'Part them',
  },
};
