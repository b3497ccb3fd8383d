import type { KnownSource, Verdict } from '../../workbench/index.ts';

const sources: Readonly<Record<KnownSource, string>> = {
  specification: 'Serial Line §6.2.2',
  guide: 'Modicon guide, Figure 46',
  catalogue: 'Catalogues of CRCs, characters 123456789',
  introduction: 'A Chinese introduction',
  calculator: 'lammertbies.nl, as the Chinese introduction shows it',
  published: 'Widely printed frames',
};

const verdicts: Readonly<Record<Verdict, string>> = { right: 'right', swapped: 'bytes swapped', wrong: 'wrong' };

/** What the test card says. */
export const checksumCard = {
  intro:
    'Printed values, each calculated again here. Run your own implementation over the bytes and compare. What is marked wrong is in print nevertheless.',
  sources,
  columns: {
    bytes: 'Bytes',
    algorithm: 'Algorithm',
    printed: 'Printed',
    value: 'Calculated',
    verdict: 'Printed value',
    source: 'Where',
  },
  verdicts,
  known: 'Values to check against',
  use: 'Use',
  useNamed: (bytes: string) => `Use ${bytes} as the input`,
  copyCsv: 'Copy as CSV',
  copyC: 'Copy as C array',
  csv: 'the test card as CSV',
  c: 'the test card as a C array',
};
