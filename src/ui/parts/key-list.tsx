import { Dialog } from '../kit/dialog.tsx';
import { commands } from './store.ts';
import { useWords } from './words.ts';

/** Every key of the page and what it does, in a dialog. */
export function KeyList() {
  const words = useWords('commands');
  const { keyText } = useWords('page').views;
  // Not when the browser says that it is closed: that comes later, when it may be asked for again.
  const close = () => (commands.listed.value = false);
  const actions = (
    <button type="button" onClick={close}>
      {words.close}
    </button>
  );
  return (
    <Dialog title={words.heading} onClose={close} actions={actions}>
      <dl class="keys">
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
    </Dialog>
  );
}
