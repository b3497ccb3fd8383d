import { useEffect } from 'preact/hooks';
import type { Profile } from '../../devices/index.ts';
import {
  type Draft,
  draftMeant,
  firstFrame,
  type InputMeaning,
  identityOf,
  inputMeaning,
  readText,
  type TextReading,
} from '../../workbench/index.ts';
import { allDevices } from './device/chosen.ts';
import { openInLog } from './for-log.ts';
import { line } from './line.ts';
import { pasted } from './pasted.ts';
import { page } from './store.ts';
import { valueStore } from './value-store.ts';

/** Reads the text that waits, once the chosen device has come, and every other from then on. Shows nothing. */
export function Reader() {
  const came = allDevices.came.value;
  useEffect(() => {
    const openLog = (text: string, name?: string) => openInLog(name === undefined ? text : new File([text], name));
    if (came) pasted.bring({ readText, firstFrame, identityOf, meaningOf, openLog });
  }, [came]);
  return null;
}

/** The frame before a text was typed, the device that was chosen then, and the one that the text chose. */
let base: Draft | undefined;
let before: Profile | undefined;
let named: string | undefined;

/** What a text means with the device of before it was typed, though its beginning may have chosen another. */
function meaningOf(reading: TextReading, draft: Draft): InputMeaning {
  const chosen = allDevices.chosen.value;
  if (draft !== base || chosen?.id !== named) before = chosen;
  const meaning = inputMeaning(reading, {
    draft,
    convention: page.addressing.value.convention,
    device: before,
    devices: allDevices.all.value,
    own: valueStore.units.value.own,
    line: line.setting.value,
  });
  base = draft;
  named = draftMeant(meaning)?.device ?? chosen?.id;
  return meaning;
}
