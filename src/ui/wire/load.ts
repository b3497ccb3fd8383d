/** The panel comes right behind the first view, and what is in it when it is first opened. */
export const loadWire = () =>
  import('./wire-panel.tsx').then(async ({ WirePanel, loadWords }) => {
    await loadWords();
    return WirePanel;
  });
