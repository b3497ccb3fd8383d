import type { ComponentType } from 'preact';
import { useState } from 'preact/hooks';
import { diagnosticSubFunctions, type Field } from '../../modbus/index.ts';
import { formatBytes, readBits, readNumber, readNumbers } from '../../notation/index.ts';
import type { Words, WordsOf } from '../../words/index.ts';
import { bytesOfBits, valuesByUse } from '../../workbench/index.ts';
import { Select } from '../kit/choice.tsx';
import { Popover } from '../kit/popover.tsx';
import { TextArea, TextInput } from '../kit/text-input.tsx';
import { idOf, Labelled } from '../parts/labelled.tsx';
import { part, Slot } from '../parts/slot.tsx';
import { fields } from '../parts/store.ts';
import { useWords } from '../parts/words.ts';
import { numberHint, useField } from './use-field.ts';
import { useTypedValues } from './use-typed-values.ts';
import { DoubtPlace, NamedPlace, TypedPlace } from './values/write-values.tsx';
import './groups.css';

interface PathProps {
  readonly path: string;
}

interface FieldProps extends PathProps {
  readonly field: Field;
}

export interface OtherProps extends PathProps {
  /** The control of a field in a group. */
  readonly inner: ComponentType<PathProps>;
}

/** The control of a field that holds anything but an address or a number. */
export function OtherField({ path, inner }: OtherProps) {
  const field = fields.at(path).field.value;
  switch (field?.kind) {
    case 'groups':
      return <Groups path={path} inner={inner} />;
    case 'flag':
      return <FlagField path={path} />;
    case 'choice':
      return <ChoiceField path={path} field={field} />;
    case 'bits':
      return <BitsField path={path} />;
    case 'registers':
    case 'list':
      return <ListField path={path} />;
    case 'bytes':
      return <OctetsField path={path} field={field} />;
    default:
      return null;
  }
}

function FlagField({ path }: PathProps) {
  const { page: words } = useWords('page');
  const { labelled, text } = useField(path);
  return (
    <Labelled {...labelled}>
      <Select
        id={idOf(path)}
        value={text === '0' ? '0' : '1'}
        options={[
          { value: '1', name: words.on },
          { value: '0', name: words.off },
        ]}
        onChoose={(chosen) => fields.choose(path, chosen)}
      />
    </Labelled>
  );
}

function OctetsField({ path, field }: FieldProps) {
  const words = useWords('oneByOne');
  const { labelled, input } = useField(path);
  return (
    <Labelled {...labelled} hint={words.octetsHint}>
      {field.open ? <TextArea {...input} /> : <TextInput {...input} />}
    </Labelled>
  );
}

const listItems = part(
  ['oneByOne'],
  () => import('./tools/list-items.tsx'),
  ({ ListItems }) => ListItems,
);

function ListField({ path }: PathProps) {
  const words = useWords('oneByOne');
  const { items } = words;
  const { labelled, input, text } = useField(path);
  const values = useTypedValues(path, input.wrong);
  return (
    <>
      <Labelled
        {...labelled}
        hint={values.hint ?? listHint(text, words)}
        error={labelled.error && (values.wrong ?? labelled.error)}
        beside={
          <>
            <DoubtPlace path={path} values={values} />
            <Popover summary={items} class="list-editor">
              {() => <Slot part={listItems} with={{ path }} />}
            </Popover>
            {values.takes && <TypedPlace path={path} />}
          </>
        }
      >
        <TextArea {...input} {...values.input} line={20} least={1} />
      </Labelled>
      {values.takes && <NamedPlace path={path} />}
    </>
  );
}

const coils = part(
  ['oneByOne'],
  () => import('./tools/coils.tsx'),
  ({ Coils }) => Coils,
);

/** Coils and other bits: typed as digits, and below them one by one and as bytes. */
function BitsField({ path }: PathProps) {
  const words = useWords('oneByOne');
  const { labelled, input, text } = useField(path);
  return (
    <>
      <Labelled {...labelled} hint={bitsHint(text, words)}>
        <TextArea {...input} line={30} least={1} />
      </Labelled>
      <Slot part={coils} with={{ path }} />
    </>
  );
}

function listHint(text: string, words: WordsOf<'oneByOne'>): string {
  const list = readNumbers(text);
  return list.kind === 'list' && list.items.length > 0 ? words.listIs(list.items.length) : words.listHint;
}

/** How many bits there are, and the bytes that they become. */
function bitsHint(text: string, words: WordsOf<'oneByOne'>): string {
  const list = readBits(text);
  return list.kind === 'list' ? words.bitsAre(list.items.length, formatBytes(bytesOfBits(list.items))) : words.bitsHint;
}

const OTHER = 'other';

/** A value of a few that have names, or any other as a number. */
function ChoiceField({ path, field }: FieldProps) {
  const words = useWords('page');
  const { labelled, input, text } = useField(path);
  const [chosen, setChosen] = useState('');
  const options = optionsOf(field, words);
  const value = readNumber(text);
  const other = chosen === OTHER || !options.some((option) => option.value === String(value));
  return (
    <Labelled {...labelled} hint={numberHint(field, text, words)}>
      <Select
        {...(other ? { label: words.page.other } : { id: input.id })}
        value={other ? OTHER : String(value)}
        options={[...options, { value: OTHER, name: words.page.other }]}
        onChoose={(next) => {
          setChosen(next);
          if (next !== OTHER) fields.choose(path, next);
        }}
      />
      {other && <TextInput {...input} />}
    </Labelled>
  );
}

/** The values of a choice with their names: those the field allows, and those that have a name. */
function optionsOf(field: Field, words: Words) {
  const option = (code: number, name = '') => ({
    value: String(code),
    name: `${words.page.codeIn(code)} ${name}`,
  });
  if (field.name === 'subFunction') return diagnosticSubFunctions.map(({ code, name }) => option(code, name));
  const names = words.choices[field.name] ?? {};
  const values = valuesByUse(field.name, field.allowed ?? Object.keys(names).map(Number));
  return values.map((value) => option(value, names[value]?.name));
}

/** A list of groups of fields: as many as wanted. */
function Groups({ path, inner: Inner }: OtherProps) {
  const { page: words } = useWords('page');
  const { label, span } = useField(path).labelled;
  const groups = fields.at(path).groups.value;
  return (
    <fieldset class="groups" data-from={span?.from} data-to={span?.to}>
      <legend>{label}</legend>
      {groups.map((group, index) => (
        <fieldset key={index} class="group">
          <legend>{index + 1}</legend>
          {group.map((each) => (
            <Inner key={each} path={each} />
          ))}
          <button type="button" onClick={() => fields.removeGroup(path, index)}>
            {words.remove} {index + 1}
          </button>
        </fieldset>
      ))}
      <button type="button" onClick={() => fields.choose(path, String(groups.length + 1))}>
        {words.add}
      </button>
    </fieldset>
  );
}
