/**
 * The words of every page. They come from their own layer and not by way of `language.ts`: that way the build would cut
 * what the first view needs into four files, which weigh 2 kB more.
 */
export { en as words } from '../../words/index.ts';
