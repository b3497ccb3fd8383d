// Before uPlot: when it loads it makes a format of numbers in the browser's language, and throws where that is not a language
// tag. WebKitGTK says `C` under the locale of that name.
try {
  new Intl.NumberFormat(navigator.language);
} catch {
  Object.defineProperty(navigator, 'language', { value: 'en', configurable: true });
}
