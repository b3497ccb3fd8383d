/** Of a control that is disabled, why: it is its description and its tooltip. Without a reason it is not disabled. */
export const disabledFor = (why: string | undefined) => ({ disabled: why !== undefined, title: why });
