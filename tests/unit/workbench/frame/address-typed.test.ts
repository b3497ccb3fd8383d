import { describe, expect, it } from 'vitest';
import { builtInProfiles } from '../../../../src/devices/index.ts';
import { registerNamesOf } from '../../../../src/workbench/devices/frame-names.ts';
import { addressInFrame } from '../../../../src/workbench/frame/address-typed.ts';

const namesOf = (id: string) => registerNamesOf(builtInProfiles.find((profile) => profile.id === id)!);
const inFrame = (typed: string, device?: string) =>
  addressInFrame(typed, 'holding-register', { convention: 'protocol', names: device ? namesOf(device) : undefined });

describe('the text that a frame gets for an address as typed', () => {
  it('is an address that means the same to everybody, if it was the name of a register of the device', () => {
    expect(inFrame('P0683')).toBe('P0683');
    expect(inFrame('P0683', 'weg-drive')).toBe('HR684');
    expect(inFrame('p 0681', 'weg-drive')).toBe('HR682');
    expect(inFrame('VW 804', 's7-200')).toBe('HR3');
    expect(inFrame('P0683', 's7-200')).toBe('P0683');
  });

  it('is a number as it stands, also where a device has it as a name', () => {
    expect(inFrame('683', 'weg-drive')).toBe('683');
    expect(inFrame('40108', 'modicon-984')).toBe('40108');
  });

  it('is counted from 0 or has its table, where the manual counts otherwise', () => {
    const manual = (typed: string, convention: Parameters<typeof addressInFrame>[2]['convention']) =>
      addressInFrame(typed, 'holding-register', { convention, names: undefined });
    expect(manual('40108', 'digits')).toBe('HR108');
    expect(manual('108', 'one-based')).toBe('HR108');
    expect(manual('0x6B', 'digits')).toBe('0x6B');
    expect(manual('108', 'protocol')).toBe('108');
  });
});
