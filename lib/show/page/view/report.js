// The tab of the run: figures, warnings, times of the stages, histograms of the mesh, commands.

const textOf = (value) => {
  if (typeof value === "number") return figure(value);
  if (value === null || value === "") return "–";
  return Array.isArray(value) ? value.map(textOf).join(", ") : String(value);
};

/** Rows [dotted key, value] of a nested object. */
function flatRows(object, prefix = "") {
  return Object.entries(object).flatMap(([key, value]) => {
    const isNested = value && typeof value === "object" && !Array.isArray(value);
    return isNested ? flatRows(value, `${prefix}${key}.`) : [[prefix + key, textOf(value)]];
  });
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
    const texts = [name, `${seconds.toFixed(3)} s`].map((text) => element("td", {}, text));
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
  const rows = flatRows(figures).map(([key, text]) =>
    element("tr", {}, element("td", {}, key), element("td", {}, text)),
  );
  const commands = [...(command ? [command, ""] : []), ...data.commands].join("\n");
  byId("report").replaceChildren(
    reportSection("Shapes of elements", element("div", { className: "figures" }, ...histograms(sheets, theme))),
    reportSection("Warnings", warningList(warnings)),
    reportSection("Seconds of CPU", timeTable(stages)),
    reportSection("Report", element("table", { className: "rows" }, ...rows)),
    reportSection("Commands", element("pre", {}, commands)),
  );
}
