import type { ComponentChild } from 'preact';
import type { ToolWords } from '../../words/index.ts';
import type { Draft } from '../../workbench/index.ts';
import { evaluation } from '../state.ts';
import { AddressHelp } from './address-help.tsx';
import { typedIn, typeIn } from './convention.ts';

interface Input {
  readonly path: string;
  readonly text: string;
  readonly onText: (text: string) => void;
}

/** What an address field shows and does instead of the plain one, and what stands below it. */
export interface AddressAid {
  readonly typed: Pick<Input, 'text' | 'onText'>;
  readonly help: ComponentChild;
}

/** Lets an address be typed as manuals print it, where the function has a table. */
export function addressAid(
  { path, text, onText }: Input,
  label: string,
  draft: Draft,
  words: ToolWords,
): AddressAid | undefined {
  const { table } = evaluation.value.description;
  if (table === undefined) return undefined;
  return {
    typed: {
      text: typedIn(path, text, table) ?? text,
      onText: (typed) => onText(typeIn(path, typed, table)),
    },
    help: <AddressHelp path={path} label={label} text={text} table={table} draft={draft} words={words.addresses} />,
  };
}
