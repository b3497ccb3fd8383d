import { characterBits, type LineCharacter, toHex } from '../../../../modbus/index.ts';
import { bitsText, character as printed, type Scene, sceneTime } from '../../../../workbench/index.ts';
import { useWords } from '../../words.ts';

interface TableProps {
  readonly scene: Scene;
  readonly onShow: (index: number) => void;
}

/** The current frame in bits: what the picture shows, for reading, hearing and copying. */
export function BitTable({ scene, onShow }: TableProps) {
  const words = useWords('wire');
  const { line, own, serial } = scene;
  const { columns, parts } = words;
  const kinds = [parts.start, parts.data, ...(serial.parity === 'none' ? [] : [parts.parity]), parts.stop];
  return (
    <>
      <p class="said">{words.tableHint(kinds.join(' | '))}</p>
      <table class="bit-table">
        <thead>
          <tr>
            <th scope="col">{columns.byte}</th>
            <th scope="col">{columns.hex}</th>
            <th scope="col" class="wide">
              {columns.field}
            </th>
            <th scope="col">{columns.bits}</th>
            <th scope="col">{columns.start}</th>
          </tr>
        </thead>
        <tbody>
          {line.characters
            .filter(({ frame }) => frame === own)
            .map((character) => (
              <Row key={character.index} scene={scene} character={character} onShow={onShow} />
            ))}
        </tbody>
      </table>
    </>
  );
}

function Row({ scene, character, onShow }: TableProps & { readonly character: LineCharacter }) {
  const words = useWords('wire');
  const { labels } = useWords('page');
  const { own, sent, serial, fields } = scene;
  const { index, value, start } = character;
  const span = fields[own]?.[index];
  const pair = toHex(Uint8Array.of(value));
  const text = sent[own]?.reading.transport === 'ascii' ? `${printed(value)} ${pair}` : pair;
  return (
    <tr data-kind={span?.kind} data-from={index} data-to={index + 1}>
      <td>{index}</td>
      <td>
        <button type="button" class="mono" aria-label={words.show(text, index)} onClick={() => onShow(index)}>
          {text}
        </button>
      </td>
      <td class="wide">{span && (labels[span.name] ?? span.name)}</td>
      <td class="mono">{bitsText(characterBits(value, serial))}</td>
      <td class="mono">{words.time(sceneTime(scene, start))}</td>
    </tr>
  );
}
