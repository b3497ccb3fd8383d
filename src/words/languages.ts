import { english } from './en/index.ts';

/** What a language says about each subject. English is the shape of all of them. */
export type Language = typeof english;
export type Subject = keyof Language;
export type WordsOf<S extends Subject> = Awaited<ReturnType<Language[S]>>;

/** The languages of the page, by their tags (BCP 47). Each is a folder. */
export const languages = { en: english } satisfies Readonly<Record<string, Language>>;

/** The first of the wanted tags that is a language of the page, by the tag itself or by its language alone; else English. */
export function languageTag(wanted: readonly string[]): keyof typeof languages {
  for (const tag of wanted) {
    for (const name of [tag, tag.split('-')[0]])
      if (name && Object.hasOwn(languages, name)) return name as keyof typeof languages;
  }
  return 'en';
}
