import { type Call, numbersOf } from './calls.ts';
import { pythonLibrary } from './python-library.ts';
import { pythonText } from './python-syntax.ts';

/** It takes the coils that it writes for registers when it counts them, and refuses more (2.1.1). */
const MOST_BITS = 125;

/** The calls of minimalmodbus 2.1. The unit belongs to the instrument. */
const CALLS: readonly Call[] = [
  { code: 0x01, text: 'read_bits({startAddress}, {quantity}, functioncode=1)', gives: 'values' },
  { code: 0x02, text: 'read_bits({startAddress}, {quantity}, functioncode=2)', gives: 'values' },
  { code: 0x03, text: 'read_registers({startAddress}, {quantity}, functioncode=3)', gives: 'values' },
  { code: 0x04, text: 'read_registers({startAddress}, {quantity}, functioncode=4)', gives: 'values' },
  { code: 0x05, text: 'write_bit({address}, {value}, functioncode=5)' },
  { code: 0x06, text: 'write_register({address}, {value}, functioncode=6)' },
  { code: 0x0f, text: 'write_bits({startAddress}, {bits})', fits: ({ bits }) => numbersOf(bits).length <= MOST_BITS },
  { code: 0x10, text: 'write_registers({startAddress}, {registers})' },
];

export const minimalmodbus = pythonLibrary({
  id: 'minimalmodbus',
  name: 'minimalmodbus',
  transports: ['rtu', 'ascii'],
  calls: CALLS,
  install: 'minimalmodbus>=2.1',
  truths: false,
  client: () => ({ name: 'port', type: 'serial.Serial' }),
  head: ({ options: { line, timeout } }) => `
import sys

import minimalmodbus
import serial

PORT = ${pythonText(line.port)}
TIMEOUT = ${timeout / 1000}`,
  called: ({ call, gives, about }, { reading }, { transport, options: { echo } }) => {
    const mode = transport === 'ascii' ? ', minimalmodbus.MODE_ASCII' : '';
    return `instrument = minimalmodbus.Instrument(port, ${reading.unitId}${mode})${echo ? '\ninstrument.handle_local_echo = True' : ''}
${gives ? `values = instrument.${call}` : `instrument.${call}`}
print(${about}, ${gives ?? '"good"'})
return True`;
  },
  raw: (frame, about) => `port.reset_input_buffer()
port.write(${frame})
print(${about}, port.read(256).hex(" ") or "no reply")
return True`,
  open: (given, { options: { line } }) =>
    `with serial.Serial(${given}, ${line.baud}, ${line.dataBits}, "${line.parity.charAt(0).toUpperCase()}", ${line.stopBits}, TIMEOUT) as port:`,
  errors: 'OSError',
});
