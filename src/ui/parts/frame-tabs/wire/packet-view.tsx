import { useRef, useState } from 'preact/hooks';
import { MBAP, type Reading } from '../../../../modbus/index.ts';
import { formatBytes } from '../../../../notation/index.ts';
import { Fold } from '../../../kit/fold.tsx';
import { useSize } from '../../../kit/use-size.ts';
import { useWords } from '../../words.ts';
import { usePictureTexts } from './picture/drawing.ts';
import { Packet } from './picture/packet.tsx';
import { SaveBar } from './save.tsx';

interface PacketProps {
  readonly bytes: Uint8Array;
  readonly reading: Reading;
}

/** Pixels that a saved picture is wide. */
const SAVED_WIDTH = 900;

/** The segment that carries a frame over TCP, or a bare PDU, as a layout of its bytes. */
export function PacketView({ bytes, reading }: PacketProps) {
  const words = useWords('wire');
  const texts = usePictureTexts();
  const place = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(0);
  useSize(place, ({ clientWidth }) => setWidth(clientWidth));
  const header = reading.transport === 'tcp' ? MBAP : 0;
  const picture = (wide: number) => (
    <Packet bytes={bytes} spans={reading.spans} header={header} width={wide} words={texts} />
  );
  return (
    <>
      <div class="packet" ref={place}>
        {width > 0 && picture(width)}
      </div>
      <p class="said">{header > 0 ? words.packet.note(bytes.length) : words.packet.pduNote}</p>
      <SaveBar name={`framewright-${reading.transport}`} picture={() => picture(SAVED_WIDTH)} />
      <Fold summary={words.packet.table}>{() => <FieldTable bytes={bytes} reading={reading} />}</Fold>
    </>
  );
}

/** The fields with their places and bytes. */
function FieldTable({ bytes, reading }: PacketProps) {
  const words = useWords('wire');
  const { labels } = useWords('page');
  const { columns } = words.packet;
  return (
    <table class="bit-table">
      <thead>
        <tr>
          {[columns.field, columns.offset, columns.size, columns.bytes].map((head) => (
            <th scope="col" key={head}>
              {head}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {reading.spans.map(({ name, kind, from, to }) => (
          <tr key={`${name} ${from}`} data-kind={kind} data-from={from} data-to={to}>
            <td>{labels[name] ?? name}</td>
            <td>{from}</td>
            <td>{words.bytes(to - from)}</td>
            <td class="mono">{formatBytes(bytes.subarray(from, to))}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
