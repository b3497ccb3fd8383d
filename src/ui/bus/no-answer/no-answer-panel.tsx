export const NoAnswerPanel = () => null;
