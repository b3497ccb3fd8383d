import { useState } from 'preact/hooks';
import { type Profile, searchProfile } from '../../../devices/index.ts';
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
import { type RegisterActs, RegisterTable } from './register-table.tsx';

interface FoundRegistersProps extends RegisterActs {
  readonly profile: Profile;
  readonly search: string;
  readonly onSearch: (search: string) => void;
}

/** The registers of a device that the search finds, of the chosen model and group, in the order of any column. */
export function FoundRegisters({ profile, search, onSearch, ...acts }: FoundRegistersProps) {
  const words = useWords('devices');
  const [chosen, choose] = useState<RegisterFilter>({ model: '', group: '' });
  const [sort, setSort] = useState<RegisterSort>();
  const named = filtersOf(profile);
  // A choice made for another device counts only where this one has it too.
  const valid = (by: keyof RegisterFilter) => (named[by].includes(chosen[by]) ? chosen[by] : '');
  const filter: RegisterFilter = { model: valid('model'), group: valid('group') };
  const found = searchProfile(profile, search).filter(({ register }) => isIn(register, filter));
  const isNarrowed = search.trim() !== '' || filter.model !== '' || filter.group !== '';
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
                    ...named[by].map((value) => ({ value, name: value })),
                  ]}
                  onChoose={(value) => choose({ ...filter, [by]: value })}
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
      <RegisterTable
        profile={profile}
        found={sortedRegisters(profile, found, sort)}
        sort={sort}
        onSort={setSort}
        {...acts}
      />
    </div>
  );
}
