try {
  const theme = JSON.parse(localStorage.getItem('framewright.theme'));
  if (theme === 'light' || theme === 'dark') document.documentElement.dataset.theme = theme;
} catch {}
