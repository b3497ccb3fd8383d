import { describe, expect, it } from 'vitest';
import {
  firstProgramSettings,
  programChoiceText,
  programOptions,
  readOwnNames,
  readProgramChoice,
  storedProgramSettings,
} from '../../../../src/workbench/index.ts';

describe('the choice of a program', () => {
  it('is written and read as links have it', () => {
    expect(programChoiceText({ target: 'structured-text', part: 'check' })).toBe('structured-text.check');
    expect(readProgramChoice('structured-text.check')).toEqual({ target: 'structured-text', part: 'check' });
    // A later page may have it.
    expect(readProgramChoice('cobol.build')).toEqual({ target: 'cobol', part: 'build' });
  });

  it.each(['', 'c', 'c.', '.build', 'c.everything', 'c.build.c', 'C.build', `${'c'.repeat(50)}.build`])(
    'is not %s',
    (text) => {
      expect(readProgramChoice(text)).toBeUndefined();
    },
  );
});

describe('names of one’s own', () => {
  it('are read one a line, and what is not a name is told by its line', () => {
    expect(readOwnNames(' address = first \n\nvalue=speed = max\nunit\n= x\n')).toEqual({
      names: { address: 'first', value: 'speed = max' },
      faults: [4, 5],
    });
  });

  it('may be called as what every object has', () => {
    expect(Object.entries(readOwnNames('__proto__ = a\nconstructor = b').names)).toEqual([
      ['__proto__', 'a'],
      ['constructor', 'b'],
    ]);
  });
});

describe('settings', () => {
  const line = { baud: 9600, dataBits: 8, parity: 'none', stopBits: 2 } as const;

  it('that are not legal are as at first', () => {
    const stored = { crc: 'magic', timeout: 0, tcpPort: 70_000, port: 'COM3', host: 'x'.repeat(300), echo: 1 };
    expect(storedProgramSettings(stored)).toEqual({ ...firstProgramSettings, port: 'COM3' });
  });

  it('leave to the program what is blank, and the units to a device', () => {
    const settings = { ...firstProgramSettings, units: true, port: ' ', host: ' plc.local ', names: 'unit = slave' };
    expect(programOptions('check', settings, { profile: undefined, line }, ' ')).toEqual({
      part: 'check',
      crc: 'bitwise',
      comments: true,
      echo: false,
      timeout: 1000,
      units: false,
      profile: undefined,
      name: undefined,
      names: { unit: 'slave' },
      line: { ...line, port: undefined },
      server: { host: 'plc.local', port: 502 },
    });
  });
});
