import type { ComponentChild } from 'preact';
import { readNumber } from '../../../notation/index.ts';
import type { ToolWords } from '../../../words/index.ts';
import type { Draft } from '../../../workbench/index.ts';
import { devicesCame } from '../../parts/device/naming.ts';
import { edit, evaluation } from '../../parts/store.ts';
import { AddressHelp } from './address-help.tsx';
import { addresses } from './convention.ts';

/** What an address field shows and does instead of the plain one, and what stands below it. */
export interface AddressAid {
  readonly typed: { readonly text: string; readonly onText: (text: string) => void };
  /** What there is to say of what was typed. */
  readonly said: string | undefined;
  readonly help: ComponentChild;
}

/** Lets an address be typed as manuals print it, where the function has a table. */
export function addressAid(
  path: string,
  text: string,
  label: string,
  draft: Draft,
  words: ToolWords,
): AddressAid | undefined {
  const { table } = evaluation.value.description;
  if (table === undefined) return undefined;
  const { text: shown, notHere } = addresses.shown(draft, path, text, table);
  // A number counted in the way of another manual stands here as the frame has it; a name would be missed.
  const isName = notHere !== undefined && readNumber(notHere) === undefined;
  return {
    typed: { text: shown, onText: (typed) => edit(addresses.withTyped(draft, path, typed, table)) },
    said: isName && devicesCame.value ? words.addresses.notHere(notHere) : undefined,
    help: <AddressHelp path={path} label={label} text={text} table={table} draft={draft} words={words.addresses} />,
  };
}
