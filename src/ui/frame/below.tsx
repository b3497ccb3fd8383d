import { DevicePlace } from './device/device-place.tsx';

/** What stands under the frame until it has a view of its own: the list of frames that were pasted, the device. */
export const Below = () => <DevicePlace />;
