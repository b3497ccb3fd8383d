/** What brings the sentences of each subject, under its name, with the part of the page that says them. */
const loaders = {
  page: () => import('./common.ts').then(({ en }) => ({ page: en })),
  header: () => import('./header.ts'),
  commands: () => import('./commands.ts'),
  complaints: () => import('./complaints.ts'),
  tools: () => import('./common.ts').then(({ tools }) => ({ tools })),
  addressWays: () => import('./address-ways.ts'),
  brokenLink: () => import('./broken-link.ts'),
  oneByOne: () => import('./one-by-one.ts'),
  stripMore: () => import('./strip-more.ts'),
  examples: () => import('./examples.ts'),
  saved: () => import('./saved.ts'),
  reply: () => import('./reply.ts'),
  crc: () => import('./crc.ts'),
  compare: () => import('./compare.ts'),
  library: () => import('./library.ts'),
  about: () => import('./about.ts'),
  reference: () => import('./reference.ts'),
  timing: () => import('./timing.ts'),
  checksum: () => import('./checksum.ts'),
  checksumCard: () => import('./checksum-card.ts'),
  checksumSteps: () => import('./checksum-steps.ts'),
  paste: () => import('./paste.ts'),
  offline: () => import('./offline.ts'),
  input: () => import('./common.ts').then(({ input }) => ({ input })),
  read: () => import('./read.ts'),
  findings: () => import('./findings.ts'),
  values: () => import('./values.ts'),
  devices: () => import('./devices.ts'),
  registerMaps: () => import('./register-maps.ts'),
  wire: () => import('./wire.ts'),
  bus: () => import('./bus.ts'),
  poll: () => import('./poll.ts'),
  scan: () => import('./scan.ts'),
  listen: () => import('./listen.ts'),
  trace: () => import('./trace.ts'),
  noAnswer: () => import('./no-answer.ts'),
  virtual: () => import('./virtual.ts'),
  program: () => import('./program.ts'),
  sequence: () => import('./sequence.ts'),
};

type Loaders = typeof loaders;
type English = {
  readonly [S in keyof Loaders]: () => Promise<
    Awaited<ReturnType<Loaders[S]>> extends Readonly<Record<S, infer W>> ? W : never
  >;
};

/** English: the sentences of each subject. */
export const english = Object.fromEntries(
  Object.entries(loaders).map(([subject, load]) => [
    subject,
    () => load().then((come: Readonly<Record<string, unknown>>) => come[subject]),
  ]),
) as English;
