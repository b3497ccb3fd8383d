import { busLink, openBus } from '../bus-link.ts';
import { part, Slot } from '../slot.tsx';

const button = part(
  ['bus'],
  () => import('./send-button.tsx'),
  ({ SendButton }) => SendButton,
);

/** The place of what sends the frame, while a line is open: the bus has come then. */
export const SendPlace = () =>
  busLink.value.kind === 'open' && openBus.value !== undefined && <Slot part={button} with={{ bus: openBus.value }} />;
