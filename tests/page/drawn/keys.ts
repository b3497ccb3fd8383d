/** A key with those held beside it, `Control+Shift+K`, as user-event writes it. */
export function inKeys(keys: string): string {
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
