import {
  type CatalogueCrc,
  CrcSteps,
  checkPrinted,
  crcCatalogue,
  sentBytes,
  wegExample,
} from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import { addressOf } from '../../../store/index.ts';
import { registerHex } from '../../../workbench/index.ts';
import { useWords } from '../../parts/words.ts';
import { Folded } from '../remembered-fold.tsx';

const modbus = crcCatalogue.find(({ name }) => name === 'CRC-16/MODBUS') as CatalogueCrc;

const hex = (value: number) => registerHex(modbus.width, value);
const sent = (value: number) => formatBytes(sentBytes(modbus, value) ?? new Uint8Array());

/** The worked example of the WEG guide beside the right steps. */
export function ExamplePanel() {
  const words = useWords('checksumSteps').example;
  return (
    <Folded name="checksum-printed-example" title={words.title} hint={words.hint}>
      {() => <Example />}
    </Folded>
  );
}

function Example() {
  const words = useWords('checksumSteps').example;
  const { columns, registers: heads } = words;
  const { bytes, mixed, registers, value } = wegExample;
  const steps = new CrcSteps(modbus, bytes);
  const printed = [
    ...registers.map((register, at) => ({
      what: words.afterByte(at),
      printed: hex(register),
      right: hex(steps.registers[at + 1] as number),
    })),
    { what: words.final, printed: hex(value), right: hex(steps.value) },
    { what: words.sent, printed: sent(value), right: sent(steps.value) },
  ];
  return (
    <>
      <p>{words.intro}</p>
      <p>
        <span class="mono">{formatBytes(bytes)}</span>{' '}
        <a href={addressOf('checksum', { bytes: formatBytes(bytes) })}>{words.open}</a>
      </p>
      <p>{words.start(hex(mixed))}</p>
      <table class="numbers printed">
        <thead>
          <tr>
            <th scope="col">{columns.line}</th>
            <th scope="col">{columns.printed}</th>
            <th scope="col">{columns.byRule}</th>
            <th scope="col">{columns.right}</th>
            <th scope="col">{columns.verdict}</th>
          </tr>
        </thead>
        <tbody>
          {checkPrinted(modbus, wegExample).map(({ printed: line, byRule, right, kind }, bit) => (
            <tr key={bit} data-severity={kind === 'wrong' ? 'error' : undefined}>
              <th scope="row">{words.line(bit)}</th>
              <td class="mono">{words.out(line.out, hex(line.after))}</td>
              <td class="mono">{hex(byRule.after)}</td>
              <td class="mono">{words.out(right.out, hex(right.after))}</td>
              <td class="verdict-of">{words.verdicts[kind]}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p class="said">{words.ruleHint}</p>
      <table class="numbers printed">
        <thead>
          <tr>
            <th scope="col">{heads.what}</th>
            <th scope="col">{heads.printed}</th>
            <th scope="col">{heads.right}</th>
          </tr>
        </thead>
        <tbody>
          {printed.map((each) => (
            <tr key={each.what} data-severity="error">
              <th scope="row">{each.what}</th>
              <td class="mono verdict-of">{each.printed}</td>
              <td class="mono">{each.right}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </>
  );
}
