/**
 * How gofmt sets blanks around operators: none around those that bind tightly where others are beside them, such as `a<<8 | b`,
 * and none at all deep inside of others.
 * @module
 */
import { dictionary } from '../../modbus/index.ts';

type Node =
  | { readonly kind: 'binary'; readonly operator: string; readonly left: Node; readonly right: Node }
  | { readonly kind: 'unary'; readonly operator: string; readonly of: Node }
  | { readonly kind: 'parentheses'; readonly of: Node }
  | { readonly kind: 'call'; readonly of: Node; readonly given: readonly Node[] }
  | { readonly kind: 'index'; readonly of: Node; readonly at: Node }
  | { readonly kind: 'slice'; readonly of: Node; readonly bounds: readonly (Node | undefined)[] }
  | { readonly kind: 'plain'; readonly text: string };

const PRECEDENCE = dictionary<number>({
  '||': 1,
  '&&': 2,
  '==': 3,
  '!=': 3,
  '<': 3,
  '<=': 3,
  '>': 3,
  '>=': 3,
  '+': 4,
  '-': 4,
  '|': 4,
  '^': 4,
  '*': 5,
  '/': 5,
  '%': 5,
  '<<': 5,
  '>>': 5,
  '&': 5,
});

const TOKEN = /\s*([\p{L}\p{N}_.]+|<<|>>|&&|\|\||[=!<>]=|[-+*/%&|^<>!()[\],:])/gu;

/** An expression of names, numbers, operators, calls, indexes and slices, with blanks as gofmt sets them at this depth. */
export function spaced(text: string, depth = 1): string {
  const tokens = Array.from(text.matchAll(TOKEN), ([, token = '']) => token);
  let at = 0;
  const takes = (token: string): boolean => tokens[at] === token && at++ >= 0;
  const operand = (): Node => {
    const token = tokens[at++] ?? '';
    if (token === '!' || token === '-') return { kind: 'unary', operator: token, of: operand() };
    let node: Node = { kind: 'plain', text: token };
    if (token === '(') {
      node = { kind: 'parentheses', of: binary(1) };
      takes(')');
    }
    for (;;) {
      if (takes('(')) {
        const given: Node[] = [];
        while (!takes(')')) {
          given.push(binary(1));
          takes(',');
        }
        node = { kind: 'call', of: node, given };
      } else if (takes('[')) {
        const from = tokens[at] === ':' ? undefined : binary(1);
        if (takes(':')) node = { kind: 'slice', of: node, bounds: [from, tokens[at] === ']' ? undefined : binary(1)] };
        else if (from) node = { kind: 'index', of: node, at: from };
        takes(']');
      } else return node;
    }
  };
  const binary = (least: number): Node => {
    let left = operand();
    for (;;) {
      const operator = tokens[at] ?? '';
      const precedence = PRECEDENCE[operator] ?? 0;
      if (precedence < least || precedence === 0) return left;
      at++;
      left = { kind: 'binary', operator, left, right: binary(precedence + 1) };
    }
  };
  return written(binary(1), depth);
}

const precedenceOf = (node: Node): number | undefined =>
  node.kind === 'binary' ? PRECEDENCE[node.operator] : undefined;

/** Whether operators of sums and of products meet. */
function kinds(node: Node): readonly [sum: boolean, product: boolean] {
  if (node.kind !== 'binary') return [false, false];
  const [left, right] = [kinds(node.left), kinds(node.right)];
  const own = precedenceOf(node);
  return [own === 4 || left[0] || right[0], own === 5 || left[1] || right[1]];
}

/** Operators that bind less than this have blanks. */
function limit(node: Node, depth: number): number {
  const [sum, product] = kinds(node);
  if (sum && product) return depth === 1 ? 5 : 4;
  return depth === 1 ? 6 : 4;
}

function written(node: Node, depth: number): string {
  switch (node.kind) {
    case 'plain':
      return node.text;
    case 'unary':
      return node.operator + written(node.of, depth);
    case 'parentheses':
      return `(${written(node.of, Math.max(1, depth - 1))})`;
    case 'call': {
      const inner = node.given.length > 1 ? depth + 1 : depth;
      return `${written(node.of, depth)}(${node.given.map((one) => written(one, inner)).join(', ')})`;
    }
    case 'index':
      return `${written(node.of, 1)}[${written(node.at, depth + 1)}]`;
    case 'slice':
      return `${written(node.of, 1)}[${node.bounds.map((one) => one && written(one, depth + 1)).join(':')}]`;
    case 'binary': {
      const own = precedenceOf(node) ?? 0;
      const blank = own < limit(node, depth) ? ' ' : '';
      const left = written(node.left, precedenceOf(node.left) === own ? depth : depth + 1);
      return left + blank + node.operator + blank + written(node.right, depth + 1);
    }
  }
}
