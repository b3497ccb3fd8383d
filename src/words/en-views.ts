/** What the views are called. */
export const views = { views: 'Views', frame: 'Frame', reference: 'Reference' };
