import { useState } from 'preact/hooks';
import { type CrcSteps, twoTables } from '../../../modbus/index.ts';
import { type TableLanguage, writeNumberTable } from '../../../notation/index.ts';
import { KeptChoice } from '../../../store/index.ts';
import { byteHex, oneOf, registerHex } from '../../../workbench/index.ts';
import { CopyButton } from '../../kit/copy-button.tsx';
import { Segments } from '../../kit/segments.tsx';
import { storage } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { Folded } from '../remembered-fold.tsx';

const languages = ['c', 'st'] as const;
const remembered = new KeptChoice<TableLanguage>(storage, 'checksum-table-language', 'c', oneOf(languages));

const kinds = ['whole', 'two'] as const;
type Kind = (typeof kinds)[number];

/** Entries in a row. */
const ACROSS = 8;

interface EntriesProps {
  readonly steps: CrcSteps;
  /** The index of the current byte, which is marked. */
  readonly index?: number;
}

/** The table of the algorithm, to look at and to copy into a program. */
export function EntriesPanel({ steps, index }: EntriesProps) {
  const words = useWords('checksumSteps').entries;
  return (
    <Folded name="checksum-table" title={words.title} hint={words.caption}>
      {() => (
        <>
          <Entries steps={steps} index={index} />
          <ForProgram steps={steps} />
        </>
      )}
    </Folded>
  );
}

function Entries({ steps: { form, table }, index }: { steps: CrcSteps; index: number | undefined }) {
  const { title } = useWords('checksumSteps').entries;
  const columns = Array.from({ length: ACROSS }, (_, column) => column);
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls sideways must be reached by the keyboard.
    <section class="step-entries" tabIndex={0} aria-label={title}>
      <table class="numbers">
        <thead>
          <tr>
            <td />
            {columns.map((column) => (
              <th key={column} scope="col">
                +{column}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {Array.from({ length: 256 / ACROSS }, (_, row) => row * ACROSS).map((from) => (
            <tr key={from}>
              <th scope="row">{byteHex(from)}</th>
              {columns.map((column) => (
                <td key={column} class="mono" aria-current={from + column === index || undefined}>
                  {registerHex(form.bits, table[from + column] as number)}
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

/** The table as constants of a program. */
function ForProgram({ steps }: { readonly steps: CrcSteps }) {
  const { entries: words, copied, copyFailed } = useWords('checksumSteps');
  const [kind, setKind] = useState<Kind>('whole');
  const two = twoTables(steps);
  const language = remembered.value;
  const text =
    two && kind === 'two'
      ? [
          writeNumberTable('auchCRCHi', two.first, 8, language),
          writeNumberTable('auchCRCLo', two.second, 8, language),
        ].join('\n\n')
      : writeNumberTable('crc_table', steps.table, steps.form.bits, language);
  return (
    <div class="for-program">
      <h3>{words.program}</h3>
      <div class="choices in-row">
        <Segments
          label={words.language}
          options={languages.map((value) => ({ value, name: words.languages[value] }))}
          value={language}
          onChoose={(chosen) => {
            remembered.value = chosen;
          }}
        />
        {two && (
          <Segments
            label={words.kind}
            options={kinds.map((value) => ({ value, name: words.kinds[value] }))}
            value={kind}
            onChoose={setKind}
          />
        )}
        <CopyButton label={words.copy} text={() => text} of={text} copied={copied} refused={() => copyFailed} />
      </div>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reached by the keyboard. */}
      <pre class="mono" tabIndex={0}>
        {text}
      </pre>
    </div>
  );
}
