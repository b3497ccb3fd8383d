const nothing = () => undefined;

/** What scripts draw with on a canvas, which nobody sees here: what is set is kept, and every method does nothing. */
const penOf = (canvas: HTMLCanvasElement) =>
  new Proxy<Record<string | symbol, unknown>>(
    { canvas, measureText: (text: string) => ({ width: 6 * text.length }) },
    { get: (pen, name) => (Object.hasOwn(pen, name) ? pen[name] : nothing) },
  );

/** Lets scripts draw on a canvas: the document in this process has none that can be drawn on. */
export function addCanvas(): void {
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement) {
    return penOf(this);
  } as never;
  const path = class {
    readonly moveTo = nothing;
    readonly lineTo = nothing;
    readonly rect = nothing;
    readonly arc = nothing;
    readonly addPath = nothing;
  };
  Object.defineProperty(globalThis, 'Path2D', { value: path, configurable: true, writable: true });
}
