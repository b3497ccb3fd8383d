import type { UserEvent } from '@testing-library/user-event';

/** Presses a key with those held beside it, `Control+Shift+K`; Control with V pastes. */
export async function press(user: UserEvent, keys: string): Promise<void> {
  if (!/^(Control|ControlOrMeta)\+V$/i.test(keys)) return user.keyboard(inKeys(keys));
  await user.keyboard('{Control>}v');
  await user.paste();
  await user.keyboard('{/Control}');
}

/** Types a text, in which nothing is the name of a key. */
export const type = (user: UserEvent, text: string): Promise<void> => user.keyboard(text.replace(/[{[]/g, '$&$&'));

/** A key with those held beside it, `Control+Shift+K`, as user-event writes it. */
function inKeys(keys: string): string {
  const parts = keys === '+' ? ['+'] : keys.split('+').map((part) => (part === '' ? '+' : part));
  const key = parts.at(-1) ?? '';
  const held = parts.slice(0, -1).map((part) => (part === 'ControlOrMeta' ? 'Control' : part));
  const pressed = key.length === 1 ? key.replace(/[{[]/, '$&$&') : key === 'Space' ? ' ' : `{${key}}`;
  return (
    held.map((name) => `{${name}>}`).join('') +
    pressed +
    held
      .toReversed()
      .map((name) => `{/${name}}`)
      .join('')
  );
}
