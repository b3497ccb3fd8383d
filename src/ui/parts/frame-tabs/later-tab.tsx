import type { ComponentChildren } from 'preact';
import type { FrameTab } from '../../../workbench/index.ts';
import type { TabProps } from '../current-frame.ts';
import { part, Slot } from '../slot.tsx';

const values = part(
  ['values'],
  () => import('./values/values.tsx'),
  ({ ValuesTab }) => ValuesTab,
);
const reply = part(
  ['reply'],
  () => import('./reply-tab.tsx'),
  ({ ReplyTab }) => ReplyTab,
);
const wire = part(
  ['wire'],
  () => import('./wire/wire-view.tsx'),
  ({ WireTab }) => WireTab,
);
const crc = part(
  ['crc'],
  () => import('./crc-tab.tsx'),
  ({ CrcTab }) => CrcTab,
);
const compare = part(
  ['compare'],
  () => import('./compare/comparison.tsx'),
  ({ CompareTab }) => CompareTab,
);
const program = part(
  ['program'],
  () => import('../program/program-tab.tsx'),
  ({ ProgramTab }) => ProgramTab,
);

/** The tabs that are not open at first, each with what it shows. */
export type LaterTabId = Exclude<FrameTab, 'bytes'>;

const tabs = {
  values: (of) => <Slot part={values} with={{ of }} />,
  reply: (of) => <Slot part={reply} with={{ of }} />,
  wire: (of) => <Slot part={wire} with={{ of }} />,
  crc: (of) => <Slot part={crc} with={{ of }} />,
  compare: (of) => <Slot part={compare} with={{ of }} />,
  program: (of) => <Slot part={program} with={{ of }} />,
} satisfies Readonly<Record<LaterTabId, (of: TabProps['of']) => ComponentChildren>>;

/** What a tab that is opened later shows: these come together, so that a page whose tabs nobody opens names none of them. */
export const LaterTab = ({ id, of }: TabProps & { readonly id: LaterTabId }) => tabs[id](of);
