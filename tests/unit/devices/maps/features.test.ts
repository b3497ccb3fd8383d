import { describe, expect, it } from 'vitest';
import { readProfiles, writeProfiles } from '../../../../src/devices/index.ts';
import { readRegisterMap } from '../../../../src/devices/maps/index.ts';

const registers = (text: string, answers = {}, name = '') => readRegisterMap(text, { answers, name }).profile.registers;
const meanings = (text: string) => readRegisterMap(text).columns.map(({ meaning, why }) => `${meaning}/${why}`);
const questions = (text: string) => readRegisterMap(text).questions.map(({ code }) => code);
const notices = (text: string) => readRegisterMap(text).notices.map(({ code, rows }) => `${code} ${rows.join()}`);

describe('what public maps hold beyond clean tables', () => {
  it('two columns that differ by one settle the counting, and the columns say so', () => {
    const text = 'Register,Address,Name,Table\n1,0x0000,A,holding\n11,0x000A,B,holding\n256,0x00FF,C,holding\n';
    expect(meanings(text).slice(0, 2)).toEqual(['number/pair', 'address/pair']);
    expect(questions(text)).not.toContain('counting');
    expect(registers(text).map(({ address }) => address)).toEqual([0, 10, 255]);
  });

  it('a range gives the sign, the unit and the factor', () => {
    const text =
      'Name,Table,Address,Range\nA,holding,0,"50~350 (5,0~35,0 °C)"\nB,holding,1,"0~510 (0,00~5,10 MPa)"\nC,holding,2,-80~100\nD,holding,3,-32768-32767\n';
    expect(registers(text).map(({ type, factor, unit }) => [type, factor, unit])).toEqual([
      ['u16', 0.1, '°C'],
      ['u16', 0.01, 'MPa'],
      ['i16', 1, ''],
      ['i16', 1, ''],
    ]);
    expect(notices(text)).toContain('factor-from-range 2,3');
  });

  it('40000 in use rules out that 40001 is the first', () => {
    const text = 'Name,Register,Type\nA,40000,u16\nB,40001,u16\nC,40010,u16\n';
    expect(registers(text).map(({ address }) => address)).toEqual([0, 1, 10]);
  });

  it('plain addresses that look like numbers are asked about', () => {
    const text = 'Name,FC,Address\nA,04,33000\nB,04,33049\nC,04,33055\n';
    expect(registers(text).map(({ table, address }) => [table, address])).toEqual([
      ['input-register', 33000],
      ['input-register', 33049],
      ['input-register', 33055],
    ]);
    expect(questions(text)).toContain('counting');
    expect(registers(text, { counting: 'five-digit' })[0]?.address).toBe(2999);
  });

  it('a type is put together from length, format and the sign of the minimum', () => {
    const text =
      'Name,Table,Address,Words,Format,Min\nA,holding,0,1,DEC 1,-500\nB,holding,1,2,DEC 0,0\nC,holding,3,1,MAP INT,0\nD,holding,4,1,BIT,0\n';
    expect(registers(text).map(({ type, factor }) => [type, factor])).toEqual([
      ['i16', 0.1],
      ['u32', 1],
      ['u16', 1],
      ['bits', 1],
    ]);
  });

  it('masks name bits, with the word before them or from four on', () => {
    const [one] = registers('Name,Table,Address,Values\nStatus,holding,0,"mask: 1=Run, 2=Fault, 4=Alarm"\n');
    expect(one).toMatchObject({
      type: 'bits',
      names: [
        { number: 0, name: 'Run' },
        { number: 1, name: 'Fault' },
        { number: 2, name: 'Alarm' },
      ],
    });
  });

  it('names in several languages: the first is the name, the others are kept, and blank ones filled', () => {
    const text = 'Address,Table,Name (EN),Name (DE),Tag\n0,holding,Voltage,Spannung,volt_1\n1,holding,,Strom,amp_1\n';
    expect(registers(text).map(({ name }) => name)).toEqual(['Voltage', 'Strom']);
    expect(registers(text)[0]?.description).toContain('Spannung');
  });

  it('columns that are nobody’s business are told of once', () => {
    const text =
      'Name,Table,Address,Icon,State class\nA,holding,0,mdi:flash,measurement\nB,holding,1,mdi:flash,measurement\n';
    expect(readRegisterMap(text).notices.filter(({ code }) => code === 'columns-left')).toEqual([
      { code: 'columns-left', rows: [], headers: ['Icon', 'State class'] },
    ]);
  });

  it('columns of models are kept, and the same name for other models is no repetition', () => {
    const text = 'Name,Table,Address,X100,X200\nMode,holding,0,x,\nMode,holding,0,,x\nFlow,holding,1,x,x\n';
    expect(registers(text).map(({ models }) => models)).toEqual([['X100'], ['X200'], ['X100', 'X200']]);
    expect(notices(text).filter((one) => one.startsWith('address-twice'))).toEqual([]);
    expect(registers('Name,Table,Address,Model\nMode,holding,0,"X100, X200"\n')[0]?.models).toEqual(['X100', 'X200']);
  });

  it('an outlier in a regular series is told of', () => {
    const text = `Name,Table,Address\n${[0, 1, 2, 30, 4, 5].map((address) => `N${address},holding,${address}`).join('\n')}\n`;
    expect(notices(text)).toContain('outlier 5');
  });

  it('lists of objects under any key, with the table in the key', () => {
    const text = JSON.stringify({ read: [{ name: 'A', address: '1' }], hold: [{ name: 'B', address: '2' }] });
    expect(registers(text).map(({ name, table, address }) => [name, table, address])).toEqual([
      ['A', 'input-register', 1],
      ['B', 'holding-register', 2],
    ]);
    const keyed = JSON.stringify({
      input_registers: { '100': { name: 'A', type: 'uint16' }, '101': { name: 'B', type: 'int16' } },
    });
    expect(registers(keyed).map(({ table, address, type }) => [table, address, type])).toEqual([
      ['input-register', 100, 'u16'],
      ['input-register', 101, 'i16'],
    ]);
  });

  it('numbers that are no addresses beside a table named in free text', () => {
    const text = 'All values are holding registers.,,\nPos,Name,Address\n1,A,100\n2,B,101\n';
    expect(registers(text).map(({ table, address }) => [table, address])).toEqual([
      ['holding-register', 100],
      ['holding-register', 101],
    ]);
  });

  it('the name of the file tells the table if nothing else does', () => {
    const [one] = registers('Name,Address\nA,0\n', {}, 'device-coils.csv');
    expect(one?.table).toBe('coil');
  });

  it('addresses whose runs begin at round numbers count from zero', () => {
    const starts = [100, 200, 350, 500, 820].flatMap((start) => [start, start + 1]);
    const text = `Name,Table,Address\n${starts.map((address) => `N${address},holding,${address}`).join('\n')}\n`;
    expect(questions(text)).not.toContain('counting');
    expect(registers(text)[0]?.address).toBe(100);
  });

  it('a row that is there twice becomes two registers of a profile that can be kept', () => {
    const row = 'Flow,holding,7,u16';
    const { profile } = readRegisterMap(`Name,Table,Address,Type\n${row}\n${row}\n${row}\n`, { name: 'Pump' });
    expect(profile.registers.map(({ name }) => name)).toEqual(['Flow', 'Flow (2)', 'Flow (3)']);
    expect(readProfiles(writeProfiles([profile]))).toMatchObject({ profiles: [{ faults: [] }] });
  });

  it('a text without a length is asked about', () => {
    expect(questions('Name,Table,Address,Type\nSerial,holding,0,string\n')).toContain('text-length');
  });

  it('dates are no units', () => {
    expect(
      registers(
        'Name,Table,Address,Unit\nYear,holding,0,YYYY\nMonth,holding,1,MM\nNone,holding,2,-\nV,holding,3,V\n',
      ).map(({ unit }) => unit),
    ).toEqual(['', '', '', 'V']);
  });

  it('a column that holds 3 and 4 is asked about', () => {
    expect(questions('Name,Table,Address\nA,3,0\nB,4,0\n')).toContain('function-or-digit');
    expect(questions('Name,FC,Address\nA,3,0\nB,4,0\n')).not.toContain('function-or-digit');
  });

  it('of two columns of access the first that speaks of the device counts', () => {
    const text = 'Name,Table,Address,Access HMI,Access device\nA,holding,0,R,R/W\nB,holding,1,R,R/W\n';
    expect(registers(text).map(({ access }) => access)).toEqual(['rw', 'rw']);
  });
});
