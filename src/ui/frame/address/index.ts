export { addressAid } from './address-aid.tsx';
