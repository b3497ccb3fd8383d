import { Component } from 'preact';
import {
  diagnosticSubFunctions,
  type Field,
  fieldValue,
  type Reading,
  type Section,
  type Table,
} from '../../modbus/index.ts';
import { entityNumber, formatHex, readBits, readNumber, readNumbers, zeroBasedAddress } from '../../notation/index.ts';
import type { InputError } from '../../workbench/index.ts';
import { type Control, type Draft, rangeOf, withForce, withoutGroup, withText } from '../../workbench/index.ts';
import { TextArea, TextInput } from '../kit/text-input.tsx';
import { ErrorLine, idOf, Labelled } from '../parts/labelled.tsx';
import { words } from '../parts/page-words.ts';
import { edit, evaluation, step } from '../parts/store.ts';
import { tools } from './loaded-tools.ts';
import { valueAid } from './values/value-aid.ts';

interface FieldProps {
  readonly control: Control;
  readonly draft: Draft;
  readonly errors: ReadonlyMap<string, InputError>;
  readonly reading: Reading | undefined;
}

const labelOf = (name: string) => words.labels[name] ?? name;

/** The control of a field, by the kind of value it holds. */
export function FieldControl(props: FieldProps) {
  const { control, draft, errors, reading } = props;
  const { field, path, text } = control;
  const error = errors.get(path);
  const onText = (typed: string) => edit(withText(draft, path, typed));
  const input = { id: idOf(path), text, wrong: error !== undefined, onText };
  const said = { path, label: labelOf(field.name), error, section: control.section, reading };
  switch (field.kind) {
    case 'groups':
      return <Groups {...props} />;
    case 'flag':
      return (
        <Labelled {...said}>
          <select
            id={idOf(path)}
            value={text === '0' ? '0' : '1'}
            onChange={({ currentTarget }) => step(withText(draft, path, currentTarget.value))}
          >
            <option value="1">{words.page.on}</option>
            <option value="0">{words.page.off}</option>
          </select>
        </Labelled>
      );
    case 'choice':
      return (
        <Labelled {...said} hint={numberHint(field, text, undefined)}>
          <Choice {...input} options={optionsOf(field)} onChoose={(chosen) => step(withText(draft, path, chosen))} />
        </Labelled>
      );
    case 'registers':
    case 'list':
    case 'bits': {
      const aid = valueAid.value?.(control, draft);
      return (
        <Labelled {...said} hint={aid?.said ?? listHint(field, text)} error={error && (aid?.wrong ?? error)}>
          <TextArea {...input} {...aid?.typed} />
          <Items control={control} draft={draft} />
        </Labelled>
      );
    }
    case 'bytes':
      return (
        <Labelled {...said} hint={words.page.octetsHint}>
          {field.open ? <TextArea {...input} /> : <TextInput {...input} />}
        </Labelled>
      );
    default: {
      const aid = field.kind === 'address' ? tools.value : undefined;
      const address = aid?.views.addressAid(path, text, said.label, draft, aid.words);
      const value = valueAid.value?.(control, draft);
      return (
        <>
          <Labelled
            {...said}
            hint={value?.said ?? address?.said ?? numberHint(field, text, evaluation.value.description.table)}
            error={error && (value?.wrong ?? error)}
          >
            <TextInput {...input} {...(address ?? value)?.typed} />
          </Labelled>
          {address?.help}
        </>
      );
    }
  }
}

/** The items of a list one by one, once the tools are there. */
function Items({ control, draft }: { control: Control; draft: Draft }) {
  const { field, path, text } = control;
  if (tools.value === undefined) return null;
  const { views, words: toolWords } = tools.value;
  const from = field.name === 'writeRegisters' ? 'writeStartAddress' : 'startAddress';
  const first =
    draft.kind === 'request' && path === field.name ? zeroBasedAddress(draft.texts[from] ?? '0') : undefined;
  return (
    <views.ListEditor
      text={text}
      bits={field.kind === 'bits'}
      first={first}
      words={toolWords}
      onText={(typed, done) => (done ? step : edit)(withText(draft, path, typed))}
    />
  );
}

/** A number in the notations that are not typed, and its legal range. */
function numberHint(field: Field, text: string, table: Table | undefined): string | undefined {
  const value = field.kind === 'address' ? zeroBasedAddress(text) : readNumber(text);
  const { least, most } = rangeOf(field);
  if (value === undefined || !Number.isInteger(value) || value < 0) return undefined;
  const number = field.kind === 'address' && table ? entityNumber(table, value) : undefined;
  const legal = field.range ? words.page.legal(least, most) : undefined;
  return [String(value), formatHex(value, 2 * field.width), number, legal]
    .filter((part) => part !== undefined)
    .join(', ');
}

function listHint(field: Field, text: string): string {
  const list = field.kind === 'bits' ? readBits(text) : readNumbers(text);
  const count = list.kind === 'list' ? `${words.page.itemCount(list.items.length)}. ` : '';
  return count + (field.kind === 'bits' ? words.page.bitsHint : words.page.listHint);
}

interface Option {
  readonly value: number;
  readonly name: string;
}

/** The values of a choice with their names: those the field allows, and those that have a name. */
function optionsOf(field: Field): readonly Option[] {
  if (field.name === 'subFunction') return diagnosticSubFunctions.map(({ code, name }) => ({ value: code, name }));
  const names = words.choices[field.name] ?? {};
  const values = field.allowed ?? Object.keys(names).map(Number);
  return values.map((value) => ({ value, name: names[value]?.name ?? '' }));
}

interface ChoiceProps {
  readonly id: string;
  readonly text: string;
  readonly wrong: boolean;
  readonly options: readonly Option[];
  readonly onText: (text: string) => void;
  readonly onChoose: (text: string) => void;
}

const OTHER = 'other';

/** A value of a few that have names, or any other as a number. */
class Choice extends Component<ChoiceProps, { other?: boolean }> {
  render() {
    const { options, onChoose, ...input } = this.props;
    const value = readNumber(input.text);
    const other = this.state.other === true || !options.some((option) => option.value === value);
    return (
      <>
        <select
          id={other ? undefined : input.id}
          aria-label={other ? words.page.other : undefined}
          value={other ? OTHER : String(value)}
          onChange={({ currentTarget }) => {
            this.setState({ other: currentTarget.value === OTHER });
            if (currentTarget.value !== OTHER) onChoose(currentTarget.value);
          }}
        >
          {options.map((option) => (
            <option key={option.value} value={String(option.value)}>
              {formatHex(option.value, 2).slice(2)} {option.name}
            </option>
          ))}
          <option value={OTHER}>{words.page.other}</option>
        </select>
        {other && <TextInput {...input} />}
      </>
    );
  }
}

/** A list of groups of fields: as many as wanted. */
function Groups({ control, draft, errors, reading }: FieldProps) {
  const { field, path, groups } = control;
  const span = reading?.spans.find(({ name }) => name === path);
  return (
    <fieldset class="groups" data-from={span?.from} data-to={span?.to}>
      <legend>{labelOf(field.name)}</legend>
      {groups.map((group, index) => (
        <fieldset key={index} class="group">
          <legend>{index + 1}</legend>
          {group.map((inner) => (
            <FieldControl key={inner.path} control={inner} draft={draft} errors={errors} reading={undefined} />
          ))}
          <button type="button" onClick={() => step(withoutGroup(draft, path, index, groups.length))}>
            {words.page.remove} {index + 1}
          </button>
        </fieldset>
      ))}
      <button type="button" onClick={() => step(withText(draft, path, String(groups.length + 1)))}>
        {words.page.add}
      </button>
    </fieldset>
  );
}

interface DerivedProps {
  readonly name: string;
  readonly draft: Draft;
  readonly error: InputError | undefined;
  readonly section: Section;
  readonly reading: Reading | undefined;
}

/** A value the encoder works out, shown, and one click away from being sent otherwise. */
export function DerivedField({ name, draft, error, section, reading }: DerivedProps) {
  const forced = draft.force[name];
  const value = reading === undefined ? undefined : fieldValue(reading, name);
  const label = labelOf(name);
  if (forced === undefined) {
    return (
      <p class="control derived-value" data-invalid={error === undefined ? undefined : ''}>
        <span>{label}</span> <b class="mono">{typeof value === 'number' ? `${value} ${formatHex(value, 2)}` : '–'}</b>
        <button
          type="button"
          aria-label={words.page.forceField(label)}
          onClick={() => step(withForce(draft, name, typeof value === 'number' ? String(value) : '0'))}
        >
          {words.page.force}
        </button>
        {error !== undefined && (
          <span class="error">
            <ErrorLine error={error} section={section} />
          </span>
        )}
      </p>
    );
  }
  return (
    <Labelled path={name} label={`${label} (${words.page.forced})`} error={error} section={section} reading={reading}>
      <TextInput
        id={idOf(name)}
        text={forced}
        wrong={error !== undefined}
        onText={(text) => edit(withForce(draft, name, text))}
      />
      <button
        type="button"
        aria-label={words.page.unforceField(label)}
        onClick={() => step(withForce(draft, name, undefined))}
      >
        {words.page.unforce}
      </button>
    </Labelled>
  );
}
