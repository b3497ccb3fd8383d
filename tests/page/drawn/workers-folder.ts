/** Where the page's workers are built for the tests that draw the page. */
export const workersFolder = '.cache/page-workers';
