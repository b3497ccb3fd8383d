import type { Table } from '../../modbus/index.ts';
import { dictionary } from '../../modbus/index.ts';

export interface Choice {
  readonly name: string;
  readonly hint?: string;
}

const labels: Readonly<Record<string, string>> = dictionary({
  unitId: 'Unit (slave address)',
  transactionId: 'Transaction identifier',
  protocolId: 'Protocol identifier',
  length: 'Length',
  functionCode: 'Function code',
  checksum: 'Checksum',
  start: 'Start',
  end: 'End',
  characters: 'Characters',
  rest: 'Left over',
  after: 'After the frame',
  startAddress: 'Start address',
  quantity: 'Quantity',
  byteCount: 'Byte count',
  bits: 'Bits, lowest address first',
  registers: 'Registers',
  address: 'Address',
  value: 'Value',
  rawValue: 'Raw value',
  padding: 'Unused bits',
  outputData: 'Exception status',
  subFunction: 'Sub-function',
  data: 'Data',
  status: 'Status',
  eventCount: 'Event count',
  messageCount: 'Message count',
  events: 'Events, newest first',
  subRequests: 'Sub-requests',
  subResponses: 'Sub-responses',
  responseDataLength: 'Response data length',
  fileResponseLength: 'File response length',
  dataLength: 'Data length',
  referenceType: 'Reference type',
  fileNumber: 'File number',
  recordNumber: 'Record number',
  recordLength: 'Record length',
  recordData: 'Record data',
  referenceAddress: 'Reference address',
  andMask: 'AND mask',
  orMask: 'OR mask',
  readStartAddress: 'Read start address',
  readQuantity: 'Read quantity',
  writeStartAddress: 'Write start address',
  writeQuantity: 'Write quantity',
  writeByteCount: 'Write byte count',
  writeRegisters: 'Write registers',
  fifoPointerAddress: 'FIFO pointer address',
  fifoCount: 'FIFO count',
  fifoValues: 'FIFO values',
  meiType: 'MEI type',
  meiData: 'MEI data',
  readDeviceIdCode: 'Read device id code',
  objectId: 'Object id',
  conformityLevel: 'Conformity level',
  moreFollows: 'More follows',
  nextObjectId: 'Next object id',
  numberOfObjects: 'Number of objects',
  objects: 'Objects',
  valueHex: 'Value',
  exceptionCode: 'Exception code',
});

/** Names above the bytes, where there is little room. */
const short: Readonly<Record<string, string>> = dictionary({
  unitId: 'unit',
  functionCode: 'function',
  transactionId: 'transaction',
  protocolId: 'protocol',
  checksum: 'checksum',
  startAddress: 'address',
  referenceAddress: 'address',
  fifoPointerAddress: 'address',
  bits: 'bits',
  events: 'events',
  outputData: 'status',
  start: 'start',
  end: 'end',
});

const statuses: Readonly<Record<number, Choice>> = {
  0: { name: 'Ready', hint: 'no program command is being worked on' },
  65535: { name: 'Busy', hint: 'an earlier program command is still being worked on' },
};

/** What the values of a choice are called, by field and value. */
const choices: Readonly<Record<string, Readonly<Record<number, Choice>>>> = dictionary({
  status: statuses,
  referenceType: { 6: { name: 'File records' } },
  meiType: { 13: { name: 'CANopen General Reference' }, 14: { name: 'Read Device Identification' } },
  readDeviceIdCode: {
    1: { name: 'Basic', hint: 'stream of objects 00–02' },
    2: { name: 'Regular', hint: 'stream of objects 00–7F' },
    3: { name: 'Extended', hint: 'stream of objects 00–FF' },
    4: { name: 'One object', hint: 'individual access' },
  },
  conformityLevel: {
    1: { name: 'Basic', hint: 'stream access only' },
    2: { name: 'Regular', hint: 'stream access only' },
    3: { name: 'Extended', hint: 'stream access only' },
    129: { name: 'Basic', hint: 'stream and individual access' },
    130: { name: 'Regular', hint: 'stream and individual access' },
    131: { name: 'Extended', hint: 'stream and individual access' },
  },
  moreFollows: { 0: { name: 'No' }, 255: { name: 'Yes', hint: 'ask again from the next object id' } },
  objectId: {
    0: { name: 'VendorName' },
    1: { name: 'ProductCode' },
    2: { name: 'MajorMinorRevision' },
    3: { name: 'VendorUrl' },
    4: { name: 'ProductName' },
    5: { name: 'ModelName' },
    6: { name: 'UserApplicationName' },
  },
  exceptionCode: {
    1: { name: 'ILLEGAL FUNCTION', hint: 'the device does not know this function, or not in its present state' },
    2: { name: 'ILLEGAL DATA ADDRESS', hint: 'the address, or address and quantity together, is not in the device' },
    3: { name: 'ILLEGAL DATA VALUE', hint: 'a quantity or another value in the request is not allowed' },
    4: { name: 'SERVER DEVICE FAILURE', hint: 'the device failed while carrying it out' },
    5: { name: 'ACKNOWLEDGE', hint: 'accepted, and it will take long: ask later whether it is done' },
    6: { name: 'SERVER DEVICE BUSY', hint: 'a long command is running: ask again later' },
    7: { name: 'NEGATIVE ACKNOWLEDGE', hint: 'a program function could not be carried out' },
    8: { name: 'MEMORY PARITY ERROR', hint: 'the extended memory failed its check' },
    10: { name: 'GATEWAY PATH UNAVAILABLE', hint: 'the gateway has no free or configured path to the device' },
    11: { name: 'GATEWAY TARGET DEVICE FAILED TO RESPOND', hint: 'the device behind the gateway is silent' },
  },
});

export interface TableWords {
  readonly one: string;
  readonly many: string;
}

const tables: Readonly<Record<Table, TableWords>> = {
  coil: { one: 'coil', many: 'coils' },
  'discrete-input': { one: 'discrete input', many: 'discrete inputs' },
  'input-register': { one: 'input register', many: 'input registers' },
  'holding-register': { one: 'holding register', many: 'holding registers' },
  'file-record': { one: 'file record', many: 'file records' },
};

export const en = { labels, short, choices, tables };
