import { join } from 'node:path';

/** Where the page is built for the tests that draw it. */
export const builtFolder = '.cache/drawn-page';

/** The script of each page, by the name of its file. */
export const pages = { 'index.html': 'src/ui/main.tsx', 'kit.html': 'src/ui/kit/every-control.tsx' };
export type PageFile = keyof typeof pages;

export const scriptOf = (file: PageFile): string => join(builtFolder, `${file}.js`);
