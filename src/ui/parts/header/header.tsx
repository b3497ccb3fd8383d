import { optionsOf, Select } from '../../kit/choice.tsx';
import { Popover } from '../../kit/popover.tsx';
import { busLink } from '../bus-link.ts';
import { DeviceMenu } from '../device/device-menu.tsx';
import { line } from '../line.ts';
import { part, Slot } from '../slot.tsx';
import { theme } from '../theme.ts';
import { useWords } from '../words.ts';
import './header.css';

const lineMenu = part(
  ['header'],
  () => import('./line-menu.tsx'),
  ({ LineMenu }) => LineMenu,
);

/** What belongs to every view: the device, the line, the connection. */
export function Settings() {
  const words = useWords('page').views;
  return (
    <section class="settings-bar" aria-label={words.settings}>
      <DeviceMenu none={words.noDevice} label={words.device} />
      <LineButton />
      <Connection />
    </section>
  );
}

function LineButton() {
  const words = useWords('page').views;
  const name = words.lineName(line.setting.value);
  return (
    <Popover class="line-menu" summary={name} label={words.line(name)}>
      {() => <Slot part={lineMenu} with={{}} />}
    </Popover>
  );
}

/** How the line is connected, and the way to the bus. The dot is filled while it is, so that its colour says nothing alone. */
function Connection() {
  const words = useWords('page').views;
  const { kind } = busLink.value;
  return (
    <a class="connection-state" href="#bus" title={words.connectionTitle}>
      <span class="dot" data-link={kind} aria-hidden="true" />
      <span aria-live="polite">{words.connection(busLink.value)}</span>
    </a>
  );
}

/** The colours of the page: those of the system, light, or dark. */
export function ThemeChoice() {
  const words = useWords('page').views;
  return (
    <Select
      class="theme"
      label={words.theme}
      value={theme.value}
      options={optionsOf(words.themes)}
      onChoose={(chosen) => {
        theme.value = chosen;
      }}
    />
  );
}
