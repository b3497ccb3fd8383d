import { describe, expect, it } from 'vitest';
import { namedValues } from '../../../../src/devices/index.ts';
import { readRegisterMap } from '../../../../src/devices/maps/index.ts';

/** Each register in short: `holding 0 u16`, with its count, order, names, bits and what raw 490 is, if it has them. */
function inShort(text: string, answers: Readonly<Record<string, string>> = {}): string[] {
  const { profile } = readRegisterMap(text, { answers });
  return profile.registers.map((register) => {
    const { name, table, address, type, order, count, unit, names } = register;
    const [one] = namedValues({ ...profile, registers: [register] }, table, address, new Array(4).fill(0).with(0, 490));
    const words = { u16: 1, i16: 1, bits: 1 }[type as 'u16'];
    return [
      `${name}: ${table.replace(/-register|-input/, '')} ${address} ${type}`,
      order === 'ABCD' ? '' : order,
      count === 1 ? '' : `×${count}`,
      words === 1 && one?.scaled !== 490 && table.endsWith('register') ? `490 is ${one?.scaled}` : '',
      unit,
      names.map(({ number, name }) => `${number}=${name}`).join(';'),
    ]
      .filter((part) => part !== '')
      .join(' ');
  });
}
const asked = (text: string) => readRegisterMap(text).questions.map(({ code, assumed }) => `${code} ${assumed}`);
const noticed = (text: string) => readRegisterMap(text).notices.map(({ code, rows }) => `${code} ${rows.join()}`);
const lost = (text: string) => readRegisterMap(text).faults.map(({ code, rows }) => `${code} ${rows.join()}`);

describe('factors', () => {
  const scaled = (factor: string, header = 'factor') =>
    inShort(`name,table,address,type,${header},unit\nT,input,5,i16,${factor},°C\n`)[0];
  it.each([
    '0.1',
    '.1',
    '1/10',
    '/10',
    '÷10',
    '10^-1',
    '10⁻¹',
    '1e-1',
    '1:10',
    '0.1 °C',
    '"0,1"',
    '×0.1',
    'LSB = 0.1',
    '1 = 0.1',
    '0.10',
  ])('%s makes 49 of 490', (factor) => {
    expect(scaled(factor)).toBe('T: input 5 i16 490 is 49 °C');
  });
  it.each(['divisor', 'gain', 'division factor', 'Teiler', 'diviseur', 'dzielnik', '增益'])(
    '%s 10 makes 49 of 490',
    (header) => {
      expect(scaled('10', header)).toBe('T: input 5 i16 490 is 49 °C');
    },
  );
  it.each(['exponent', 'scale factor', 'power of ten', 'static_scale_factor'])('%s -1 makes 49 of 490', (header) => {
    expect(scaled('-1', header)).toBe('T: input 5 i16 490 is 49 °C');
  });
  it.each(['-', '—', 'n/a', 'none', '', '1', 'N/A', '/'])('%s is no factor', (factor) => {
    expect(scaled(factor)).toBe('T: input 5 i16 °C');
  });
  it.each(['accuracy', 'resolution'])('%s 10 multiplies', (header) => {
    expect(scaled('10', header)).toBe('T: input 5 i16 490 is 4900 °C');
  });
  it('asks about 10, and takes the answer', () => {
    const text = 'name,table,address,type,scale,unit\nA,input,5,i16,10,V\nB,input,6,i16,100,A\n';
    expect(asked(text)).toEqual(['counting zero', 'scale divide']);
    expect(inShort(text)).toEqual(['A: input 5 i16 490 is 49 V', 'B: input 6 i16 490 is 4.9 A']);
    expect(inShort(text, { scale: 'multiply' })[0]).toBe('A: input 5 i16 490 is 4900 V');
  });
  it('learns the direction from an example', () => {
    const text =
      'name,table,address,type,scale,unit,remark\nA,input,5,i16,10,°C,e.g. 490 = 49.0 °C\nB,input,6,i16,10,°C,\n';
    expect(asked(text)).toEqual(['counting zero']);
    expect(inShort(text)[1]).toBe('B: input 6 i16 490 is 49 °C');
  });
  it('takes a factor from the unit', () => {
    expect(
      inShort(
        'name,table,address,type,unit\nA,input,5,u16,0.1V\nB,input,6,u16,0.01 Hz\nC,input,7,u16,1kWh\nD,input,8,u16,°C x 0.1\nE,input,9,u16,V (/10)\n',
      ),
    ).toEqual([
      'A: input 5 u16 490 is 49 V',
      'B: input 6 u16 490 is 4.9 Hz',
      'C: input 7 u16 kWh',
      'D: input 8 u16 490 is 49 °C',
      'E: input 9 u16 490 is 49 V',
    ]);
  });
  it('asks whether decimals scale whole numbers', () => {
    const text = 'name,table,address,type,unit,decimals\nA,input,5,i16,°C,1\nB,input,6,f32,V,1\n';
    expect(asked(text)).toContain('decimals scale');
    expect(inShort(text)[0]).toBe('A: input 5 i16 490 is 49 °C');
    expect(inShort(text, { decimals: 'shown' })[0]).toBe('A: input 5 i16 °C');
  });
  it('adds an offset', () => {
    expect(inShort('name,table,address,type,factor,offset,unit\nT,input,5,i16,0.1,-40,°C\n')).toEqual([
      'T: input 5 i16 490 is 9 °C',
    ]);
  });
});

describe('lengths', () => {
  it.each([
    'Quantity',
    'Count',
    'Register Count',
    'Words',
    'No. of registers',
    'Length',
    'Anzahl Register',
    'Nombre de registres',
    'Liczba rejestrów',
    '寄存器数量',
    'Size',
  ])('%s counts registers', (header) => {
    expect(
      inShort(
        `Name,Table,Type,Address,${header}\nA,holding,i32,10,2\nB,holding,int,12,2\nC,holding,float,14,2\nD,holding,uint16,16,1\n`,
      ),
    ).toEqual(['A: holding 10 i32', 'B: holding 12 i32', 'C: holding 14 f32', 'D: holding 16 u16']);
  });
  it('counts bytes and bits', () => {
    expect(inShort('Name,Table,Address,Bytes\nA,holding,10,4\nB,holding,12,2\n')).toEqual([
      'A: holding 10 u32',
      'B: holding 12 u16',
    ]);
    expect(inShort('Name,Table,Address,Bits,Type\nA,holding,10,32,signed\nB,holding,12,16,signed\n')).toEqual([
      'A: holding 10 i32',
      'B: holding 12 i16',
    ]);
  });
  it('takes the length from the last address and from a range', () => {
    expect(inShort('Name,Table,From,To,Type\nA,holding,10,11,unsigned\nB,holding,12,12,unsigned\n')).toEqual([
      'A: holding 10 u32',
      'B: holding 12 u16',
    ]);
    expect(
      inShort('Name,Table,Address,Type\nA,holding,10-11,uint\nB,holding,"12, 13",float\nC,holding,14..15,int\n'),
    ).toEqual(['A: holding 10 u32', 'B: holding 12 f32', 'C: holding 14 i32']);
  });
  it('takes the length of a text from the register behind it, or asks', () => {
    const text = 'Name,Table,Address,Type\nSerial,holding,0,string\nModel,holding,8,string\n';
    expect(inShort(text)[0]).toBe('Serial: holding 0 text ×8');
    expect(asked(text)).toEqual(['text-length 8']);
    expect(inShort(text, { 'text-length': '16' })[1]).toBe('Model: holding 8 text ×16');
  });
});

describe('tables', () => {
  it.each([
    ['FC', '04'],
    ['Function code', '0x04'],
    ['function', 'FC4'],
    ['Table', 'Input Register'],
    ['Register type', 'MODBUS_INPUT_REGISTER'],
    ['registerType', 'inputRegister'],
    ['Area', '3x'],
    ['Type', 'Input'],
    ['Funktionscode', '4'],
    ['功能码', '04'],
    ['Function', 'Read Input Registers (04)'],
    ['Table', 'Eingangsregister'],
    ['Tabla|Table', 'Registro de entrada'],
  ])('%s %s is the table of input registers', (header, cell) => {
    expect(
      inShort(`Name,Address,${header},Unit\nA,10,${cell},V\nB,11,${cell},A\n`).map((one) => one.split(' ')[1]),
    ).toEqual(['input', 'input']);
  });
  it('knows the writing functions', () => {
    expect(
      inShort('Name,Address,FC\nA,10,"3, 6, 16"\nB,11,03/06\nC,12,"1,5,15"\nD,13,02\n').map((one) => one.split(' ')[1]),
    ).toEqual(['holding', 'holding', 'coil', 'discrete']);
  });
  it('takes digits with a 0 among them for digits, and with a 2 for functions', () => {
    expect(inShort('name,table,address\nA,0,1\nB,4,1\n').map((one) => one.split(' ')[1])).toEqual(['coil', 'holding']);
    expect(inShort('name,table,address\nA,2,1\nB,4,1\n').map((one) => one.split(' ')[1])).toEqual([
      'discrete',
      'input',
    ]);
  });
  it('takes the table from a heading, a title and a row of settings', () => {
    expect(inShort('Holding registers,,\nName,Address,Unit\nA,0,V\n')).toEqual(['A: holding 0 u16 V']);
    expect(inShort('Input registers (function code 04),,\nName,Address,Unit\nA,0,V\n')).toEqual(['A: input 0 u16 V']);
    expect(inShort('Name,Address,Unit\nInput registers,,\nA,0,V\nHolding registers,,\nB,0,A\n')).toEqual([
      'A: input 0 u16 V',
      'B: holding 0 u16 A',
    ]);
    expect(inShort('#table,input\nName,Address,Unit\nA,0,V\n')).toEqual(['A: input 0 u16 V']);
  });
});

describe('addresses', () => {
  const places = (cells: string, header = 'Register') =>
    inShort(
      `Name,Type,${header}\n${cells
        .split(' | ')
        .map((cell, at) => `N${'PQRSTUV'[at]},u16,"${cell}"`)
        .join('\n')}\n`,
    ).map((one) => one.split(' ').slice(1, 3).join(' '));
  it.each([
    ['40001 | 40002', ['holding 0', 'holding 1']],
    ['400001 | 400002', ['holding 0', 'holding 1']],
    ['4x0001 | 4x0002', ['holding 0', 'holding 1']],
    ['4-0001 | 4-0002', ['holding 0', 'holding 1']],
    ['40 001 | 40 002', ['holding 0', 'holding 1']],
    ['30001 | 40001 | 10001', ['input 0', 'holding 0', 'discrete 0']],
    ['HR1 | IR2', ['holding 0', 'input 1']],
    ['%MW100 | %MW101', ['holding 100', 'holding 101']],
    ['0x1000 | 0x1001', ['holding 4096', 'holding 4097']],
    ['1000h | 1001h', ['holding 4096', 'holding 4097']],
    ['H1000 | H1001', ['holding 4096', 'holding 4097']],
    ['&H1000 | &H1001', ['holding 4096', 'holding 4097']],
    ['0x1000 (4096) | 0x1001 (4097)', ['holding 4096', 'holding 4097']],
    ['00FE | 0100 | 0BB7', ['holding 254', 'holding 256', 'holding 2999']],
    ['999 | 1.000 | 1.001', ['holding 999', 'holding 1000', 'holding 1001']],
    ['1,000 | 1,001', ['holding 1000', 'holding 1001']],
    ['40000 | 40001 | 40002', ['holding 0', 'holding 1', 'holding 2']],
    ['40001 | 40002 | 40003 | 50001', ['holding 0', 'holding 1', 'holding 2']],
    ['40001 | 40003 | 400005', ['holding 0', 'holding 2', 'holding 4']],
    ['0009 | 0010', ['holding 9', 'holding 10']],
  ])('%s', (cells, expected) => {
    expect(places(cells)).toEqual(expected);
  });
  it('reads a text with its length behind the number', () => {
    expect(inShort('Name,Address\nSerial,412380.10L\nModel,412400.16H\n')).toEqual([
      'Serial: holding 12379 text BADC ×5',
      'Model: holding 12399 text ×8',
    ]);
  });
  it('settles the counting by a second column', () => {
    const text = 'Register,Address,Name,Table\n101,0x0064,A,holding\n103,0x0066,B,holding\n';
    expect(asked(text)).not.toContain('counting zero');
    expect(inShort(text)).toEqual(['A: holding 100 u16', 'B: holding 102 u16']);
    expect(inShort('Dec,Hex,Name,Table\n100,64,A,holding\n102,66,B,holding\n255,FF,C,holding\n')).toEqual([
      'A: holding 100 u16',
      'B: holding 102 u16',
      'C: holding 255 u16',
    ]);
  });
  it('asks how plain numbers count, and takes the answer', () => {
    const text = 'Name,Register,Table\nA,1,holding\nB,2,holding\n';
    expect(asked(text)).toContain('counting zero');
    expect(inShort(text, { counting: 'one' })[0]).toBe('A: holding 0 u16');
    expect(asked('Name,Register,Table\nA,0,holding\nB,2,holding\n')).not.toContain('counting zero');
  });
});

describe('bits', () => {
  const status = ['Run', 'Fault'];
  it.each([
    '40001.0 | 40001.1',
    '40001:0 | 40001:1',
    '40001/0 | 40001/1',
    '40001 bit 0 | 40001 bit 1',
    '40001[0] | 40001[1]',
    '40001.b0 | 40001.b1',
  ])('%s', (cells) => {
    const text = `Register,Name,Table\n${cells
      .split(' | ')
      .map((cell, at) => `${cell},${status[at]},holding`)
      .join('\n')}\n`;
    expect(inShort(text)).toEqual(['40001: holding 0 bits 0=Run;1=Fault']);
  });
  it('reads a column of bits, and bits below their register', () => {
    expect(inShort('Name,Table,Address,Bit\nStatus,holding,10,\nRun,holding,10,0\nFault,holding,10,3\n')).toEqual([
      'Status: holding 10 bits 0=Run;3=Fault',
    ]);
    expect(inShort('Name,Table,Address,Bit\nStatus,holding,10,\nRun,,,0\nFault,,,3\n')).toEqual([
      'Status: holding 10 bits 0=Run;3=Fault',
    ]);
    expect(inShort('Name,Table,Address,Type\nRun,holding,10,bool (bit 0)\nFault,holding,10,bool (bit 4)\n')).toEqual([
      '10: holding 10 bits 0=Run;4=Fault',
    ]);
    expect(inShort('Name,Table,Address\nRun [bit 0],holding,10\nFault [bit 4],holding,10\n')[0]).toMatch(
      /holding 10 bits 0=Run.*;4=Fault/,
    );
  });
  it('mends the tenth bit that a spreadsheet shortens', () => {
    const bits = Array.from(
      { length: 12 },
      (_, bit) => `${bit === 10 ? '40001.1' : `40001.${bit}`},N${bit},holding`,
    ).join('\n');
    expect(inShort(`Register,Name,Table\n${bits}\n`)[0]).toContain('9=N9;10=N10;11=N11');
  });
  it('reads a byte at a bit as the byte of its register', () => {
    expect(inShort('Name,Table,Address,Type\nSOC,input,5.b0,uint8\nSOH,input,5.b8,uint8\n')).toEqual([
      'SOC: input 5 u8l',
      'SOH: input 5 u8h',
    ]);
  });
  it('takes 1, 2, 4, 8 for masks', () => {
    expect(inShort('Name,Table,Address,Values\nStatus,holding,10,"1=Run, 2=Fault, 4=Alarm, 8=Local"\n')).toEqual([
      'Status: holding 10 bits 0=Run;1=Fault;2=Alarm;3=Local',
    ]);
    expect(inShort('Name,Table,Address,Value\nStatus,holding,10,\nRun,,,1\nFault,,,2\nAlarm,,,4\nLocal,,,8\n')).toEqual(
      ['Status: holding 10 bits 0=Run;1=Fault;2=Alarm;3=Local'],
    );
  });
});

describe('names of values', () => {
  const named = (cell: string) => inShort(`name,table,address,values\nMode,holding,0,"${cell}"\n`)[0];
  it.each([
    '0=Cool, 1=Heat, 2=Auto',
    '0=Cool; 1=Heat; 2=Auto',
    '0: Cool 1: Heat 2: Auto',
    '0 = Cool / 1 = Heat / 2 = Auto',
    '0 - Cool, 1 - Heat, 2 - Auto',
    '0=Cool\n1=Heat\n2=Auto',
    '0:Cool|1:Heat|2:Auto',
    '0x00=Cool; 0x01=Heat; 0x02=Auto',
    '00H: Cool, 01H: Heat, 02H: Auto',
    '0→Cool; 1→Heat; 2→Auto',
    '0—Cool；1—Heat；2—Auto',
    '(0) Cool (1) Heat (2) Auto',
    'Cool 0, Heat 1, Auto 2',
    'Cool=0; Heat=1; Auto=2',
    '0 Cool; 1 Heat; 2 Auto',
    "0='Cool', 1='Heat', 2='Auto'",
  ])('%s', (cell) => {
    expect(named(cell)).toBe('Mode: holding 0 u16 0=Cool;1=Heat;2=Auto');
  });
  it('reads them from the name and from rows below', () => {
    expect(inShort('name,table,address\nMode (0=Standby; 7=Heating),holding,0\n')[0]).toContain('0=Standby;7=Heating');
    expect(inShort('Name,Table,Address,Unit\nMode,holding,0,\n0 = Off,,,\n1 = On,,,\nFlow,holding,1,V\n')).toEqual([
      'Mode: holding 0 u16 0=Off;1=On',
      'Flow: holding 1 u16 V',
    ]);
  });
  it('reads them from columns for false and true', () => {
    const text =
      '# Discrete inputs\n\n| Address | False | True | Description |\n|---|---|---|---|\n| 0x0001 | Clock unset | Clock set | Clock status |\n';
    expect(inShort(text)).toEqual(['Clock status: discrete 1 bits 0=Clock unset;1=Clock set']);
  });
  it('reads them from an appendix', () => {
    const text = 'Name,Table,Address,Unit\nMode,holding,0,\nFlow,holding,1,V\nMode,,,\n0,Off,,\n1,On,,\n';
    expect(inShort(text)).toEqual(['Mode: holding 0 u16 0=Off;1=On', 'Flow: holding 1 u16 V']);
  });
  it('tells of a key with two names', () => {
    expect(noticed('name,table,address,names\nMode,holding,0,0=Off; 0=Idle; 1=On\n')).toContain('names-twice 2');
  });
  it.each(['0~80 °C', '0-100', '-32768-32767', '0…100 %', '0 to 50', '10 ~ 20', '0,0 – 35,0'])(
    '%s is a range',
    (cell) => {
      expect(named(cell)).toMatch(/^Mode: holding 0 [iu]16( 490 is 49)?( %| °C)?$/);
      expect(noticed(`name,table,address,values\nMode,holding,0,"${cell}"\n`)).toContain('range-kept 2');
    },
  );
});

describe('rows', () => {
  it('finds the header below titles and above units, and over two rows', () => {
    expect(inShort('ACME Controller\n\nVersion 1.2,2020-01-01\nName,Table,Address,Type\nA,holding,0,u16\n')).toEqual([
      'A: holding 0 u16',
    ]);
    expect(inShort('Register,,Value,\nDec,Hex,Type,Unit\n,,,\n10,0A,u16,V\n11,0B,i16,A\n')).toEqual([
      '10: holding 10 u16 V',
      '11: holding 11 i16 A',
    ]);
    expect(inShort('Name,Table,Address,Type\n,,(dec),\nA,holding,5,u16\n')).toEqual(['A: holding 5 u16']);
  });
  it('reads a second table with another header below the first', () => {
    expect(
      inShort('Name,Table,Address,Type\nA,holding,0,u16\n\nAddress,Name,Type,Unit,Table\n7,B,i16,V,input\n'),
    ).toEqual(['A: holding 0 u16', 'B: input 7 i16 V']);
    expect(inShort('Name,Table,Address,Type\nA,holding,0,u16\nName,Table,Address,Type\nB,holding,1,u16\n')).toEqual([
      'A: holding 0 u16',
      'B: holding 1 u16',
    ]);
  });
  it('leaves comments and headings out, and says so', () => {
    const text =
      'Name,Table,Address,Type\n# Section one\nA,holding,0,u16\nTemperatures,,,\nB,holding,1,u16\n#read 0-20\n';
    expect(inShort(text)).toEqual(['A: holding 0 u16', 'B: holding 1 u16']);
    expect(noticed(text)).toContain('heading 2,4,6');
    expect(lost(text)).toEqual([]);
  });
  it('imports registers that are not in use, and says so', () => {
    const text = 'Name,Table,Address,Type\nReserved,holding,0,\nnicht verwendet,holding,1,\nA,holding,2,u16\n';
    expect(inShort(text)).toHaveLength(3);
    expect(noticed(text)).toContain('unused 2,3');
  });
  it('tells of an address in use twice, and of values that overlap', () => {
    expect(
      noticed('Name,Table,Address,Type\nA,holding,0,u32\nB,holding,1,u16\nC,holding,9,u16\nD,holding,9,i16\n'),
    ).toEqual(expect.arrayContaining(['address-twice 4,5', 'overlap 2,3']));
  });
  it('lists rows whose address cannot be read or is missing', () => {
    expect(lost('Name,Table,Address,Type\nA,holding,abc,u16\nB,holding,,u16\nC,holding,70000,u16\n')).toEqual([
      'address-unreadable 2',
      'address-missing 3',
      'address-outside 4',
    ]);
  });
  it('asks for the codes of a maker once', () => {
    const text = 'Name,Table,Address,Data type\nA,holding,0,2\nB,holding,1,6\nC,holding,3,7\n';
    expect(asked(text)).toEqual(['type-codes 2=u16; 6=u16; 7=u16']);
    expect(inShort(text, { 'type-codes': '2=i16/10; 6=u32; 7=f32' })).toEqual([
      'A: holding 0 i16 490 is 49',
      'B: holding 1 u32',
      'C: holding 3 f32',
    ]);
  });
  it('reads signs and units out of ranges', () => {
    expect(
      inShort('Name,Table,Address,Range\nA,holding,0,-80~100\nB,holding,1,0~80 °C\nC,holding,2,-32768-32767\n').map(
        (one) => one.split(' ').slice(3).join(' '),
      ),
    ).toEqual(['i16', 'u16 °C', 'i16']);
  });
  it('reads Chinese headers', () => {
    expect(inShort('地址,名称,数据类型,单位,读写,系数\n0,电压,U16,V,只读,0.1\n')).toEqual([
      '电压: holding 0 u16 490 is 49 V',
    ]);
  });
  it('decides what a column called type holds by its cells', () => {
    expect(inShort('Name,Address,Type\nA,0,R/W\nB,1,R\n')).toEqual(['A: holding 0 u16', 'B: holding 1 u16']);
    expect(inShort('Name,Address,Type,Format\nA,0,Holding,u16\nB,1,Input,i16\n')).toEqual([
      'A: holding 0 u16',
      'B: input 1 i16',
    ]);
  });
});
