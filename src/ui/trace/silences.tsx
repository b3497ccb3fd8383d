import { bitsPerCharacter } from '../../modbus/index.ts';
import { line } from '../parts/line.ts';
import { useWords } from '../parts/words.ts';
import { log } from './log.ts';

/** Whether silences are judged by the line that the header shows, which nobody but who looks knows to be that of the log. */
export function Silences() {
  const words = useWords('trace');
  const { views } = useWords('page');
  log.revision.value;
  const first = log.row(0);
  if (first?.time === undefined || first.transport === 'tcp') return null;
  const setting = line.setting.value;
  const { value: judged } = log.line;
  const own = { baud: setting.baud, bits: bitsPerCharacter(setting) };
  return (
    <label>
      <input
        type="checkbox"
        checked={judged !== undefined && judged.baud === own.baud && judged.bits === own.bits}
        onChange={({ currentTarget }) => log.setLine(currentTarget.checked ? own : undefined)}
      />{' '}
      {words.silences(views.lineName(setting))}
    </label>
  );
}
