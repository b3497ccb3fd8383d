import {
  estimateScan,
  isSameLine,
  type LinkSettings,
  lineTimes,
  type ScanOrder,
  type TransactionRules,
  type TrialOrder,
} from '../../bus/index.ts';
import {
  accessOf,
  decodeFrame,
  encodeFrame,
  FIRST_UNIT,
  LAST_UNIT,
  readerOf,
  type SerialMode,
} from '../../modbus/index.ts';
import { defaultScan, formatsFor, scanOrder } from './scan-settings.ts';

/** What is looked at when no device has answered, in this order. */
export const noAnswerSteps = ['unit', 'line', 'echo', 'gap', 'length', 'wires', 'termination', 'power'] as const;
export type NoAnswerStep = (typeof noAnswerSteps)[number];

/** A request that nobody has answered. */
export interface Unanswered {
  readonly request: Uint8Array;
  readonly transport: SerialMode;
}

/** What a step does. `time` is how long it takes at most, in milliseconds. */
export type StepPlan =
  | { readonly kind: 'scan'; readonly order: ScanOrder; readonly time: number }
  | { readonly kind: 'trials'; readonly order: TrialOrder; readonly time: number }
  /** Nothing that a page could look at. */
  | { readonly kind: 'by-hand' }
  /** The request cannot be shorter, or names no unit. */
  | { readonly kind: 'impossible' };

/** The line as it is open, or would be opened. */
export interface StepLine {
  readonly settings: LinkSettings;
  readonly rules: TransactionRules;
}

/** The likeliest first. */
const SPEEDS = [9600, 19_200, 38_400, 115_200, 57_600, 4800, 2400, 1200];
const MOST_FORMATS = 4;
/** Milliseconds that a unit is waited for: it is asked for one register, or at another speed. */
const UNIT_WAIT = 100;
const LINE_WAIT = 300;
/** A silence before the request that is long enough for any device, and the longest wait for a reply. */
const LONG_SILENCE = 100;
const LONG_WAIT = 5000;

/** What a step does about a request. */
export function planOf(step: NoAnswerStep, { request, transport }: Unanswered, line: StepLine): StepPlan {
  const { unitId } = decodeFrame(request, { transport, direction: 'request' });
  const scan = (order: ScanOrder | undefined): StepPlan =>
    order ? { kind: 'scan', order, time: estimateScan(order, line.settings, line.rules).time } : { kind: 'impossible' };
  const trials = (...given: TrialOrder['trials']): StepPlan => {
    const order: TrialOrder = { kind: 'trials', transport, trials: given };
    return { kind: 'trials', order, time: trialsTime(order, line) };
  };
  switch (step) {
    case 'unit':
      return scan(
        scanOrder(
          { ...defaultScan, transport, timeout: UNIT_WAIT, firstUnit: FIRST_UNIT, lastUnit: LAST_UNIT },
          line.settings,
        ),
      );
    case 'line':
      if (unitId === undefined || unitId < FIRST_UNIT || unitId > LAST_UNIT) return { kind: 'impossible' };
      return scan(lineScan(unitId, transport, line.settings));
    case 'echo':
      return trials({ request, rules: { echo: 'off' } });
    case 'gap':
      return trials(
        { request, rules: { gap: LONG_SILENCE } },
        { request, rules: { gap: LONG_SILENCE, timeout: Math.max(LONG_WAIT, line.rules.timeout) } },
      );
    case 'length': {
      const half = halfOf({ request, transport });
      return half ? trials({ request: half, rules: {} }) : { kind: 'impossible' };
    }
    default:
      return { kind: 'by-hand' };
  }
}

/** The unit at the usual speeds and formats, as the line is now first. */
function lineScan(unit: number, transport: SerialMode, current: LinkSettings): ScanOrder | undefined {
  const order = scanOrder(
    {
      ...defaultScan,
      transport,
      timeout: LINE_WAIT,
      firstUnit: unit,
      lastUnit: unit,
      speeds: SPEEDS,
      formats: formatsFor(transport).slice(0, MOST_FORMATS),
    },
    current,
  );
  if (order?.what !== 'units') return undefined;
  return { ...order, lines: [current, ...order.lines.filter((line) => !isSameLine(line, current))] };
}

/** A request that reads half as much as this one reads or writes, from the same address; `undefined` if there is none. */
export function halfOf({ request, transport }: Unanswered): Uint8Array | undefined {
  const reading = decodeFrame(request, { transport, direction: 'request' });
  const { description, fields, unitId, functionCode } = reading;
  const { startAddress, quantity } = fields;
  const table = description?.table;
  if (typeof quantity !== 'number' || quantity < 2 || typeof startAddress !== 'number') return undefined;
  if (table === undefined || table === 'file-record' || functionCode === undefined) return undefined;
  return encodeFrame({
    transport,
    direction: 'request',
    unitId: unitId ?? 0,
    functionCode: accessOf(reading) === 'reads' ? functionCode : readerOf(table).code,
    fields: { startAddress, quantity: Math.floor(quantity / 2) },
  });
}

function trialsTime({ transport, trials }: TrialOrder, { settings, rules }: StepLine): number {
  return trials.reduce((sum, { request, rules: tried }) => {
    const all = { ...rules, ...tried, transport };
    const times = lineTimes(settings, all);
    return sum + times.characters(request.length) + times.gap + all.timeout;
  }, 0);
}
