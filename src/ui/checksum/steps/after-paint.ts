import type { ComponentChildren } from 'preact';
import { useEffect, useState } from 'preact/hooks';

/** What is drawn when all before it is on the screen: opening a view need not wait for it. */
export function AfterPaint({ children }: { readonly children: () => ComponentChildren }): ComponentChildren {
  const [ready, setReady] = useState(false);
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    const frame = requestAnimationFrame(() => {
      timer = setTimeout(() => setReady(true));
    });
    return () => {
      cancelAnimationFrame(frame);
      clearTimeout(timer);
    };
  }, []);
  return ready ? children() : null;
}
