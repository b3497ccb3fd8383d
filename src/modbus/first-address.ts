import type { Reading } from './reading.ts';

/** First address of what a list holds: the request's own, or that of the request answered. */
export function firstAddress({ direction, fields: own, request }: Reading, listName: string): number | undefined {
  const from = direction === 'request' ? own : request?.fields;
  const names =
    listName === 'writeRegisters'
      ? ['writeStartAddress']
      : direction === 'response'
        ? ['startAddress', 'readStartAddress']
        : ['startAddress'];
  const found = names.map((name) => from?.[name]).find((value) => typeof value === 'number');
  return found as number | undefined;
}
