import { parities } from '../../../modbus/index.ts';
import { readSpeed, USUAL_SPEEDS } from '../../../workbench/index.ts';
import { Choice } from '../../kit/choice.tsx';
import { NumberEntry } from '../../kit/number-entry.tsx';
import { busLink } from '../bus-link.ts';
import { line } from '../line.ts';
import { useWords } from '../words.ts';
import './line-menu.css';

const sizes = <T extends number>(...counts: readonly T[]) => counts.map((value) => ({ value, name: String(value) }));

/** The setting of the line, and that of the chosen device. */
export function LineMenu() {
  const words = useWords('header');
  const { baud, dataBits, parity, stopBits } = line.setting.value;
  const link = busLink.value;
  return (
    <>
      <p class="said">{words.lineIntro}</p>
      <OwnLine />
      <NumberEntry
        id="line-baud"
        label={words.baud}
        value={baud}
        read={readSpeed}
        wrong={words.baudWrong}
        usual={USUAL_SPEEDS.map(String)}
        onValue={(speed) => line.set({ baud: speed })}
      />
      <div class="line-format">
        <Choice
          id="line-data-bits"
          label={words.dataBits}
          value={dataBits}
          options={sizes(8, 7)}
          onChoose={(bits) => line.set({ dataBits: bits })}
        />
        <Choice
          id="line-parity"
          label={words.parity}
          value={parity}
          options={parities.map((value) => ({ value, name: words.parities[value] }))}
          onChoose={(kind) => line.set({ parity: kind })}
        />
        <Choice
          id="line-stop-bits"
          label={words.stopBits}
          value={stopBits}
          options={sizes(1, 2)}
          onChoose={(bits) => line.set({ stopBits: bits })}
        />
      </div>
      {link.kind === 'open' && <p class="said">{words.later(link.settings)}</p>}
    </>
  );
}

/** The line that the manual of the chosen device names. */
function OwnLine() {
  const words = useWords('header');
  const own = line.own.value;
  if (own === undefined) return null;
  return (
    <div class="own-line in-row">
      <span>{words.ownLine(own.name, own.serial)}</span>
      {line.isOwn.value ? (
        <span class="said">{words.isOwn}</span>
      ) : (
        <button type="button" onClick={line.useOwn}>
          {words.useOwn}
        </button>
      )}
    </div>
  );
}
