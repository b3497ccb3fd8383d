/** What is offered where a frame or a log is pasted into a field that takes a number. */
export const paste = {
  readAsFrame: 'Read it as a frame',
};
