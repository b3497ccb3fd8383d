import { useCommand } from './commands.ts';

/** Lets the keys for faults choose the next faulty line of a list, or the one before. */
export function useFaultKeys(list: {
  readonly count: number;
  readonly chosen: number;
  readonly isFaulty: (index: number) => boolean;
  readonly choose: (index: number) => void;
}): void {
  const go = (by: 1 | -1) => () => {
    const { count, chosen, isFaulty, choose } = list;
    for (let index = chosen + by; index >= 0 && index < count; index += by) {
      if (isFaulty(index)) {
        choose(index);
        return;
      }
    }
  };
  useCommand('next-fault', go(1));
  useCommand('previous-fault', go(-1));
}
