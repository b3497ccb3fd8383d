import { describe, expect, it } from 'vitest';
import { modelNames, sourceSetups } from '../../../../src/bus/index.ts';
import { builtInProfiles, plainRegister } from '../../../../src/devices/index.ts';
import { bytesOfLink, tidyFrame } from '../../../../src/workbench/bus/sequence-frame.ts';
import { deviceKinds, kindName } from '../../../../src/workbench/bus/virtual-setups.ts';

const models = Object.fromEntries(modelNames.map((name) => [name, `model ${name}`])) as Record<
  (typeof modelNames)[number],
  string
>;

describe('what can be put on the line', () => {
  it('is each model, each other profile that is built in, and those of a person', () => {
    const own = { id: 'own', name: 'Pump', source: '', convention: 'zero-based', traits: [], notes: [] } as const;
    const profile = { ...own, registers: [{ ...plainRegister, name: 'A', table: 'coil', address: 0 } as const] };
    const kinds = deviceKinds([profile]);
    const names = kinds.map((kind) => kindName(kind, models));
    expect(names.slice(0, modelNames.length)).toEqual(modelNames.map((name) => models[name]));
    expect(names.at(-1)).toBe('Pump');
    // Nothing is offered twice: a model is its profile with values in it.
    const modelled = new Set(['s7-200', 'weg-drive', 'i-8xx7', 'modicon-984']);
    const others = builtInProfiles.filter(({ id }) => !modelled.has(id)).map(({ name }) => name);
    expect(names.slice(modelNames.length, -1)).toEqual(others);
    expect(kinds.at(-1)).toEqual({ model: 'plain', profile });
  });

  it('has a name for each device that is there at first', () => {
    for (const setup of sourceSetups()) expect(kindName(setup, models)).toBe(models[setup.model]);
  });
});

describe('the frame of a step', () => {
  // AP 6.3: registers 108 to 110 of unit 17.
  const BYTES = '11 03 00 6B 00 03 76 87';

  it('is bytes in any notation, or a link to a frame', () => {
    for (const text of [BYTES, '1103006b00037687', '0x11, 0x03, 0x00, 0x6B, 0x00, 0x03, 0x76, 0x87'])
      expect(tidyFrame(text)).toBe(BYTES);
    const link = 'rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3';
    for (const text of [link, `#${link}`, `https://example.org/page#${link}`, ` ${link} `])
      expect(tidyFrame(text)).toBe(BYTES);
  });

  it('stays as it was typed if it is neither', () => {
    for (const text of ['', 'read the speed', '1103 00 6', 'rtu/request?functionCode=x'])
      expect(tidyFrame(text)).toBe(text);
    expect(bytesOfLink('reference/codes')).toBeUndefined();
  });
});
