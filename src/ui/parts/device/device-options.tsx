import { useEffect, useId, useRef, useState } from 'preact/hooks';
import { builtInProfiles, type Profile } from '../../../devices/index.ts';
import { SearchBox } from '../../kit/search-box.tsx';
import { page } from '../store.ts';
import { useWords } from '../words.ts';
import { allDevices, ChosenDevice, onceCame } from './chosen.ts';
import './device-options.css';

interface DeviceOptionsProps {
  /** Is called when a device, or none, is chosen. */
  readonly onChosen: () => void;
}

/** The devices that have all the words of a search in their name or their source. */
function found(profiles: readonly Profile[], search: string): readonly Profile[] {
  const words = search.toLowerCase().split(/\s+/);
  return profiles.filter(({ name, source }) => {
    const said = `${name} ${source}`.toLowerCase();
    return words.every((word) => said.includes(word));
  });
}

const linked = (): readonly Profile[] => (allDevices.linked.value ? [allDevices.linked.value] : []);

/** Arrow keys go from the search to what was found, and through it. */
function goOn(event: KeyboardEvent): void {
  const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (by === undefined || !(event.currentTarget instanceof Element)) return;
  event.preventDefault();
  const stops = [...event.currentTarget.querySelectorAll<HTMLElement>('input, button')];
  const at = stops.findIndex((stop) => stop.matches(':focus'));
  stops[Math.max(0, Math.min(stops.length - 1, at + by))]?.focus();
}

/** Every device, each a button that chooses it: none, those of a person, that of the link, the built-in ones. Enter in the search takes the first. */
export const DeviceOptions = onceCame(Options);

function Options({ onChosen }: DeviceOptionsProps) {
  const { none, builtIn, own, inLink, tooLarge } = useWords('devices');
  const words = useWords('header');
  const [search, setSearch] = useState('');
  const root = useRef<HTMLDivElement>(null);
  const id = useId();
  useEffect(() => {
    const { current } = root;
    current?.querySelector('input')?.focus();
    current?.addEventListener('keydown', goOn);
    return () => current?.removeEventListener('keydown', goOn);
  }, []);
  const choose = (id: string) => {
    allDevices.choose(id);
    onChosen();
  };
  const mine = found(allDevices.own.value, search);
  const brought = found(linked(), search);
  const others = found(builtInProfiles, search);
  const first = mine[0] ?? brought[0] ?? others[0];
  return (
    <div ref={root} class="device-options">
      <ChosenDevice />
      <SearchBox
        id={id}
        label={words.search}
        text={search}
        found={first ? '' : words.nothingFound}
        onText={setSearch}
        onEnter={first && (() => choose(first.id))}
      />
      {search === '' && <ProfileButtons profiles={[{ id: '', name: none }]} onChoose={choose} />}
      {page.leavesOut.value && <p class="said">{tooLarge}</p>}
      {mine.length > 0 && <Group title={own} profiles={mine} onChoose={choose} />}
      {brought.length > 0 && <Group title={inLink} profiles={brought} onChoose={choose} />}
      {others.length > 0 && <Group title={builtIn} profiles={others} onChoose={choose} />}
    </div>
  );
}

interface ButtonsProps {
  readonly profiles: readonly Pick<Profile, 'id' | 'name' | 'serial'>[];
  readonly onChoose: (id: string) => void;
}

/** Buttons that choose a device; that of the chosen one is pressed. */
export function ProfileButtons({ profiles, onChoose }: ButtonsProps) {
  const { serial: line } = useWords('devices');
  return (
    <>
      {profiles.map(({ id, name, serial }) => (
        <button
          key={id}
          type="button"
          aria-pressed={(allDevices.chosen.value?.id ?? '') === id}
          onClick={() => onChoose(id)}
        >
          {name} {serial && <span class="said mono">{line(serial)}</span>}
        </button>
      ))}
    </>
  );
}

interface GroupProps extends ButtonsProps {
  readonly title: string;
}

function Group({ title, ...buttons }: GroupProps) {
  const id = useId();
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset would frame it.
    <div role="group" aria-labelledby={id}>
      <p id={id} class="soft">
        {title}
      </p>
      <ProfileButtons {...buttons} />
    </div>
  );
}
