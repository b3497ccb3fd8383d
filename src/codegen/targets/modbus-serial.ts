import { MBAP } from '../../modbus/index.ts';
import type { PlannedRequest } from '../plan.ts';
import { quoted } from './c-like.ts';
import { type Call, callFor, callText, numbersOf, type WriteValue } from './calls.ts';
import { javascriptLibrary, serialSettings, wherePart } from './javascript-library.ts';
import { isAnswered } from './shell.ts';

const DATA = 'reply.data';

/**
 * The calls of modbus-serial 8.0, the unit being the client's. On a serial line it knows how long the replies to these functions
 * are; others it sends, but never gives the reply.
 */
const CALLS: readonly Call[] = [
  { code: 0x01, text: 'readCoils({startAddress}, {quantity})', gives: 'reply.data.slice(0, {quantity})' },
  { code: 0x02, text: 'readDiscreteInputs({startAddress}, {quantity})', gives: 'reply.data.slice(0, {quantity})' },
  { code: 0x03, text: 'readHoldingRegisters({startAddress}, {quantity})', gives: DATA },
  { code: 0x04, text: 'readInputRegisters({startAddress}, {quantity})', gives: DATA },
  { code: 0x05, text: 'writeCoil({address}, {value})' },
  { code: 0x06, text: 'writeRegister({address}, {value})' },
  { code: 0x0f, text: 'writeCoils({startAddress}, {bits})' },
  { code: 0x10, text: 'writeRegisters({startAddress}, {registers})' },
  { code: 0x16, transports: ['tcp'], text: 'maskWriteRegister({referenceAddress}, {andMask}, {orMask})' },
  {
    code: 0x17,
    transports: ['tcp'],
    text: 'readWriteRegisters({readStartAddress}, {readQuantity}, {writeStartAddress}, {writeQuantity}, {writeRegisters})',
    gives: DATA,
  },
  {
    code: 0x2b,
    transports: ['rtu', 'tcp'],
    when: { meiType: 0x0e },
    text: 'readDeviceIdentification({readDeviceIdCode}, {objectId})',
    gives: DATA,
  },
];

const write: WriteValue = (value, field) => {
  if (!Array.isArray(value)) return String(value);
  return `[${numbersOf(value)
    .map((one) => (field === 'bits' ? String(one !== 0) : String(one)))
    .join(', ')}]`;
};

const callOf = (request: PlannedRequest): Call | undefined => callFor(CALLS, request);

/** The functions whose replies the library reads as raw bytes. */
const CUSTOM = [
  [65, 72],
  [100, 110],
] as const;

/** A call with raw data, where the library reads the reply: by its length, which only the header of TCP says. */
function customCall({ reading, bytes }: PlannedRequest): string | undefined {
  const { functionCode = 0, forced, transport } = reading;
  const isRead = CUSTOM.some(([from, to]) => functionCode >= from && functionCode <= to);
  if (!isRead || Object.keys(forced).length > 0 || transport !== 'tcp') return undefined;
  return `customFunction(${functionCode}, [${bytes.subarray(MBAP + 1).join(', ')}])`;
}

export const modbusSerial = javascriptLibrary({
  id: 'modbus-serial',
  name: 'modbus-serial',
  transports: ['rtu', 'ascii', 'tcp'],
  parts: ['exchange'],
  install: () => 'modbus-serial',
  head: (plan) => `
import { fileURLToPath } from "node:url";
import ModbusRTU from "modbus-serial";

${wherePart(plan)}
const TIMEOUT = ${plan.options.timeout}; // milliseconds`,
  shared: () => [],
  constant: (request) => ((callOf(request) ?? customCall(request)) ? undefined : 'bytes'),
  request: (request, frame) => {
    const about = quoted(`${request.about}:`);
    const call = callOf(request);
    const text = call ? callText(call, request, write) : customCall(request);
    if (text === undefined)
      return `console.log(${about}, "not sent:", Buffer.from(${frame}).toString("hex"));\nreturn false;`;
    const unit = `client.setID(${request.reading.unitId});`;
    if (!isAnswered(request))
      return `${unit}
// No reply comes, so that the call ends with the time-out.
await client.${text}.catch(() => {});
console.log(${about}, "sent");
return true;`;
    const gives = (call ? call.gives : DATA)?.replace('{quantity}', String(request.reading.fields['quantity']));
    return `${unit}
${gives ? 'const reply = ' : ''}await client.${text};
console.log(${about}, ${gives ?? '"good"'});
return true;`;
  },
  offline: () => '',
  open: (given, plan) => {
    const { transport } = plan;
    const settings = transport === 'tcp' ? '{ port: PORT }' : serialSettings(plan);
    const how = { rtu: 'connectRTUBuffered', ascii: 'connectAsciiSerial', tcp: 'connectTCP', pdu: 'connectTCP' }[
      transport
    ];
    return `const client = new ModbusRTU();
client.setTimeout(TIMEOUT);
await client.${how}(${given}, ${settings});`;
  },
  close: () => 'await new Promise((done) => client.close(done));',
});
