import { expect, test } from 'vitest';
import { builtInProfiles, readRegisterMap } from '../../../../src/devices/index.ts';
import { profileFiles, writeProfileFile } from '../../../../src/workbench/index.ts';

const [drive] = builtInProfiles;
if (!drive) throw new Error('There is no device.');

test.each(profileFiles)('what is written as .%s has every register at its address when it is read again', (file) => {
  const { profile } = readRegisterMap(writeProfileFile(drive, file), { name: `drive.${file}` });
  expect(profile.registers.map(({ name, table, address }) => ({ name, table, address }))).toEqual(
    drive.registers.map(({ name, table, address }) => ({ name, table, address })),
  );
});

test('Markdown is a table to read, without columns that are empty', () => {
  const [title, , source, , head, , first] = writeProfileFile(drive, 'md').split('\n');
  expect(title).toBe('# WEG drive');
  expect(source).toBe(drive.source);
  expect(head).toMatch(/^\| name \| table \| address \| type \|/);
  expect(head).not.toContain('group');
  expect(first).toMatch(/^\| P0681 actual speed \| holding-register \| 681 \| i16 \|/);
});
