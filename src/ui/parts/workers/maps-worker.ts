import { MapDesk, type MapTask } from '../../../workbench/index.ts';
import { sayAlive } from './worker-alive.ts';

let desk: MapDesk | undefined;

/** Reads register maps off the main thread. */
addEventListener('message', ({ data }: MessageEvent<MapTask>) => {
  if (data.kind === 'open') desk = new MapDesk(data);
  else (globalThis as unknown as Worker).postMessage(desk?.read(data.answers));
});
sayAlive();
