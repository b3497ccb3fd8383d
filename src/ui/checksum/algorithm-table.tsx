import { polynomialForms } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import type { ChecksumView } from '../../store/index.ts';
import { type AlgorithmRow, registerHex, type SortKey, sortKeys, valueBytes } from '../../workbench/index.ts';
import type { ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import { CopiedValue } from './copied-value.tsx';

const ID = 'checksum-search';
const COLUMNS = Object.keys(sortKeys) as readonly SortKey[];

/** Every algorithm over the input, found as one types, in the order of any column. */
export function AlgorithmTable({ view }: ViewProps<ChecksumView>) {
  const words = useWords('checksum');
  const search = view.search.value;
  const found = view.found.value;
  const chosen = view.chosen.value.name;
  const computing = view.computing.value;
  return (
    <section class="panel algorithms" aria-labelledby={`${ID}-title`}>
      <div class="algorithms-head">
        <h2 id={`${ID}-title`}>{words.all}</h2>
        <search>
          <label for={ID}>{words.search}</label>
          <input
            id={ID}
            type="search"
            value={search}
            placeholder={words.searchHint}
            autocomplete="off"
            spellcheck={false}
            autocapitalize="off"
            onInput={({ currentTarget }) => view.change({ search: currentTarget.value })}
          />
          <output for={ID}>{words.shown(found.length, view.rows.value.length)}</output>
        </search>
      </div>
      {found.length === 0 ? (
        <p>
          {words.nothing(search.trim())}{' '}
          <button
            type="button"
            onClick={() => {
              view.change({ search: '' });
              document.getElementById(ID)?.focus();
            }}
          >
            {words.clearSearch}
          </button>
        </p>
      ) : (
        <table aria-labelledby={`${ID}-title`} aria-busy={computing}>
          <thead>
            <tr>
              {COLUMNS.map((column) => (
                <Head key={column} view={view} column={column} />
              ))}
            </tr>
          </thead>
          <tbody>
            {found.map((row) => (
              <Line key={row.key} row={row} chosen={row.key === chosen} computing={computing} onChoose={view.choose} />
            ))}
          </tbody>
        </table>
      )}
    </section>
  );
}

interface HeadProps extends ViewProps<ChecksumView> {
  readonly column: SortKey;
}

/** Sorts by its column; pressed again, the other way round; pressed a third time, in the order of the catalogue. */
function Head({ view, column }: HeadProps) {
  const words = useWords('checksum');
  const sort = view.sort.value;
  const by = sort?.by === column ? sort : undefined;
  const next = by === undefined ? { by: column, down: false } : by.down ? undefined : { by: column, down: true };
  return (
    <th scope="col" aria-sort={by && (by.down ? 'descending' : 'ascending')}>
      <button type="button" onClick={() => view.change({ sort: next })}>
        {words.columns[column]}
        <span aria-hidden="true">{by && (by.down ? ' ▾' : ' ▴')}</span>
      </button>
    </th>
  );
}

interface LineProps {
  readonly row: AlgorithmRow;
  readonly chosen: boolean;
  readonly computing: boolean;
  readonly onChoose: (key: string) => void;
}

function Line({ row, chosen, computing, onChoose }: LineProps) {
  const words = useWords('checksum');
  const { checksum, name, value } = row;
  const { width, aliases, crc, check } = checksum;
  const hex = (number: number) => registerHex(width, number);
  const forms = crc && polynomialForms(crc);
  return (
    <tr data-chosen={chosen ? '' : undefined}>
      <th scope="row">
        <label>
          <input type="radio" name="algorithm" checked={chosen} onChange={() => onChoose(row.key)} /> {name}
        </label>
        {aliases.length > 0 && <small>{aliases.join(', ')}</small>}
      </th>
      <td data-column={words.columns.value}>
        {value === undefined ? (
          <span class="said">{computing ? words.computing : words.chooseIt}</span>
        ) : (
          <>
            <CopiedValue text={hex(value)} of={name} />
            {width > 8 && (
              <small class="mono" title={words.bothOrders}>
                {formatBytes(valueBytes(value, width))} · {formatBytes(valueBytes(value, width).toReversed())}
              </small>
            )}
          </>
        )}
      </td>
      <td data-column={words.columns.width}>{width}</td>
      <td data-column={words.columns.poly} class="mono">
        {forms ? hex(forms.normal) : words.noCrc}
      </td>
      <td data-column={words.columns.reversed} class="mono">
        {forms && hex(forms.reversed)}
      </td>
      <td data-column={words.columns.koopman} class="mono">
        {forms && hex(forms.koopman)}
      </td>
      <td data-column={words.columns.init} class="mono">
        {crc && hex(crc.init)}
      </td>
      <td data-column={words.columns.reflected}>{crc && words.reflections(crc.refin, crc.refout)}</td>
      <td data-column={words.columns.xorout} class="mono">
        {crc && hex(crc.xorout)}
      </td>
      <td data-column={words.columns.check} class="mono">
        {hex(check)}
      </td>
      <td data-column={words.columns.residue} class="mono">
        {crc && hex(crc.residue)}
      </td>
    </tr>
  );
}
