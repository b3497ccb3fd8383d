import './wire.css';
import type { TabProps } from '../../current-frame.ts';
import { useWords } from '../../words.ts';
import { LineView } from './line-view.tsx';
import { PacketView } from './packet-view.tsx';

/** A frame on a serial line, or in a segment of TCP. */
export function WireTab({ of }: TabProps) {
  const { draft, frame } = of.value;
  const words = useWords('wire');
  if (frame === undefined) return <p>{words.noFrame}</p>;
  if (frame.bytes.length === 0) return <p>{words.empty}</p>;
  const { transport } = frame.reading;
  const isSerial = transport === 'rtu' || transport === 'ascii';
  return isSerial ? <LineView key={transport} draft={draft} frame={frame} /> : <PacketView {...frame} />;
}
