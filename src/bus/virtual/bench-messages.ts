import type { EntityTable } from '../../devices/index.ts';
import type { SerialMode } from '../../modbus/index.ts';
import type { CounterName } from './counters.ts';
import type { CellRun, DeviceSetup } from './devices.ts';
import type { Fault, FaultRule } from './faults.ts';
import type { SilenceReason } from './server.ts';

/** What a window asks of the virtual devices. Plain data. */
export type VirtualOrder =
  /** All that are on the line from now on; one that was there already keeps what stands in it. */
  | { readonly kind: 'devices'; readonly devices: readonly DeviceSetup[] }
  /** All that is to go wrong from now on. */
  | { readonly kind: 'faults'; readonly faults: readonly FaultRule[] }
  /** Sets values in a device, also those that no request can write. */
  | ({ readonly kind: 'write'; readonly id: number } & CellRun)
  /** Tells from now on who hears what, and what stands in these addresses of a device. */
  | {
      readonly kind: 'watch';
      readonly id: number;
      readonly table: EntityTable;
      readonly from: number;
      readonly count: number;
    }
  | { readonly kind: 'unwatch' };

/** What a device made of a frame. */
export interface HeardBy {
  readonly id: number;
  readonly unit: number;
  readonly does: 'answer' | 'nothing';
  /** Why it says nothing, where it does. */
  readonly why?: SilenceReason | undefined;
  readonly exceptionCode?: number | undefined;
  /** What it puts on the line; empty where a fault keeps it silent. */
  readonly reply?: Uint8Array;
  readonly fault?: Fault['kind'] | undefined;
}

/** A frame on the line, and what each device made of it. */
export interface HeardFrame {
  /** Of this bench, counted from 1. */
  readonly number: number;
  /** Milliseconds since 1970. */
  readonly time: number;
  readonly transport: SerialMode;
  readonly bytes: Uint8Array;
  readonly by: readonly HeardBy[];
}

/** What stands in a device that is watched. */
export interface WatchedCells {
  readonly id: number;
  readonly table: EntityTable;
  readonly from: number;
  /** `undefined` where the device has no such address. */
  readonly values: readonly (number | undefined)[];
  readonly counts: Readonly<Record<CounterName, number>>;
  readonly eventCount: number;
  readonly listenOnly: boolean;
}

/** What the virtual devices tell the window. Plain data. */
export type VirtualNews =
  | { readonly kind: 'watched'; readonly cells: WatchedCells }
  | { readonly kind: 'heard'; readonly frames: readonly HeardFrame[] }
  /** What is left of the faults, some of which happen only so often. */
  | { readonly kind: 'faults'; readonly faults: readonly FaultRule[] }
  /** What stands in devices that somebody has written to, for the window to keep. */
  | { readonly kind: 'kept'; readonly devices: readonly Required<Pick<DeviceSetup, 'id' | 'values'>>[] };
