import { describe, expect, it } from 'vitest';
import {
  deviceUnit,
  readProfiles,
  readRegisterMap,
  readTable,
  writeMbmap,
  writeProfiles,
  writeTable,
} from '../../../../src/devices/index.ts';
import { readDevice, writeDevice } from '../../../../src/devices/link-text.ts';
import { readMapsOf } from '../../../../src/devices/maps/index.ts';
import { readSheets } from '../../../../src/devices/maps/read-sheets.ts';

const mapsOf = (text: string) => readMapsOf(readSheets(text, 'map.txt'), { name: 'map.txt' });
const saidOf = (text: string) =>
  mapsOf(text).map(({ profile: { name, serial, unit, registers } }) => ({
    name,
    unit,
    serial,
    registers: registers.map((register) => [register.name, register.table, register.address]),
  }));

const sensors = (...units: readonly (number | string)[]) =>
  units.map((unit, at) => `      - name: Value ${at}\n        ${unit}\n        address: ${10 + at}\n`).join('');
const hub = (head: string, ...units: readonly string[]) =>
  `modbus:\n  - name: Hub\n${head}    sensors:\n${sensors(...units)}`;
const TCP = '    type: tcp\n    host: 192.0.2.1\n    port: 502\n';
const RTU =
  '    type: serial\n    port: /dev/ttyUSB0\n    baudrate: 9600\n    bytesize: 8\n    method: rtu\n    parity: N\n    stopbits: 1\n';

describe('the unit of a device in a configuration of Home Assistant', () => {
  it.each(['slave: 5', 'device_address: 5'])('is kept where the line is not said: %s', (key) => {
    expect(saidOf(hub(TCP, key, key))).toEqual([
      {
        name: 'Hub',
        unit: 5,
        serial: undefined,
        registers: [
          ['Value 0', 'holding-register', 10],
          ['Value 1', 'holding-register', 11],
        ],
      },
    ]);
  });

  it.each([
    ['N', 'none'],
    ['E', 'even'],
    ['O', 'odd'],
  ] as const)('is kept with the line of a serial hub, parity %s', (parity, name) => {
    const [only] = saidOf(hub(RTU.replace('parity: N', `parity: ${parity}`), 'slave: 5'));
    expect(only).toMatchObject({
      unit: undefined,
      serial: { baud: 9600, dataBits: 8, parity: name, stopBits: 1, unit: 5 },
    });
  });

  it('makes a device of each unit of a hub', () => {
    expect(saidOf(hub(TCP, 'slave: 5', 'slave: 7', 'slave: 5'))).toEqual([
      {
        name: 'Hub',
        unit: 5,
        serial: undefined,
        registers: [
          ['Value 0', 'holding-register', 10],
          ['Value 2', 'holding-register', 12],
        ],
      },
      { name: 'Hub (7)', unit: 7, serial: undefined, registers: [['Value 1', 'holding-register', 11]] },
    ]);
  });

  it('makes a device of each hub, and of hubs without units one map as before', () => {
    const two = (first: string, second: string) =>
      `${hub(TCP, first)}  - name: Other\n${TCP}    sensors:\n${sensors(second)}`;
    expect(saidOf(two('slave: 5', 'slave: 5')).map(({ name, unit }) => [name, unit])).toEqual([
      ['Hub', 5],
      ['Other', 5],
    ]);
    expect(saidOf(two('scale: 1', 'scale: 1'))).toHaveLength(1);
    // The library answers one map: it has no unit if there are several.
    expect(readRegisterMap(two('slave: 5', 'slave: 6')).profile).not.toHaveProperty('unit');
    expect(readRegisterMap(hub(TCP, 'slave: 5')).profile.unit).toBe(5);
  });
});

describe('a configuration of modpoll', () => {
  const CONFIGURATION = [
    '# Modbus Configuration File',
    '# device,<device_name>,<device_id>',
    'device,meter,3,,',
    'poll,holding_register,40000,20,BE_LE',
    'ref,volt,40000,uint16,r,V,0.1',
    'ref,energy,40002,uint32,rw,kWh',
    'ref,name,40010,string8,r',
    'poll,input_register,7,2,BE_BE',
    'ref,temp,7,int16,r,°C,0.1',
    'poll,coil,16,24,BE_BE',
    'ref,lamps,16,bool8,rw',
    'ref,pumps,17,bool16,r',
    'device,drive,4',
    'poll,discrete_input,0,8,LE_LE',
    'ref,faults,0,bool,r',
  ].join('\n');

  it('has a map for each device, with its unit', () => {
    expect(saidOf(CONFIGURATION).map(({ name, unit, registers }) => [name, unit, registers.length])).toEqual([
      ['meter', 3, 6],
      ['drive', 4, 1],
    ]);
  });

  it('has addresses as frames have them, and coils by eights', () => {
    const [meter] = mapsOf(CONFIGURATION);
    expect(
      meter?.profile.registers.map(({ name, table, address, type, order, count, factor, access, unit }) => [
        name,
        table,
        address,
        type,
        order,
        count,
        factor,
        access,
        unit,
      ]),
    ).toEqual([
      ['volt', 'holding-register', 40000, 'u16', 'ABCD', 1, 0.1, 'r', 'V'],
      ['energy', 'holding-register', 40002, 'u32', 'CDAB', 1, 1, 'rw', 'kWh'],
      ['name', 'holding-register', 40010, 'text', 'ABCD', 4, 1, 'r', ''],
      ['temp', 'input-register', 7, 'i16', 'ABCD', 1, 0.1, 'r', '°C'],
      ['lamps', 'coil', 16, 'bits', 'ABCD', 8, 1, 'rw', ''],
      ['pumps', 'coil', 24, 'bits', 'ABCD', 16, 1, 'r', ''],
    ]);
    expect([meter?.questions, meter?.faults, meter?.notices]).toEqual([[], [], []]);
  });

  it.each([
    // The order of the bytes in a register, and that of the registers.
    ['BE_BE', 'ABCD', 'ABCD'],
    ['BE_LE', 'CDAB', 'ABCD'],
    ['LE_BE', 'BADC', 'BADC'],
    ['LE_LE', 'DCBA', 'BADC'],
  ])('has the orders of %s', (endian, wide, single) => {
    const text = `device,a,1\npoll,holding_register,0,9,${endian}\nref,wide,0,float32,r\nref,single,2,int16,r\n`;
    expect(mapsOf(text)[0]?.profile.registers.map(({ order }) => order)).toEqual([wide, single]);
  });

  it('is read in its older form, in which a poll names the device', () => {
    const old =
      'poll,modsim,1,40001,5,holding_register,BE_BE\nref,register1,,40001,uint16,rw,\nref,register2,,40002,int16,rw,V\n';
    expect(saidOf(old)).toEqual([
      {
        name: 'modsim',
        unit: 1,
        serial: undefined,
        registers: [
          ['register1', 'holding-register', 40001],
          ['register2', 'holding-register', 40002],
        ],
      },
    ]);
  });

  it.each([
    'ref,address,type\nref,1,u16\n',
    'device,meter,3\nref,volt,40000,uint16\n',
    'name,address\ndevice,1\npoll,2\n',
  ])('is not what %j is', (text) => {
    expect(readSheets(text).format).not.toBe('modpoll');
  });

  it('says the row of a reference that cannot be read', () => {
    const text = 'device,meter,3\npoll,holding_register,0,9,BE_BE\nref,good,0,uint16,r\nref,bad,x,uint16,r\n';
    const [only] = mapsOf(text);
    expect(only?.profile.registers.map(({ name }) => name)).toEqual(['good']);
    expect(only?.faults.map(({ rows }) => rows)).toEqual([[4]]);
  });
});

describe('a unit without a line', () => {
  const [reading] = mapsOf(hub(TCP, 'slave: 5'));
  const profile = { ...reading!.profile, id: 'own' };

  it('is kept in every form in which a device is kept', () => {
    const again = readProfiles(writeProfiles([profile]));
    expect(again.kind === 'profiles' && again.profiles[0]?.profile.unit).toBe(5);
    const rows = writeTable(profile).map((cells, at) => ({ line: at + 1, cells }));
    expect(readTable(rows, '').profile.unit).toBe(5);
    expect(readDevice(writeDevice(profile), 'link')?.unit).toBe(5);
    expect(readRegisterMap(writeMbmap(profile), { name: 'a.mbmap.json' }).profile.unit).toBe(5);
  });

  it('gives way to that of the line', () => {
    const serial = { baud: 9600, dataBits: 8, parity: 'none', stopBits: 1 } as const;
    expect(deviceUnit(profile)).toBe(5);
    expect(deviceUnit({ ...profile, serial })).toBe(5);
    expect(deviceUnit({ ...profile, serial: { ...serial, unit: 7 } })).toBe(7);
    expect(deviceUnit({})).toBeUndefined();
  });

  it.each([-1, 256, 1.5, 'x'])('is not %s', (unit) => {
    const again = readProfiles(writeProfiles([{ ...profile, unit: unit as number }]));
    expect(again.kind === 'profiles' && again.profiles[0]?.faults).toMatchObject([{ setting: 'unit' }]);
  });
});
