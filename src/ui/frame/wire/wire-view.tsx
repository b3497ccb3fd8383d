import type { WireProps } from '../../../workbench/index.ts';
import { LineView } from './line-view.tsx';
import { PacketView } from './packet-view.tsx';
import { wireWords as words } from './wire-words.ts';

/** A frame on a serial line, or in a segment of TCP. */
export function WireView(props: WireProps) {
  const { bytes, reading } = props.frame;
  if (bytes.length === 0) return <p>{words.empty}</p>;
  const isSerial = reading.transport === 'rtu' || reading.transport === 'ascii';
  return isSerial ? <LineView key={reading.transport} {...props} /> : <PacketView {...props.frame} />;
}
