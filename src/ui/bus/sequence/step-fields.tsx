import { byteOrders, type EntityTable, entityTables, isBitTable } from '../../../devices/index.ts';
import { dictionary, plainTypeNames } from '../../../modbus/index.ts';
import { type ListName, onFailures, type PlacedFault, relations, type StepTexts } from '../../../sequences/index.ts';
import { tidyFrame } from '../../../workbench/index.ts';
import { Select } from '../../kit/choice.tsx';
import { Field, saidId } from '../../kit/field.tsx';
import { useWords } from '../../parts/words.ts';

/** The fields that are chosen; all others are typed. */
const CHOICES: Readonly<Record<string, readonly string[]>> = dictionary({
  onFailure: onFailures,
  table: entityTables,
  type: plainTypeNames,
  order: byteOrders,
  relation: relations,
});

/** The fields that a table of bits does not have. */
const OF_REGISTERS: ReadonlySet<string> = new Set(['type', 'order', 'bit']);

interface FieldsProps {
  readonly step: StepTexts;
  readonly list: ListName;
  /** Of the step: the ids of its fields begin with it. */
  readonly id: string;
  readonly faults: readonly PlacedFault[];
  readonly onChange: (field: string, text: string) => void;
}

/** The fields of a step, each with its fault beside it. */
export function StepFields({ step, list, id, faults, onChange }: FieldsProps) {
  const words = useWords('sequence');
  const bitTable = step.kind === 'until' && isBitTable(step.fields['table'] as EntityTable);
  const isShown = (name: string) =>
    // Nothing that fails in the finally list ends it.
    !(bitTable && OF_REGISTERS.has(name)) && !(list === 'finally' && name === 'onFailure');
  const names = Object.keys(step.fields).filter(isShown);
  const ofStep = faults.filter((fault) => !('field' in fault));
  return (
    <>
      <div class="step-fields field-grid">
        {names.map((name) => (
          <StepField
            key={name}
            id={`${id}-${name}`}
            name={name}
            text={step.fields[name] ?? ''}
            fault={faults.find((fault) => 'field' in fault && fault.field === name)}
            onChange={onChange}
          />
        ))}
      </div>
      {ofStep.map((fault) => (
        <p key={fault.code} class="said error">
          {words.fault(fault)}
        </p>
      ))}
    </>
  );
}

interface StepFieldProps {
  readonly id: string;
  readonly name: string;
  readonly text: string;
  readonly fault: PlacedFault | undefined;
  readonly onChange: (field: string, text: string) => void;
}

function StepField({ id, name, text, fault, onChange }: StepFieldProps) {
  const words = useWords('sequence');
  const choices = CHOICES[name];
  const described = { id, 'aria-invalid': fault !== undefined, 'aria-describedby': saidId(id) };
  return (
    <Field id={id} name={name} label={words.fields[name] ?? name} error={fault && words.fault(fault)}>
      {choices ? (
        <Select
          id={id}
          wrong={fault !== undefined}
          value={text}
          options={[...(choices.includes(text) ? [] : [text]), ...choices].map((value) => ({
            value,
            name: words.options[name]?.[value] ?? value,
          }))}
          onChoose={(chosen) => onChange(name, chosen)}
        />
      ) : (
        <input
          {...described}
          class="mono"
          autocomplete="off"
          spellcheck={false}
          value={text}
          onInput={({ currentTarget }) => onChange(name, currentTarget.value)}
          onChange={({ currentTarget }) => name === 'bytes' && onChange(name, tidyFrame(currentTarget.value))}
        />
      )}
    </Field>
  );
}
