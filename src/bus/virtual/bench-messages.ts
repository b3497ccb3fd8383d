import type { EntityTable } from '../../devices/index.ts';
import type { SerialMode } from '../../modbus/index.ts';
import type { CounterName } from './counters.ts';
import type { CellRun, DeviceSetup } from './devices.ts';
import type { Fault, FaultRule } from './faults.ts';
import type { SilenceReason } from './server.ts';

/** What a window asks of the virtual devices. Plain data. */
export type VirtualOrder =
  /** All devices on the line from now on; those that were there already keep their values. */
  | { readonly kind: 'devices'; readonly devices: readonly DeviceSetup[] }
  /** All faults from now on. */
  | { readonly kind: 'faults'; readonly faults: readonly FaultRule[] }
  /** Sets values in a device, even those that no request can write. */
  | ({ readonly kind: 'write'; readonly id: number } & CellRun)
  /** From now on, who hears what and the values at these addresses of a device are told. */
  | {
      readonly kind: 'watch';
      readonly id: number;
      readonly table: EntityTable;
      readonly from: number;
      readonly count: number;
    }
  | { readonly kind: 'unwatch' };

/** What a device did with a frame. */
export interface HeardBy {
  readonly id: number;
  readonly unit: number;
  readonly does: 'answer' | 'nothing';
  /** Why it says nothing, if it says nothing. */
  readonly why?: SilenceReason | undefined;
  readonly exceptionCode?: number | undefined;
  /** What it sends; empty if a fault keeps it silent. */
  readonly reply?: Uint8Array;
  readonly fault?: Fault['kind'] | undefined;
}

/** A frame on the line, and what each device did with it. */
export interface HeardFrame {
  /** Of this bench, counted from 1. */
  readonly number: number;
  /** Milliseconds since 1970. */
  readonly time: number;
  readonly transport: SerialMode;
  readonly bytes: Uint8Array;
  readonly by: readonly HeardBy[];
}

/** The values in a device that is watched. */
export interface WatchedCells {
  readonly id: number;
  readonly table: EntityTable;
  readonly from: number;
  /** `undefined` if the device has no such address. */
  readonly values: readonly (number | undefined)[];
  readonly counts: Readonly<Record<CounterName, number>>;
  readonly eventCount: number;
  readonly listenOnly: boolean;
}

/** What the virtual devices tell the window. Plain data. */
export type VirtualNews =
  | { readonly kind: 'watched'; readonly cells: WatchedCells }
  | { readonly kind: 'heard'; readonly frames: readonly HeardFrame[] }
  /** The faults that are left; some happen only a number of times. */
  | { readonly kind: 'faults'; readonly faults: readonly FaultRule[] }
  /** The values of devices that somebody has written to, for the window to store. */
  | { readonly kind: 'kept'; readonly devices: readonly Required<Pick<DeviceSetup, 'id' | 'values'>>[] };
