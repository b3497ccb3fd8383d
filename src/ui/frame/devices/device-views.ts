import './devices.css';

export { loadDevices as loadWords } from '../../parts/device/chosen.ts';
export { DeviceAddress } from './device-address.tsx';
export { DevicePanel } from './device-panel.tsx';
