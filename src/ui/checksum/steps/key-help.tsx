import { stepWords as words } from './step-words.ts';

/** What the keys do while the list has the focus. */
export function KeyHelp({ id }: { id: string }) {
  return (
    <p class="step-keys said" id={id}>
      {words.keys}{' '}
      {words.keyNames.map(({ keys, does }) => (
        <span key={does}>
          {keys.map((key) => (
            <>
              <kbd key={key}>{key}</kbd>{' '}
            </>
          ))}
          {does}
        </span>
      ))}
    </p>
  );
}
