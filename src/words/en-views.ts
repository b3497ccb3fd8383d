/** What the views are called. */
export const views = { views: 'Views', names: { frame: 'Frame', reference: 'Reference' } };
