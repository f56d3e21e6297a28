// Colours that differ in lightness, so that readers who do not distinguish all hues can read them; for light and dark.

const themes = {
  light: {
    paper: [255, 255, 255], ink: "#1c2733", faint: "#6b7a89", line: "33,48,64", border: "#22303f", accent: "#c2410c",
    other: { line: "194,65,12", border: "#c2410c" },
    fill: "#eef2f6", halo: "rgba(255,255,255,0.85)",
    ramp: ["#2d0f4f", "#4b3a93", "#2f6fa8", "#35a39b", "#93d19a", "#f1f5d6"],
    blocks: ["#dbe9f6", "#fdebd0", "#d9f0e3", "#f6e0ea", "#e9e4f5", "#f3f1d0", "#dff3f6"], angle: [0.86, 0.07],
  },
  dark: {
    paper: [18, 23, 30], ink: "#e6edf3", faint: "#93a1b0", line: "214,226,238", border: "#c9d6e3", accent: "#ff9f5a",
    other: { line: "255,159,90", border: "#ff9f5a" },
    fill: "#1f2933", halo: "rgba(18,23,30,0.85)",
    ramp: ["#fdf3a0", "#a5d86c", "#3fae86", "#2f7d95", "#2c5072", "#223248"],
    blocks: ["#20394f", "#4a3a22", "#1f4234", "#472b39", "#363050", "#42401f", "#1f4448"], angle: [0.45, 0.09],
  },
};

/** Hues of lines and marks that are told apart without red and green (after Okabe and Ito). */
const lineHues = {
  light: ["#0072b2", "#d55e00", "#009e73", "#b35a8f", "#3f8fc4", "#b07a00", "#5b4b8a"],
  dark: ["#56b4e9", "#e8804a", "#2fc79a", "#e09cc4", "#8fd0ff", "#f0b840", "#b3a4e8"],
};

/** The colour of a mark by the field index of its node: fewer blocks than 4 warm, more cold. */
function valenceColour(theme, valence, isBoundary) {
  const hues = lineHues[theme.name];
  const index = (isBoundary ? 2 : 4) - valence;
  return index > 0 ? hues[1] : index < 0 ? hues[0] : theme.faint;
}

function channelsOf(colour) {
  const rgb = parseInt(colour.slice(1), 16);
  return [rgb >> 16, (rgb >> 8) & 255, rgb & 255];
}

/** `count` colours [r, g, b] along the stops. */
function rampColours(stops, count) {
  const channels = stops.map(channelsOf);
  return Array.from({ length: count }, (_, i) => {
    const t = (i / (count - 1)) * (stops.length - 1);
    const k = Math.min(stops.length - 2, Math.floor(t));
    return channels[k].map((c, j) => Math.round(c + (t - k) * (channels[k + 1][j] - c)));
  });
}

const css = ([r, g, b]) => `rgb(${r},${g},${b})`;

/** The channels of a colour in OKLab (Ottosson 2020). */
function oklab(lightness, a, b) {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const encoded = (x) => {
    const c = Math.min(1, Math.max(0, x));
    return Math.round(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055));
  };
  return [
    encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    encoded(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

/** 256 colours round the cross angle: light, blue, dark, orange and back. */
function angleColours(theme) {
  const [lightness, swing] = theme.angle;
  return Array.from({ length: 256 }, (_, i) => {
    const phase = (2 * Math.PI * i) / 256, side = Math.sin(phase);
    const hue = side > 0 ? (250 * Math.PI) / 180 : (60 * Math.PI) / 180;
    const chroma = 0.1 * Math.abs(side);
    return oklab(lightness + swing * Math.cos(phase), chroma * Math.cos(hue), chroma * Math.sin(hue));
  });
}

function themeNamed(name) {
  const theme = { name, ...themes[name] };
  theme.rampColours = rampColours(theme.ramp, 64);
  theme.angleColours = angleColours(theme);
  return theme;
}
