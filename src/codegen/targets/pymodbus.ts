import type { Call } from './calls.ts';
import { pythonLibrary } from './python-library.ts';
import { pythonText } from './python-syntax.ts';
import { isAnswered } from './shell.ts';

const UNIT = 'device_id={unitId}';
const BITS = 'reply.bits[:{quantity}]';
const REGISTERS = 'reply.registers';

/** Diagnostics whose data is 0000, by sub-function. */
const DIAGNOSTICS = {
  2: 'diag_read_diagnostic_register',
  4: 'diag_force_listen_only',
  10: 'diag_clear_counters',
  11: 'diag_read_bus_message_count',
  12: 'diag_read_bus_comm_error_count',
  13: 'diag_read_bus_exception_error_count',
  14: 'diag_read_device_message_count',
  15: 'diag_read_device_no_response_count',
  16: 'diag_read_device_nak_count',
  17: 'diag_read_device_busy_count',
  18: 'diag_read_bus_char_overrun_count',
  20: 'diag_clear_overrun_counter',
};

/** The calls of pymodbus 3.16; names of arguments are those since 3.10. */
const CALLS: readonly Call[] = [
  { code: 0x01, text: `read_coils({startAddress}, count={quantity}, ${UNIT})`, gives: BITS },
  { code: 0x02, text: `read_discrete_inputs({startAddress}, count={quantity}, ${UNIT})`, gives: BITS },
  { code: 0x03, text: `read_holding_registers({startAddress}, count={quantity}, ${UNIT})`, gives: REGISTERS },
  { code: 0x04, text: `read_input_registers({startAddress}, count={quantity}, ${UNIT})`, gives: REGISTERS },
  { code: 0x05, text: `write_coil({address}, {value}, ${UNIT})` },
  { code: 0x06, text: `write_register({address}, {value}, ${UNIT})` },
  { code: 0x07, text: `read_exception_status(${UNIT})`, gives: 'reply.status' },
  // It takes two bytes of data back, and no more.
  {
    code: 0x08,
    when: { subFunction: 0 },
    fits: ({ data }) => String(data).length === 4,
    text: `diag_query_data({data}, ${UNIT})`,
  },
  { code: 0x08, when: { subFunction: 1, data: 'FF00' }, text: `diag_restart_communication(True, ${UNIT})` },
  { code: 0x08, when: { subFunction: 1, data: '0000' }, text: `diag_restart_communication(False, ${UNIT})` },
  ...Object.entries(DIAGNOSTICS).map(([subFunction, name]) => ({
    code: 0x08,
    when: { subFunction: Number(subFunction), data: '0000' },
    text: `${name}(${UNIT})`,
    gives: 'reply',
  })),
  { code: 0x0b, text: `diag_get_comm_event_counter(${UNIT})`, gives: 'reply' },
  { code: 0x0c, text: `diag_get_comm_event_log(${UNIT})`, gives: 'reply' },
  { code: 0x0f, text: `write_coils({startAddress}, {bits}, ${UNIT})` },
  { code: 0x10, text: `write_registers({startAddress}, {registers}, ${UNIT})` },
  { code: 0x11, text: `report_device_id(${UNIT})`, gives: 'reply' },
  {
    code: 0x16,
    text: `mask_write_register(address={referenceAddress}, and_mask={andMask}, or_mask={orMask}, ${UNIT})`,
  },
  {
    code: 0x17,
    text: `readwrite_registers(read_address={readStartAddress}, read_count={readQuantity}, write_address={writeStartAddress}, values={writeRegisters}, ${UNIT})`,
    gives: REGISTERS,
  },
  // It never finds the end of this reply in RTU.
  {
    code: 0x18,
    transports: ['ascii', 'tcp'],
    text: `read_fifo_queue(address={fifoPointerAddress}, ${UNIT})`,
    gives: 'reply',
  },
  {
    code: 0x2b,
    when: { meiType: 0x0e },
    text: `read_device_information(read_code={readDeviceIdCode}, object_id={objectId}, ${UNIT})`,
    gives: 'reply',
  },
];

export const pymodbus = pythonLibrary({
  id: 'pymodbus',
  name: 'pymodbus',
  transports: ['rtu', 'ascii', 'tcp'],
  calls: CALLS,
  install: 'pymodbus[serial]>=3.10',
  truths: true,
  client: ({ transport }) => ({ name: 'client', type: transport === 'tcp' ? 'ModbusTcpClient' : 'ModbusSerialClient' }),
  head: ({ transport, options: { line, server, timeout } }) => {
    const isTcp = transport === 'tcp';
    const where = isTcp
      ? `HOST = ${pythonText(server.host)}\nPORT = ${server.port}`
      : `PORT = ${pythonText(line.port)}`;
    return `
import sys

from pymodbus${isTcp ? '' : ' import FramerType\nfrom pymodbus'}.client import ${isTcp ? 'ModbusTcpClient' : 'ModbusSerialClient'}
from pymodbus.exceptions import ModbusException

${where}
TIMEOUT = ${timeout / 1000}`;
  },
  called: ({ call, gives, about }, request) =>
    isAnswered(request)
      ? `reply = client.${call}
if reply.isError():
    print(${about}, "exception", reply.exception_code)
    return False
print(${about}, ${gives ?? '"good"'})
return True`
      : `client.${call.replace(/\)$/, ', no_response_expected=True)')}
print(${about}, "sent")
return True`,
  raw: (frame, about) => `client.send(${frame})
print(${about}, client.recv(None).hex(" ") or "no reply")
return True`,
  open: (given, { transport, options: { line, echo } }) => {
    const client =
      transport === 'tcp'
        ? `ModbusTcpClient(${given}, port=PORT, timeout=TIMEOUT, retries=0)`
        : `ModbusSerialClient(
    ${given},
    framer=FramerType.${transport.toUpperCase()},
    baudrate=${line.baud},
    bytesize=${line.dataBits},
    parity="${line.parity.charAt(0).toUpperCase()}",
    stopbits=${line.stopBits},
    timeout=TIMEOUT,
    retries=0,${echo ? '\n    handle_local_echo=True,' : ''}
)`;
    return `with ${client} as client:`;
  },
  errors: 'ModbusException',
});
