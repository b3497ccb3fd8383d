/** The test card with its values and sentences, which come when it is opened. */
export const loadCard = () => import('./card-view.tsx').then(({ load }) => load());
