/** The steps of a checksum, with their sentences, when they are first opened. */
export const loadSteps = () =>
  import('./steps-view.tsx').then(async ({ StepsView, loadWords }) => {
    await loadWords();
    return StepsView;
  });
