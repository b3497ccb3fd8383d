import { type ReceivedCharacter, type SerialLine, serialFormatName, toHex } from '../../../../modbus/index.ts';
import { formatBinary } from '../../../../notation/index.ts';
import {
  bytesDuring,
  type ReceiverKind,
  readSpeed,
  receiverKinds,
  receptionOf,
  type Scene,
  sceneTime,
} from '../../../../workbench/index.ts';
import { Choice } from '../../../kit/choice.tsx';
import { NumberEntry } from '../../../kit/number-entry.tsx';
import { useWords } from '../../words.ts';
import { FormatChoice } from './format-choice.tsx';

interface ReceiverProps {
  readonly kind: ReceiverKind;
  readonly own: SerialLine;
  readonly onKind: (kind: ReceiverKind) => void;
  readonly onOwn: (own: SerialLine) => void;
}

/** How a receiver is set that listens to the line. */
export function ReceiverChoice({ kind, own, onKind, onOwn }: ReceiverProps) {
  const words = useWords('wire');
  return (
    <div class="wire-settings receiver field-grid">
      <Choice
        id="wire-receiver"
        label={words.receiver}
        value={kind}
        options={receiverKinds.map((value) => ({ value, name: words.receivers[value] }))}
        onChoose={onKind}
      />
      {kind === 'own' && (
        <>
          <NumberEntry
            id="wire-receiver-speed"
            label={words.receiverSpeed}
            value={String(own.baud)}
            read={readSpeed}
            wrong={words.notASpeed}
            onValue={(baud) => onOwn({ ...own, baud })}
          />
          <FormatChoice
            id="wire-receiver-format"
            label={words.receiverFormat}
            value={own}
            onChoose={(format) => onOwn({ ...own, ...format })}
          />
        </>
      )}
    </div>
  );
}

interface ReceivedProps {
  readonly scene: Scene;
  readonly kind: ReceiverKind;
  readonly receiver: SerialLine;
  readonly received: readonly ReceivedCharacter[];
}

/** What a receiver reads, in a sentence and byte by byte. */
export function ReceivedBytes({ scene, kind, receiver, received }: ReceivedProps) {
  const words = useWords('wire');
  const sent = scene.sent[scene.own]?.bytes ?? new Uint8Array();
  const columns = words.receivedColumns;
  return (
    <>
      <p aria-live="polite">
        {words.receiverIs(receiver.baud, serialFormatName(receiver))}{' '}
        <strong>{words.reception(receptionOf(sent, received))}</strong>
      </p>
      <p class="said">
        {words.receiverHow} {kind === 'half' && words.halfSpeed}
      </p>
      {received.length > 0 && (
        <details>
          <summary>{words.received}</summary>
          <table class="bit-table">
            <thead>
              <tr>
                {[columns.byte, columns.hex, columns.bits, columns.error, columns.from].map((head) => (
                  <th scope="col" key={head}>
                    {head}
                  </th>
                ))}
                <th scope="col" class="wide">
                  {columns.start}
                </th>
              </tr>
            </thead>
            <tbody>
              {received.map((each, index) => (
                <ReceivedRow key={each.start} scene={scene} receiver={receiver} each={each} index={index} />
              ))}
            </tbody>
          </table>
        </details>
      )}
    </>
  );
}

interface RowProps {
  readonly scene: Scene;
  readonly receiver: SerialLine;
  readonly each: ReceivedCharacter;
  readonly index: number;
}

function ReceivedRow({ scene, receiver, each: { value, errors, start, end }, index }: RowProps) {
  const words = useWords('wire');
  const bytes = bytesDuring(scene, start, end);
  return (
    <tr data-from={bytes?.[0]} data-to={bytes?.[1]}>
      <td>{index}</td>
      <td class="mono">{toHex(Uint8Array.of(value))}</td>
      <td class="mono">{formatBinary(value, receiver.dataBits)}</td>
      <td class={errors.length > 0 ? 'error' : undefined}>
        {errors.length > 0 ? errors.map((error) => words.errors[error]).join(', ') : words.fine}
      </td>
      <td>{bytes?.[0]}</td>
      <td class="mono wide">{words.time(sceneTime(scene, start))}</td>
    </tr>
  );
}
