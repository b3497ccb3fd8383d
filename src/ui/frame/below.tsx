import { DevicePlace } from './device/device-place.tsx';
import { ListPlace } from './input/list-place.tsx';

/** What stands under the frame until it has a view of its own: the list of frames of the input, the device. */
export const Below = () => (
  <>
    <ListPlace />
    <DevicePlace />
  </>
);
