import { type Profile, placeOfRegister, searchProfile } from '../../devices/index.ts';
import { foundName, foundNumber } from '../../workbench/index.ts';
import { SearchBox } from '../kit/search-box.tsx';
import { allDevices } from '../parts/device/chosen.ts';
import { page } from '../parts/store.ts';
import { useWords } from '../parts/words.ts';

/** Most registers that are listed of one device; the map of the device has the others. */
const LISTED = 5;

interface LibraryProps {
  readonly search: string;
  readonly onSearch: (search: string) => void;
}

/** Every device, and where a search finds registers in them: by name, by printed number, by address. */
export function Library({ search, onSearch }: LibraryProps) {
  const words = useWords('library');
  const searched = search.trim() !== '';
  const found = allDevices.all.value
    .map((profile) => ({ profile, registers: searched ? searchProfile(profile, search) : [] }))
    .filter(({ profile, registers }) => !searched || registers.length > 0 || isNamed(profile, search));
  const count = found.reduce((sum, { registers }) => sum + registers.length, 0);
  const chosen = allDevices.chosen.value;
  const kindOf = (profile: Profile) =>
    allDevices.isOwn(profile) ? words.own : profile === allDevices.linked.value ? words.inLink : words.builtIn;
  return (
    <section class="panel" aria-labelledby="library">
      <h2 id="library">{words.profiles}</h2>
      <SearchBox
        id="library-search"
        label={words.search}
        text={search}
        hint={words.searchHint}
        found={searched ? words.found(count, found.length) : undefined}
        onText={onSearch}
        onLeave={() => page.address.now()}
      />
      <ul class="library">
        {found.map(({ profile, registers }) => (
          <li key={profile.id}>
            <button type="button" aria-pressed={profile === chosen} onClick={() => allDevices.choose(profile.id)}>
              {profile.name}
              <small>
                {words.count(profile.registers.length)}, {kindOf(profile)}
              </small>
            </button>
            {registers.length > 0 && (
              <ul class="found">
                {registers.slice(0, LISTED).map((each) => (
                  <li key={`${placeOfRegister(each.register)} ${each.index}`}>
                    {foundName(each)} <span class="mono soft">{foundNumber(profile, each)[0]}</span>
                  </li>
                ))}
                {registers.length > LISTED && <li class="soft">… {words.count(registers.length - LISTED)}</li>}
              </ul>
            )}
          </li>
        ))}
      </ul>
    </section>
  );
}

const isNamed = ({ name }: Profile, search: string) => name.toLowerCase().includes(search.trim().toLowerCase());
