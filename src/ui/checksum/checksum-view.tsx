import type { VNode } from 'preact';
import { type CatalogueCrc, crc, crc16, crcCatalogue, lrc } from '../../modbus/index.ts';
import { formatBytes, formatHex } from '../../notation/index.ts';
import { AddressedView } from '../addressed-view.ts';
import { evaluation } from '../state.ts';
import './checksum.css';
import { atHand } from './frame-at-hand.ts';
import { InputPanel } from './input-panel.tsx';
import { loadWords, checksumWords as words } from './language.ts';
import { type InputKind, inputKinds, readInput } from './read-input.ts';
import { StepsPlace } from './steps-place.tsx';

interface ChecksumState {
  /** What was typed; the frame at hand where the address has nothing. */
  readonly text: string;
  readonly kind: InputKind;
  /** The name of the algorithm. */
  readonly algorithm: string;
}

const DEFAULT = 'CRC-16/MODBUS';

/** The view with its words. */
export async function load(): Promise<() => VNode> {
  await loadWords();
  return () => <ChecksumView />;
}

/** Any bytes, and every checksum over them. */
class ChecksumView extends AddressedView<object, ChecksumState> {
  protected readonly name = 'checksum';
  protected readonly title = words.title;

  protected read(query: URLSearchParams): ChecksumState {
    const frame = atHand(evaluation.value);
    return {
      text: query.get('bytes') ?? (frame ? formatBytes(frame.body) : ''),
      kind: inputKinds.find((kind) => kind === query.get('as')) ?? 'bytes',
      algorithm: query.get('algorithm') ?? DEFAULT,
    };
  }

  protected write({ text, kind, algorithm }: ChecksumState) {
    return {
      bytes: text,
      as: kind === 'bytes' ? '' : kind,
      algorithm: algorithm === DEFAULT ? '' : algorithm,
    };
  }

  render() {
    const { text, kind } = this.state;
    const reading = readInput(text, kind);
    const { bytes } = reading;
    const algorithm = (crcCatalogue.find(({ name }) => name === this.state.algorithm) ??
      crcCatalogue.find(({ name }) => name === DEFAULT)) as CatalogueCrc;
    const modbus = crc16(bytes);
    return (
      <main class="checksum-view">
        <InputPanel
          text={text}
          kind={kind}
          reading={reading}
          onText={(typed) => this.change({ text: typed })}
          onKind={(chosen) => this.change({ kind: chosen })}
          onLeave={this.follow}
        />
        <section class="panel">
          <h2>{words.result}</h2>
          <p>
            CRC-16/MODBUS {formatHex(modbus, 4)} {words.wire} {formatBytes(Uint8Array.of(modbus & 0xff, modbus >>> 8))}
          </p>
          <p>LRC {formatHex(lrc(bytes), 2)}</p>
          <p>
            {algorithm.name} {formatHex(crc(algorithm, bytes), algorithm.width / 4)}
          </p>
        </section>
        <StepsPlace bytes={bytes} algorithm={algorithm} />
      </main>
    );
  }
}
