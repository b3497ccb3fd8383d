/** What every form of the page may do beside running its own scripts and styles: nothing that is not named. */
const common = {
  'default-src': "'none'",
  'img-src': "'self' data: blob:",
  'base-uri': "'none'",
  'form-action': "'none'",
  'require-trusted-types-for': "'script'",
  'trusted-types': 'framewright',
};

/** The folder: its own files, and nothing else. Scripts come only from addresses of its one policy. */
export const policyOfFolder = written({
  ...common,
  'script-src': "'self'",
  'style-src': "'self'",
  'worker-src': "'self'",
  'connect-src': "'self'",
  'manifest-src': "'self'",
});

/**
 * The one file: the scripts and the style that stand in it, and what they unpack. Nothing comes from anywhere else.
 * @param {string[]} scripts what `hashOf` gives for each
 * @param {string} style the same for the style
 */
export const policyOfFile = (scripts, style) =>
  written({
    ...common,
    'img-src': 'data: blob:',
    'script-src': `${scripts.join(' ')} blob:`,
    'style-src': style,
    'worker-src': 'blob:',
  });

/** @param {Record<string, string>} rules */
function written(rules) {
  return Object.entries(rules)
    .map(([directive, sources]) => `${directive} ${sources}`)
    .join('; ');
}
