import { en as fields } from './fields.ts';
import { page, section } from './page.ts';
import { views } from './views.ts';

/**
 * English: what brings the sentences of each subject. Those of the first view come with the page; the others with the part
 * that says them.
 */
export const english = {
  page: async () => ({ ...fields, page, section, views }),
  commands: () => import('./commands.ts').then(({ commands }) => commands),
  complaints: () => import('./complaints.ts').then(({ complaints }) => complaints),
  tools: () => import('./tools.ts').then(({ tools }) => tools),
  examples: () => import('./examples.ts').then(({ examples }) => examples),
  saved: () => import('./saved.ts').then(({ saved }) => saved),
  compare: () => import('./compare.ts').then(({ compare }) => compare),
  reference: () => import('./reference.ts').then(({ reference }) => reference),
  timing: () => import('./timing.ts').then(({ timing }) => timing),
  checksum: () => import('./checksum.ts').then(({ checksum }) => checksum),
  checksumCard: () => import('./checksum-card.ts').then(({ checksumCard }) => checksumCard),
  checksumSteps: () => import('./checksum-steps.ts').then(({ steps }) => steps),
  read: () => import('./read.ts').then(({ read }) => read),
  findings: () => import('./findings.ts').then(({ finding }) => finding),
  values: () => import('./values.ts').then(({ values }) => values),
  devices: () => import('./devices.ts').then(({ devices }) => devices),
  wire: () => import('./wire.ts').then(({ wire }) => wire),
  bus: () => import('./bus.ts').then(({ bus }) => bus),
  poll: () => import('./poll.ts').then(({ poll }) => poll),
  scan: () => import('./scan.ts').then(({ scan }) => scan),
  listen: () => import('./listen.ts').then(({ listen }) => listen),
  virtual: () => import('./virtual.ts').then(({ virtual }) => virtual),
  sequence: () => import('./sequence.ts').then(({ sequence }) => sequence),
};
