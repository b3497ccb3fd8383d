import type { ComponentChildren } from 'preact';
import { useMemo, useState } from 'preact/hooks';
import { type FoundRegister, type Profile, searchProfile } from '../../../devices/index.ts';
import {
  filtersOf,
  isIn,
  type RegisterFilter,
  type RegisterSort,
  registerSortKeys,
  sortedRegisters,
} from '../../../workbench/index.ts';
import { Select } from '../../kit/choice.tsx';
import { SearchBox } from '../../kit/search-box.tsx';
import { SortSelect } from '../../kit/table.tsx';
import { useWords } from '../words.ts';
import { RegisterTable, type ValueColumn } from './register-table.tsx';
import type { RegisterActs } from './register-uses.tsx';

interface FoundRegistersProps extends RegisterActs {
  readonly profile: Profile;
  readonly search: string;
  readonly onSearch: (search: string) => void;
  /** Adds a register; answers the place of its row, or nothing if it could not be added. */
  readonly onAdd: () => number | undefined;
  /** What is done with all registers that are shown. */
  readonly tools?: ((found: readonly FoundRegister[]) => ComponentChildren) | undefined;
  readonly value?: ValueColumn | undefined;
}

const ALL: RegisterFilter = { model: '', group: '' };

/** The registers of a device that the search finds, of the chosen model and group, in the order of any column. */
export function FoundRegisters({ profile, search, onSearch, onAdd, tools, value, ...acts }: FoundRegistersProps) {
  const words = useWords('devices');
  const [chosen, choose] = useState(ALL);
  const [sort, setSort] = useState<RegisterSort>();
  const [begin, setBegin] = useState<{ readonly key: string; readonly column: string }>();
  const named = useMemo(() => filtersOf(profile), [profile]);
  // A choice made for another device counts only where this one has it too.
  const valid = (by: keyof RegisterFilter) => (named[by].includes(chosen[by]) ? chosen[by] : '');
  const filter: RegisterFilter = { model: valid('model'), group: valid('group') };
  const found = useMemo(
    () =>
      sortedRegisters(
        profile,
        searchProfile(profile, search).filter(({ register }) => isIn(register, filter)),
        sort,
      ),
    [profile, search, filter.model, filter.group, sort],
  );
  const isNarrowed = search.trim() !== '' || filter.model !== '' || filter.group !== '';
  const add = () => {
    const at = onAdd();
    if (at === undefined) return;
    // Where it is narrowed or sorted, the new register might not be in sight.
    onSearch('');
    choose(ALL);
    setSort(undefined);
    setBegin({ key: String(at), column: 'name' });
  };
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset is for one question, and this is a table with what narrows it.
    <div class="device-registers" role="group" aria-label={words.table}>
      <SearchBox id="device-search" label={words.search} text={search} onText={onSearch}>
        <p class="said" aria-live="polite">
          {isNarrowed ? words.found(found.length) : words.searchHint}
        </p>
      </SearchBox>
      <div class="in-row">
        {(['model', 'group'] as const).map(
          (by) =>
            named[by].length > 0 && (
              <label key={by}>
                {words.filters[by]}{' '}
                <Select
                  value={filter[by]}
                  options={[
                    { value: '', name: words.filters.all },
                    ...named[by].map((each) => ({ value: each, name: each })),
                  ]}
                  onChoose={(each) => choose({ ...filter, [by]: each })}
                />
              </label>
            ),
        )}
        {found.length > 0 && (
          <SortSelect
            label={words.order}
            unsorted={words.unsorted}
            columns={registerSortKeys}
            names={words.columns}
            sort={sort}
            onSort={setSort}
          />
        )}
      </div>
      {tools?.(found)}
      <RegisterTable
        profile={profile}
        found={found}
        sort={sort}
        onSort={setSort}
        value={value}
        begin={begin}
        {...acts}
      />
      <p class="in-row">
        <button type="button" onClick={add}>
          {words.add}
        </button>
        {found.length > 0 && <span class="said">{words.editHint}</span>}
      </p>
    </div>
  );
}
