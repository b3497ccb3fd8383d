import type { Language, Subject, WordsOf } from './languages.ts';

/** The sentences of one language, as far as they have come. */
export class Vocabulary {
  readonly #language: Language;
  readonly #come = new Map<Subject, unknown>();

  constructor(language: Language) {
    this.#language = language;
  }

  /** Brings the sentences of some subjects. Those that have come are not asked for again; a failure may be tried again. */
  async load(...subjects: readonly Subject[]): Promise<void> {
    await Promise.all(
      subjects.map(async (subject) => {
        if (this.#come.has(subject)) return;
        const words = await this.#language[subject]();
        // A server may answer with an empty file.
        if (words === undefined) throw new TypeError(`The imported module has no words of ${subject}.`);
        this.#come.set(subject, words);
      }),
    );
  }

  has(subject: Subject): boolean {
    return this.#come.has(subject);
  }

  /** What is said about a subject. Whoever asks declares its subjects with its loader: a `TypeError` if they have not come. */
  of<S extends Subject>(subject: S): WordsOf<S> {
    if (!this.#come.has(subject)) throw new TypeError(`The words of ${subject} have not come.`);
    return this.#come.get(subject) as WordsOf<S>;
  }
}
