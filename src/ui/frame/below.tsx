import { DevicePlace } from './device/device-place.tsx';
import { Shelf } from './examples/shelf.tsx';

/** What stands under the frame until it has a view of its own: the list of frames that were pasted, the device. */
export const Below = () => (
  <>
    <DevicePlace />
    <Shelf />
  </>
);
