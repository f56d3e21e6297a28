// The tab of the run: verdict, figures, warnings, times of the stages, histograms of the mesh, commands.

const textOf = (value) => {
  if (typeof value === "number") return figure(value);
  if (typeof value === "boolean") return value ? "yes" : "no";
  return Array.isArray(value) ? value.map(textOf).join(", ") : String(value);
};

const ownSpelling = [[/\bjacobian/g, "Jacobian"], [/\bcpu\b/g, "CPU"], [/\bcad\b/g, "CAD"], [/\bt junction/g, "T-junction"], [/\byplus\b/g, "y⁺"]];

/** "least_scaled_jacobian" as "least scaled Jacobian". */
function wordsOf(key) {
  return ownSpelling.reduce((text, [pattern, word]) => text.replace(pattern, word), key.replaceAll("_", " "));
}

const isNothing = (value) => value === null || value === "" || (Array.isArray(value) && !value.length);
const isNested = (value) => typeof value === "object" && (!Array.isArray(value) || typeof value[0] === "object");

/** Rows [words, value] of a nested object; what it says nothing of is left out. */
function flatRows(object, prefix = "") {
  const words = (key) => `${prefix}${/^[0-9]+$/.test(key) ? Number(key) + 1 : wordsOf(key)}`;
  return Object.entries(object).filter(([, value]) => !isNothing(value)).flatMap(([key, value]) =>
    isNested(value) ? flatRows(value, `${words(key)}, `) : [[words(key), textOf(value)]]);
}

/** A table of the plain members, and one with a heading for each nested one. */
function reportTables(figures) {
  const entries = Object.entries(figures).filter(([, value]) => !isNothing(value));
  const plain = Object.fromEntries(entries.filter(([, value]) => !isNested(value)));
  const table = (object) => element("table", { className: "rows" }, ...tableRows(flatRows(object)));
  const nested = entries.filter(([, value]) => isNested(value)).map(([key, value]) =>
    element("div", {}, element("h3", {}, wordsOf(key)), table(value)));
  return [element("div", {}, table(plain)), ...nested];
}

function reportSection(title, ...children) {
  return element("section", {}, element("h2", {}, title), ...children);
}

function warningList(warnings) {
  if (!warnings || !warnings.length) return element("p", {}, "none");
  const items = warnings.map(({ tool, code, message }) =>
    element("li", {}, element("strong", {}, `${code} (${tool}) `), message),
  );
  return element("ul", {}, ...items);
}

/** CPU seconds of the stages with bars. */
function timeTable(stages) {
  const rows = Object.entries(stages || {}).map(([name, time]) => [name, time.cpu_seconds || 0]);
  const most = Math.max(...rows.map(([, seconds]) => seconds), 1e-9);
  const cells = rows.map(([name, seconds]) => {
    const bar = element("div", { className: "bar" });
    bar.style.width = `${(100 * seconds) / most}%`;
    const texts = [wordsOf(name), `${seconds.toFixed(3)} s`].map((text) => element("td", {}, text));
    return element("tr", {}, ...texts, element("td", {}, bar));
  });
  return element("table", { className: "times" }, ...cells);
}

/** A histogram of each quantity of the last mesh. */
function histograms(sheets, theme) {
  const layer = sheets.flatMap((sheet) => sheet.layers).findLast((candidate) => candidate.noun === "quad");
  if (!layer) return [];
  return layer.quantities.map((quantity) => {
    const canvas = element("canvas", { width: 260, height: 120, className: "histogram" });
    drawHistogram(canvas, quantity, theme);
    return element("figure", {}, element("figcaption", {}, quantity.title), canvas, element("p", {}, limitsText(quantity)));
  });
}

function fillReport(data, sheets, theme) {
  const { stages, warnings, command, ...figures } = data.report;
  const commands = [...(command ? [command, ""] : []), ...data.commands].join("\n");
  const verdict = data.report.verdict && data.report.verdict.text;
  byId("report").replaceChildren(
    ...(verdict ? [reportSection("Verdict", element("p", {}, textOf(verdict)))] : []),
    reportSection("Shapes of elements", element("div", { className: "figures" }, ...histograms(sheets, theme))),
    reportSection("Warnings", warningList(warnings)),
    reportSection("Seconds of CPU", timeTable(stages)),
    reportSection("Figures", element("div", { className: "tables" }, ...reportTables(figures))),
    reportSection("Commands", element("pre", {}, commands)),
  );
}
