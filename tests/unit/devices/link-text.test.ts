import { describe, expect, it, test } from 'vitest';
import { builtInProfiles, readDevice, writeDevice } from '../../../src/devices/index.ts';
import { pump } from './pump.ts';

/** A device as a link has it, by version 1 of its text; it is read for ever. */
const KEPT =
  '[1,"Pumpe 3",2,[9600,8,"none",1,6],[],[[0,"Drehzahl",3,"f32","1/min",0,0,1,"CDAB"],[2,"Läuft",0],' +
  '[683,"Mode",3,"bits",0,0,0,-1,0,0,0,[[0,"run"],[1,"fault"]],"see chapter 4"]]]';

describe('a device as the text of a link', () => {
  test('of version 1 is read', () => {
    const device = readDevice(KEPT, 'own~1')!;
    expect(device).toMatchObject({
      id: 'own~1',
      name: 'Pumpe 3',
      convention: 'five-digit',
      serial: { baud: 9600, dataBits: 8, parity: 'none', stopBits: 1, unit: 6 },
    });
    expect(device.registers).toMatchObject([
      {
        name: 'Drehzahl',
        table: 'holding-register',
        address: 0,
        type: 'f32',
        unit: '1/min',
        decimals: 1,
        order: 'CDAB',
      },
      { name: 'Läuft', table: 'coil', address: 2 },
      {
        name: 'Mode',
        address: 683,
        names: [
          { number: 0, name: 'run' },
          { number: 1, name: 'fault' },
        ],
        description: 'see chapter 4',
      },
    ]);
    expect(device.registers[0]?.factor).toBe(1);
  });

  it.each([...builtInProfiles, pump].map((profile) => [profile.name, profile] as const))(
    'holds all of %s but its source and notes',
    (_, profile) => {
      const { registers, name, convention, serial, traits } = readDevice(writeDevice(profile), 'x')!;
      expect({ registers, name, convention, serial, traits }).toEqual({
        registers: profile.registers,
        name: profile.name,
        convention: profile.convention,
        serial: profile.serial,
        traits: profile.traits,
      });
    },
  );

  it.each([
    '',
    'x',
    '{}',
    '[]',
    '[3,"A",0,0,[],[]]',
    '[1,"A",0,0,[],[7]]',
    '[1,"",0,0,[],[]]',
    '[1,"A",9,0,[],[]]',
    '[1,"A",0,0,[],[["x"]]]',
  ])('%s is not one', (text) => {
    expect(readDevice(text, 'x')).toBeUndefined();
  });
});
