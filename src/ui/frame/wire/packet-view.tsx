import { Component } from 'preact';
import { MBAP, type Reading } from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import { words as pageWords } from '../../parts/page-words.ts';
import { Packet } from './picture/packet.tsx';
import { SaveBar } from './save.tsx';
import { wireWords as words } from './wire-words.ts';

interface PacketProps {
  readonly bytes: Uint8Array;
  readonly reading: Reading;
}

/** Pixels that a saved picture is wide. */
const SAVED_WIDTH = 900;

/** The segment that carries a frame over TCP, or a bare PDU, as a layout of its bytes. */
export class PacketView extends Component<PacketProps, { width: number }> {
  override state = { width: 0 };
  private place: HTMLElement | null = null;
  private readonly resize = new ResizeObserver(() => this.setState({ width: this.place?.clientWidth ?? 0 }));

  override componentDidMount() {
    if (this.place) this.resize.observe(this.place);
  }

  override componentWillUnmount() {
    this.resize.disconnect();
  }

  render() {
    const { bytes, reading } = this.props;
    const { width } = this.state;
    const header = reading.transport === 'tcp' ? MBAP : 0;
    const { columns } = words.packet;
    return (
      <>
        <div
          class="packet"
          ref={(place) => {
            this.place = place;
          }}
        >
          {width > 0 && <Packet bytes={bytes} spans={reading.spans} header={header} width={width} />}
        </div>
        <p class="said">{header > 0 ? words.packet.note(bytes.length) : words.packet.pduNote}</p>
        <SaveBar
          name={`framewright-${reading.transport}`}
          picture={() => <Packet bytes={bytes} spans={reading.spans} header={header} width={SAVED_WIDTH} />}
        />
        <details>
          <summary>{words.packet.table}</summary>
          <table class="bit-table">
            <thead>
              <tr>
                <th scope="col">{columns.field}</th>
                <th scope="col">{columns.offset}</th>
                <th scope="col">{columns.size}</th>
                <th scope="col">{columns.bytes}</th>
              </tr>
            </thead>
            <tbody>
              {reading.spans.map(({ name, kind, from, to }) => (
                <tr key={`${name} ${from}`} data-kind={kind} data-from={from} data-to={to}>
                  <td>{pageWords.labels[name] ?? name}</td>
                  <td>{from}</td>
                  <td>{words.bytes(to - from)}</td>
                  <td class="mono">{formatBytes(bytes.subarray(from, to))}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </details>
      </>
    );
  }
}
