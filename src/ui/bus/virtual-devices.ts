import { effect, untracked } from '@preact/signals';
import type { DeviceSetup, FaultRule, VirtualOrder } from '../../bus/index.ts';
import type { Pace } from '../../workbench/index.ts';
import { bus } from './bus.ts';

const devices = bus.virtual;

/** What panels use that do not read signals yet. */
export const virtual = {
  get state() {
    return {
      pace: bus.pace.value,
      devices: devices.devices.value,
      lost: devices.lost.value,
      faults: devices.faults.value,
      cells: devices.cells.value,
      frames: devices.frames.value,
    };
  },
  listen: (listener: () => void) =>
    effect(() => {
      virtual.state;
      untracked(listener);
    }),
  open: () => bus.openVirtual(),
  serve: (on: boolean) => bus.serve(on),
  setPace: (pace: Pace) => bus.setPace(pace),
  setDevices: (setups: readonly DeviceSetup[]) => devices.setDevices(setups),
  setFaults: (faults: readonly FaultRule[]) => devices.setFaults(faults),
  watch: (order: Parameters<typeof devices.watch>[0]) => devices.watch(order),
  forgetFrames: () => devices.forgetFrames(),
  order: (order: VirtualOrder) => devices.order(order),
};
