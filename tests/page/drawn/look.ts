import { beginAriaCaches, endAriaCaches } from 'ivya/utils';

/** How many looks are being taken: one may be a part of another. */
let looks = 0;

/** What was found out in this look, in which nothing of the page changes. */
const known: Map<Node, unknown>[] = [];

/** Looks at the page without changing it, so that what is asked of an element is found out once. */
export function look<Result>(take: () => Result): Result {
  looks += 1;
  beginAriaCaches();
  try {
    return take();
  } finally {
    endAriaCaches();
    looks -= 1;
    if (looks === 0) for (const answers of known) answers.clear();
  }
}

/** What is asked of a node, asked once in a look. */
export function oncePerLook<Of extends Node, Answer>(ask: (node: Of) => Answer): (node: Of) => Answer {
  const answers = new Map<Of, Answer>();
  known.push(answers as Map<Node, unknown>);
  return (node) => {
    if (looks === 0) return ask(node);
    const before = answers.get(node);
    if (before !== undefined) return before;
    const answer = ask(node);
    answers.set(node, answer);
    return answer;
  };
}
