import { describe, expect, it } from 'vitest';
import { builtInProfiles, type Profile, rareRegisterColumns, registerColumns } from '../../../../src/devices/index.ts';
import {
  cellChoices,
  cellText,
  withCell,
  withNewRegister,
  withoutRegister,
  withRegister,
} from '../../../../src/workbench/devices/edit-register.ts';

const weg = builtInProfiles.find(({ id }) => id === 'weg-drive')!;
const [speed, , reference] = weg.registers;
const edited = (column: Parameters<typeof withCell>[2], text: string, register = speed!) => {
  const edit = withCell(weg, register, column, text);
  return edit.kind === 'register' ? edit.register : edit.faults.map(({ code }) => code);
};

describe('a cell of a register', () => {
  it('has a text that is read as the same register again, in every device that is here', () => {
    for (const profile of builtInProfiles)
      for (const register of profile.registers)
        for (const column of [...registerColumns, ...rareRegisterColumns])
          expect(withCell(profile, register, column, cellText(register, column))).toEqual({
            kind: 'register',
            register,
          });
  });

  it('changes nothing else of its register', () => {
    expect(edited('unit', ' rpm ')).toEqual({ ...speed, unit: 'rpm' });
    expect(edited('address', '0x2B0')).toEqual({ ...speed, address: 0x2b0 });
    expect(edited('factor', '1/10')).toMatchObject({ name: speed!.name, factor: 0.1 });
    expect(edited('models', 'X1, X2')).toEqual({ ...speed, models: ['X1', 'X2'] });
  });

  it('is wrong as a row of a table is', () => {
    expect(edited('name', '  ')).toEqual(['cell-missing']);
    expect(edited('address', '70000')).toEqual(['cell-out-of-range']);
    expect(edited('factor', '0')).toEqual(['factor-zero']);
    expect(edited('names', 'run')).toEqual(['names-unreadable']);
    expect(edited('count', '65000')).toEqual(['over-the-end']);
  });

  it('cannot make two registers of one name at one address', () => {
    const twin = { ...speed!, name: 'other' };
    const both: Profile = { ...weg, registers: [...weg.registers, twin] };
    expect(withCell(both, twin, 'name', speed!.name)).toEqual({
      kind: 'faults',
      faults: [{ code: 'name-twice', name: speed!.name, first: 1 }],
    });
    expect(withCell(both, speed!, 'name', speed!.name)).toMatchObject({ kind: 'register' });
  });

  it('takes the type and the access that are usual in another table, where those of before are not known there', () => {
    expect(edited('table', 'coil', reference)).toMatchObject({ table: 'coil', type: 'bits', access: 'rw' });
    expect(edited('table', 'input-register', reference)).toMatchObject({ table: 'input-register', access: 'r' });
    // In holding registers both stay.
    expect(edited('table', 'holding-register', reference)).toEqual(reference);
    expect(edited('access', 'rw', { ...speed!, table: 'input-register' })).toEqual(['table-read-only']);
  });

  it('is one of a few for table, type, order and access, and a text for all others', () => {
    const chosen = [...registerColumns, ...rareRegisterColumns].filter((column) => cellChoices(column));
    expect(chosen).toEqual(['table', 'type', 'order', 'access']);
    expect(cellChoices('access')).toEqual(['r', 'w', 'rw']);
  });
});

describe('the list of registers', () => {
  const names = ({ registers }: Profile) => registers.map(({ name }) => name);

  it('has a changed register in its place, and is without a removed one', () => {
    expect(names(withRegister(weg, 1, { ...speed!, name: 'x' }))).toEqual([names(weg)[0], 'x', ...names(weg).slice(2)]);
    expect(names(withoutRegister(weg, 1))).toEqual([names(weg)[0], ...names(weg).slice(2)]);
  });

  it('has a new one behind all others of the last one’s table', () => {
    expect(withNewRegister(weg, 'new').registers.at(-1)).toMatchObject({
      name: 'new',
      table: 'holding-register',
      address: 686,
      type: 'u16',
      access: 'rw',
    });
    const long = { ...speed!, table: 'input-register', address: 10, type: 'u32', count: 4, access: 'r' } as const;
    expect(withNewRegister({ ...weg, registers: [long] }, 'new').registers[1]).toMatchObject({
      table: 'input-register',
      address: 18,
      access: 'r',
    });
    expect(withNewRegister({ ...weg, registers: [] }, 'new').registers).toMatchObject([{ address: 0 }]);
    const last = { ...speed!, address: 65535 };
    expect(withNewRegister({ ...weg, registers: [last] }, 'new').registers[1]).toMatchObject({ address: 65535 });
  });
});
