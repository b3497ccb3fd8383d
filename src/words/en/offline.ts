/** What is said of the page as the browser keeps it. */
export const offline = {
  newVersion: 'There is a new version of this page.',
  reload: 'Reload',
  later: 'Later',
};
