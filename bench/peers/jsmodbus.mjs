import jsmodbus from 'jsmodbus';
import requestHandler from 'jsmodbus/dist/rtu-client-request-handler.js';
import { registersToBuffer, toBuffer } from './buffers.mjs';

const { ModbusRTURequest, ModbusRTUResponse, requests } = jsmodbus;
const { ReadHoldingRegistersRequestBody, WriteMultipleRegistersRequestBody } = requests;

export const encode03 = {
  run: ({ unitId, startAddress, quantity }) =>
    new ModbusRTURequest(unitId, new ReadHoldingRegistersRequestBody(startAddress, quantity)).createPayload(),
};

export const encode10 = {
  prepare: registersToBuffer,
  run: ({ unitId, startAddress, registers }) =>
    new ModbusRTURequest(unitId, new WriteMultipleRegistersRequestBody(startAddress, registers)).createPayload(),
  note: 'given the registers as bytes: faster than its way from numbers',
};

// The CRC of a reply is checked by the handler of requests. It gets a request without promise or timer.
const handler = new requestHandler.default({ on: () => {}, isOpen: true }, 17);
let received;
const request = {
  request: { body: { fc: 3 } },
  resolve: (response) => {
    received = response;
  },
  reject: (error) => {
    throw error;
  },
  done: () => {},
};

export const decode10 = {
  prepare: toBuffer,
  run: (frame) => {
    handler._currentRequest = request;
    handler.handle(ModbusRTUResponse.fromBuffer(frame));
    return received;
  },
  registers: ({ body }) => body.valuesAsArray,
  note: 'checks function code and CRC, that of the reply encoded again; no bytes explained, ends at the first fault',
};

export const decode100 = decode10;
