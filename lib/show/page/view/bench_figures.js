// The workbench: figures of the mesh before and of the new one, warnings, failures, and that a run takes long.

/** Counts and qualities of a mesh: [label, number or null, digits of its text]. */
function figuresOfMesh(report, layers, nodes) {
  const mesh = layers.find((layer) => layer.noun === "quad"), blocks = layers.find((layer) => layer.key === "blocks");
  const quantity = (title) => mesh && mesh.quantities.find((candidate) => candidate.title === title);
  const inner = nodes && nodes.kinds.filter((kind) => kind === "node").length;
  return [
    ["quads", mesh && mesh.count], ["blocks", blocks && blocks.count], ["irregular nodes", inner],
    ["R", report.resolution && report.resolution.ratio], ["least scaled Jacobian", quantity("scaled Jacobian")?.least],
    ["greatest edge ratio", quantity("edge-length ratio")?.greatest], ["greatest growth", report.growth && report.growth.greatest],
  ];
}

const figureTitles = {
  R: "Resolution: squared error of a smooth solution over that of as many squares of the prescribed sizes",
  "greatest growth": "Of adjacent edges along lines; with wall layers",
};

function fillFigures(page) {
  const before = page.former ? page.former.figures : page.meshFigures.map(([label]) => [label, null]);
  const text = (value) => (Number.isFinite(value) ? figure(value) : "–");
  const rows = page.meshFigures.map(([label, value], i) =>
    element("tr", {}, labelled("th", { textContent: label, title: figureTitles[label] || "" }, { scope: "row" }), element("td", {}, text(before[i][1])),
      element("td", {}, text(value))));
  const head = element("tr", {}, element("td"), ...["before", "now"].map((title) => labelled("th", { textContent: title }, { scope: "col" })));
  byId("bench-figures").replaceChildren(head, ...rows);
  const button = byId("bench-former");
  button.setAttribute("aria-pressed", String(page.isFormerShown && Boolean(page.former)));
  button.disabled = !page.former;
}

function fillWarnings(warnings) {
  const list = byId("bench-warnings"), texts = warnings.map((warning) => warning.message || String(warning));
  list.hidden = !texts.length;
  list.firstChild.textContent = `${texts.length} warning${texts.length === 1 ? "" : "s"}`;
  list.lastChild.replaceChildren(...texts.map((text) => element("li", {}, text)));
}

/** The message of a run that failed; the drawing shows the last good mesh. */
function showFailure(page, message) {
  const box = byId("bench-failure");
  box.querySelector("p").textContent = message;
  box.querySelector("button").disabled = !page.history.undoText;
  box.hidden = false;
}

function hideFailure() {
  byId("bench-failure").hidden = true;
}

function showWaiting(isWaiting) {
  byId("bench-waiting").hidden = !isWaiting;
}
