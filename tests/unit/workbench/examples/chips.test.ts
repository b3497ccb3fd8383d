import { describe, expect, it } from 'vitest';
import { fromHex } from '../../../../src/modbus/index.ts';
import { chips } from '../../../../src/workbench/examples/chips.ts';
import { firstDraft, withText } from '../../../../src/workbench/frame/draft.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { draftMeant } from '../../../../src/workbench/reading/draft-meant.ts';
import { inputMeaning } from '../../../../src/workbench/reading/input-meaning.ts';
import { readText } from '../../../../src/workbench/reading/read-text.ts';
import { inputContext } from '../reading/input-context.ts';

const textOf = (wanted: string) =>
  chips.flatMap((chip) => ('text' in chip && chip.id === wanted ? [chip.text] : [])).join();
const framesOf = (wanted: string) => readText(textOf(wanted), undefined).items;

describe('the texts to try', () => {
  it('begin with a value for a register of a drive, which is the frame that its guide means', () => {
    const meaning = inputMeaning(readText(textOf('set-30-hz'), undefined), inputContext());
    expect(evaluate(draftMeant(meaning)!).frame?.bytes).toEqual(fromHex('060602AB1000F5E5'));
  });

  it('set 30 Hz in unit 6 whatever frame was there, also if the drive is chosen already', () => {
    const before = withText(firstDraft, 'unitId', '1');
    for (const device of [undefined, 'weg-drive']) {
      const meaning = inputMeaning(readText(textOf('set-30-hz'), undefined), inputContext(before, device));
      expect(evaluate(draftMeant(meaning)!).frame?.bytes, device).toEqual(fromHex('060602AB1000F5E5'));
    }
  });

  it('have a frame with a wrong CRC and a sound one', () => {
    for (const [id, severity] of [
      ['wrong-crc', 'error'],
      ['float-reply', undefined],
    ] as const) {
      expect(framesOf(id), id).toHaveLength(1);
      expect(framesOf(id)[0], id).toMatchObject({ kind: 'frame', transport: 'rtu', severity });
    }
  });

  it('have a float as the maker of a drive sends it: 77.5146, low word first', () => {
    expect(readText(textOf('float-reply'), undefined).bytes).toEqual(fromHex('010304077A429BAB95'));
    expect(framesOf('float-reply')[0]).toMatchObject({ direction: 'response' });
  });
});
