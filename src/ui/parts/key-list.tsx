import { useEffect, useRef } from 'preact/hooks';
import { commands } from './store.ts';
import { useWords } from './words.ts';

/** Every key of the page and what it does, in a dialog. */
export function KeyList() {
  const words = useWords('commands');
  const { keyText } = useWords('page').views;
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => dialog.current?.showModal(), []);
  return (
    <dialog ref={dialog} class="keys" aria-labelledby="keys" onClose={() => (commands.listed.value = false)}>
      <h2 id="keys">{words.heading}</h2>
      <dl>
        {commands.table.map(({ id, key }) => (
          <div key={key + id}>
            <dt>
              <kbd>{keyText(key)}</kbd>
            </dt>
            <dd>{words.titles[id]}</dd>
          </div>
        ))}
      </dl>
      <label class="tick">
        <input
          type="checkbox"
          checked={commands.singleKeys.value}
          onChange={({ currentTarget }) => (commands.singleKeys.value = currentTarget.checked)}
        />{' '}
        {words.singleKeys}
      </label>
      <form method="dialog" class="actions">
        <button type="submit">{words.close}</button>
      </form>
    </dialog>
  );
}
