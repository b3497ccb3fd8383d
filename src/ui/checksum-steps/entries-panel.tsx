import { Component } from 'preact';
import { type CrcSteps, twoTables } from '../../modbus/index.ts';
import { type TableLanguage, writeNumberTable } from '../../notation/index.ts';
import { Folded } from '../checksum/folded.tsx';
import { Segments } from '../frame/segments.tsx';
import { Remembered } from '../tools/remembered.ts';
import { stepWords } from './language.ts';
import { byteHex, registerHex } from './registers.tsx';

const languages = ['c', 'st'] as const;
const remembered = new Remembered<TableLanguage>('checksum-table-language', 'c', (value) =>
  languages.find((each) => each === value),
);

const kinds = ['whole', 'two'] as const;
type Kind = (typeof kinds)[number];

/** Entries in a row. */
const ACROSS = 8;

/** The table of the algorithm, to look at and to copy into a program. */
export function EntriesPanel({ steps }: { steps: CrcSteps }) {
  const words = stepWords.entries;
  return (
    <Folded name="checksum-table" title={words.title} hint={words.caption}>
      {() => (
        <>
          <Entries steps={steps} />
          <ForProgram steps={steps} />
        </>
      )}
    </Folded>
  );
}

function Entries({ steps: { form, table } }: { steps: CrcSteps }) {
  const columns = Array.from({ length: ACROSS }, (_, column) => column);
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls sideways must be reached by the keyboard.
    <section class="step-entries" tabIndex={0} aria-label={stepWords.entries.title}>
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
                <td key={column} class="mono">
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

interface ProgramState {
  readonly kind: Kind;
  /** What was copied, and what was said of it. */
  readonly said?: { readonly of: string; readonly text: string };
}

/** The table as constants of a program. */
class ForProgram extends Component<{ readonly steps: CrcSteps }, ProgramState> {
  override state: ProgramState = { kind: 'whole' };

  private readonly copy = async (of: string) => {
    const words = stepWords.entries;
    const copied = navigator.clipboard?.writeText(of) ?? Promise.reject(new Error('no clipboard'));
    const text = await copied.then(
      () => words.copied,
      () => words.copyFailed,
    );
    this.setState({ said: { of, text } });
  };

  render() {
    const words = stepWords.entries;
    const { steps } = this.props;
    const two = twoTables(steps);
    const kind = two ? this.state.kind : 'whole';
    const language = remembered.value;
    const text =
      two && kind === 'two'
        ? [
            writeNumberTable('auchCRCHi', two.first, 8, language),
            writeNumberTable('auchCRCLo', two.second, 8, language),
          ].join('\n\n')
        : writeNumberTable('crc_table', steps.table, steps.form.bits, language);
    const { said } = this.state;
    return (
      <div class="for-program">
        <h3>{words.program}</h3>
        <div class="choices">
          <Segments
            label={words.language}
            options={languages.map((value) => ({ value, name: words.languages[value] }))}
            value={language}
            onChoose={(chosen) => {
              remembered.value = chosen;
              this.forceUpdate();
            }}
          />
          {two && (
            <Segments
              label={words.kind}
              options={kinds.map((value) => ({ value, name: words.kinds[value] }))}
              value={kind}
              onChoose={(chosen) => this.setState({ kind: chosen })}
            />
          )}
          <button type="button" class="first" onClick={() => void this.copy(text)}>
            {words.copy}
          </button>
          <output>{said?.of === text ? said.text : ''}</output>
        </div>
        {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reached by the keyboard. */}
        <pre class="mono" tabIndex={0}>
          {text}
        </pre>
      </div>
    );
  }
}
