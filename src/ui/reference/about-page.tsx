import { others, ours } from 'virtual:licences';
import { Fold } from '../kit/fold.tsx';
import { useWords } from '../parts/words.ts';

/** Whose the page is, and whose the packages in it are. */
export function About() {
  const words = useWords('about');
  return (
    <section class="panel about" aria-labelledby="about">
      <h2 id="about" tabIndex={-1}>
        {words.title}
      </h2>
      <p>{words.version(ours.version)}</p>
      <p class="introduction soft">{words.stays}</p>
      <Licence {...ours} />
      <p>{words.contains}</p>
      {others.map((each) => (
        <Licence key={each.name} {...each} />
      ))}
    </section>
  );
}

function Licence({ name, version, licence, text }: typeof ours) {
  const words = useWords('about');
  return <Fold summary={words.package(name, version, licence)}>{() => <pre class="mono licence">{text}</pre>}</Fold>;
}
