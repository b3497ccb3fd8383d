// Before anything is drawn: the colours that were chosen in the page's header. What is stored there is JSON.
try {
  const theme = JSON.parse(localStorage.getItem('framewright.theme'));
  if (theme === 'light' || theme === 'dark') document.documentElement.dataset.theme = theme;
} catch {
  // The browser keeps nothing for this page, or what it keeps is of something else: the colours are the system's.
}
