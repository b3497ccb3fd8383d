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
import { Table } from '../../kit/table.tsx';
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
      <Table
        class="numbers printed"
        columns={[
          { name: columns.line, cell: (_, bit) => words.line(bit) },
          { name: columns.printed, class: 'mono', cell: ({ printed: line }) => words.out(line.out, hex(line.after)) },
          { name: columns.byRule, class: 'mono', cell: ({ byRule }) => hex(byRule.after) },
          { name: columns.right, class: 'mono', cell: ({ right }) => words.out(right.out, hex(right.after)) },
          { name: columns.verdict, class: 'verdict-of', cell: ({ kind }) => words.verdicts[kind] },
        ]}
        rows={checkPrinted(modbus, wegExample)}
        keyOf={(_, bit) => bit}
        attributes={({ kind }) => ({ 'data-severity': kind === 'wrong' ? 'error' : undefined })}
        narrow="cards"
      />
      <p class="said">{words.ruleHint}</p>
      <Table
        class="numbers printed"
        columns={[
          { name: heads.what, cell: ({ what }) => what },
          { name: heads.printed, class: 'mono verdict-of', cell: ({ printed: as }) => as },
          { name: heads.right, class: 'mono', cell: ({ right }) => right },
        ]}
        rows={printed}
        keyOf={({ what }) => what}
        attributes={() => ({ 'data-severity': 'error' })}
      />
    </>
  );
}
