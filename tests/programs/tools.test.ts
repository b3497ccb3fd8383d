import { expect, test } from 'vitest';
import { python, run, withTools } from './tools.ts';

withTools(['python3', 'python'], () => {
  test('Python has its packages', async () => {
    const { out } = await run(python(), ['-c', 'import serial, pymodbus, minimalmodbus; print(pymodbus.__version__)']);
    expect(out).toBe('3.16.1\n');
  });
});
