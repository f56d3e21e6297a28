// Colours: those of the drawing are the page's data (lib/show/draw/palette.hpp), those around it are in view.css.

function channelsOf(colour) {
  const rgb = parseInt(colour.slice(1), 16);
  return [rgb >> 16, (rgb >> 8) & 255, rgb & 255];
}

/** `count` colours [r, g, b] along the stops [position, colour]. */
function rampColours(stops, count) {
  return Array.from({ length: count }, (_, i) => {
    const t = i / (count - 1);
    const k = Math.max(1, stops.findIndex(([position]) => position >= t - 1e-9));
    const [[from, a], [to, b]] = [stops[k - 1], stops[k]], s = (t - from) / (to - from), end = channelsOf(b);
    return channelsOf(a).map((c, j) => Math.round(c + s * (end[j] - c)));
  });
}

const css = ([r, g, b]) => `rgb(${r},${g},${b})`;

/** The colour of a mark: a node with a block less or more than a regular one, or another. */
function valenceColour(theme, valence, isBoundary) {
  const index = (isBoundary ? 2 : 4) - valence;
  return index === 1 ? theme.few : index === -1 ? theme.many : theme.other;
}

/** The colours of a quantity: from bad to good where that is known, else from low to high. */
const coloursOf = (theme, quantity) => (quantity.isJudged ? theme.qualityColours : theme.amountColours);

/** Chooses light or dark for the whole page; returns the colours of drawings. */
function themeNamed(name, palettes) {
  document.documentElement.dataset.theme = name;
  const style = getComputedStyle(document.documentElement), own = palettes[name], theme = { name, ...own };
  for (const part of ["paper", "ink", "faint", "rule", "accent", "line", "border", "fill", "halo"])
    theme[part] = style.getPropertyValue(`--${part}`).trim();
  theme.added = { isAdded: true, line: channelsOf(theme.accent).join(","), border: theme.accent };
  theme.qualityColours = rampColours(own.quality, 64);
  theme.amountColours = rampColours(own.amount, 64);
  theme.angleColours = rampColours(own.angle, 257); // from -45 to 45 degrees
  return theme;
}
