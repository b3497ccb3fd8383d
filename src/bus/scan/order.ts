import type { EntityTable } from '../../devices/index.ts';
import {
  encodeFrame,
  type FunctionCode,
  functionCodes,
  readerOf,
  type SerialMode,
  type Values,
} from '../../modbus/index.ts';
import type { LinkSettings } from '../link/link.ts';

interface ScanBase {
  readonly kind: 'scan';
  readonly transport: SerialMode;
  /** The time-out for a reply, in milliseconds. */
  readonly timeout: number;
}

/** Looks for units. */
export interface UnitScan extends ScanBase {
  readonly what: 'units';
  /** The first and the last are scanned, too. */
  readonly first: number;
  readonly last: number;
  /** Speeds and formats that are tried in turn; an empty list means only those of the open line. */
  readonly lines: readonly LinkSettings[];
}

/** Looks for the functions of a unit, among those that change nothing. */
export interface FunctionScan extends ScanBase {
  readonly what: 'functions';
  readonly unit: number;
}

/** Looks for the addresses of a table that answer. */
export interface AddressScan extends ScanBase {
  readonly what: 'addresses';
  readonly unit: number;
  readonly table: EntityTable;
  /** As sent, counted from 0; the first and the last are scanned, too. */
  readonly first: number;
  readonly last: number;
  /** Most addresses in one request. */
  readonly most: number;
  /** A refused block of this size is not halved again. */
  readonly least: number;
}

export type ScanOrder = UnitScan | FunctionScan | AddressScan;

/** A request, and what its reply is about. */
export interface Probe {
  readonly request: Uint8Array;
  readonly unit: number;
  readonly functionCode: number;
}

/** A piece of a table. */
export interface Block {
  readonly address: number;
  readonly quantity: number;
}

const requestOf = (transport: SerialMode, unitId: number, functionCode: number, fields: Values): Uint8Array =>
  encodeFrame({ transport, direction: 'request', unitId, functionCode, fields });

const range = (first: number, last: number) =>
  Array.from({ length: Math.max(0, last - first + 1) }, (_, index) => first + index);

/** The requests that look for units: any reply to the reading of one register proves one, an exception too. */
export const unitProbes = ({ transport, first, last }: UnitScan): readonly Probe[] =>
  range(first, last).map((unit) => {
    const functionCode = readerOf('holding-register').code;
    return { request: requestOf(transport, unit, functionCode, { startAddress: 0, quantity: 1 }), unit, functionCode };
  });

/** The requests that look for functions: the probe of each that has one, as it changes nothing. */
export const functionProbes = ({ transport, unit }: FunctionScan): readonly Probe[] =>
  functionCodes.flatMap(({ code, probe }: FunctionCode) =>
    probe === undefined ? [] : [{ request: requestOf(transport, unit, code, probe), unit, functionCode: code }],
  );

/** The blocks that are asked for first. */
export const blocksOf = ({ first, last, most }: AddressScan): readonly Block[] =>
  range(0, Math.ceil((last - first + 1) / most) - 1).map((index) => {
    const address = first + index * most;
    return { address, quantity: Math.min(most, last - address + 1) };
  });

/** The request that reads a block. */
export const blockRequest = ({ transport, unit, table }: AddressScan, { address, quantity }: Block): Uint8Array =>
  requestOf(transport, unit, readerOf(table).code, { startAddress: address, quantity });

/** What a scan sends; of addresses, the blocks before any is halved. */
export function scanRequests(order: ScanOrder): readonly Uint8Array[] {
  switch (order.what) {
    case 'units':
      return unitProbes(order).map(({ request }) => request);
    case 'functions':
      return functionProbes(order).map(({ request }) => request);
    case 'addresses':
      return blocksOf(order).map((block) => blockRequest(order, block));
  }
}
