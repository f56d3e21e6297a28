// The workbench: its part of the panel (sizes, the selection, figures before and after) and the bar with the command.

/** An element with attributes beside its properties. */
function labelled(name, properties, attributes, ...children) {
  const made = element(name, properties, ...children);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

function field(name, label, value, attributes = {}) {
  const input = labelled("input", { type: "text", name, defaultValue: value }, { autocomplete: "off", spellcheck: "false", ...attributes });
  return element("label", { className: "bench-field" }, element("span", {}, label), input);
}

function action(text, title, onclick) {
  return element("button", { type: "button", textContent: text, title, onclick });
}

/** A form whose fields are read together: `apply` gets {name: text}. */
function benchForm(apply, ...children) {
  const form = element("form", {}, ...children);
  form.onsubmit = (event) => {
    event.preventDefault();
    for (const input of form.querySelectorAll("input")) input.defaultValue = input.value; // nothing is left to apply
    apply(Object.fromEntries([...new FormData(form)].map(([key, value]) => [key, String(value).trim()])));
  };
  return form;
}

/** Builds what is there always, before the other sections of the panel and below the drawing. */
function buildBench(page) {
  const inUnit = page.data.unit ? `, ${page.data.unit}` : "";
  const size = field("size", `Edge length${inUnit}`, "", { placeholder: "auto", title: "Key e; without it, a twentieth of the diameter", inputmode: "decimal" });
  const form = benchForm((values) => setSize(page, values.size), size, element("button", {}, "Apply"));
  document.querySelector("aside").prepend(
    labelled("section", { id: "bench" }, { "aria-label": "Workbench" },
      Object.assign(form, { id: "bench-size", className: "bench-row" }),
      labelled("div", { id: "bench-item" }, { role: "group", "aria-label": "Selection" }),
      element("h2", {}, "Before and after"), element("table", { id: "bench-figures" }),
      labelled("button", { id: "bench-former", textContent: "Lines of the mesh before", title: "Key b", onclick: () => page.toggleFormer() }, { "aria-pressed": "false" }),
      element("details", { id: "bench-warnings", hidden: true }, element("summary"), element("ul"))),
  );
  const failure = labelled("div", { id: "bench-failure", hidden: true }, { role: "alert" },
    element("p"), action("Undo", "Control z", () => page.step(-1)), action("Close", "", hideFailure));
  byId("window").append(failure, labelled("div", { id: "bench-waiting", hidden: true }, { role: "status" }, element("i"), "meshing"));
  document.body.append(benchBar(page));
}

function benchBar(page) {
  const history = [["undo", "Undo", -1], ["redo", "Redo", 1]].map(([id, text, by]) =>
    Object.assign(action(text, "", () => page.step(by)), { id: `bench-${id}` }));
  const save = [["command", "Command"], ["makefile", "Makefile"], ["nodes", "Nodes"]].map(([what, text]) =>
    action(text, `Save: ${{ command: "a script with the command (Control s)", makefile: "a fragment for make", nodes: "x.crit.json" }[what]}`, () => page.save(what)));
  return labelled("footer", { id: "bench-bar" }, { "aria-label": "Command" },
    element("div", { className: "bench-group" }, ...history),
    labelled("code", { id: "bench-command" }, { tabindex: "0", role: "region", "aria-label": "Command that makes this mesh" }),
    Object.assign(action("Copy", "Copy the command", () => copyCommand(page)), { id: "bench-copy" }),
    labelled("div", { className: "bench-group" }, { role: "group", "aria-label": "Save" }, element("span", {}, "Save"), ...save));
}

async function copyCommand(page) {
  const copied = await navigator.clipboard.writeText(page.command).then(() => true, () => false);
  if (copied) return page.tell("The command is copied.");
  getSelection().selectAllChildren(byId("bench-command"));
  page.tell("The command is selected: copy it with Control c.");
}

/** All that depends on the state, the selection or the last mesh. */
function fillBench(page) {
  const { history, state } = page, size = document.querySelector("#bench-size input");
  size.defaultValue = state.size === null ? "" : state.size;
  if (document.activeElement !== size) size.value = size.defaultValue;
  fillSelection(page);
  byId("bench-command").textContent = page.command;
  for (const [id, text, key] of [["undo", history.undoText, "Control z"], ["redo", history.redoText, "Control Shift z"]])
    Object.assign(byId(`bench-${id}`), { disabled: !text, title: text ? `${text} (${key})` : key });
  fillFigures(page);
  fillWarnings(page.warnings || page.data.workbench.warnings || []);
}

/** Of the same selection as before, the focus and what was typed and not applied stay. */
function fillSelection(page) {
  const panel = byId("bench-item"), subject = JSON.stringify([[...page.curves], page.item]);
  const inputs = () => [...panel.querySelectorAll("input, button")], focus = inputs().indexOf(document.activeElement);
  const typed = inputs().filter((input) => input.name && input.value !== input.defaultValue).map(({ name, value }) => [name, value]);
  panel.replaceChildren(...selectionPanel(page));
  const isSame = page.panelSubject === subject;
  page.panelSubject = subject;
  if (!isSame) return;
  for (const [name, value] of typed) for (const input of inputs()) if (input.name === name) input.value = value;
  inputs()[focus]?.focus();
}

function selectionPanel(page) {
  if (page.curves.size) return curvePanel(page);
  if (page.item && page.item.kind === "corner") return cornerPanel(page, page.item.number);
  if (page.item && page.item.kind === "node") return nodePanel(page, page.item.number);
  const text = "Click a curve to name it and give it a size or layers, a corner to change its blocks; drag an irregular node. Keys: Tab, Enter, arrows.";
  return [element("p", { className: "bench-hint" }, text), boxButton(page)];
}

function boxButton(page) {
  const start = () => {
    page.isBoxing = !page.isBoxing;
    page.showBench();
    page.tell(page.isBoxing ? "Drag a box around curves." : "");
  };
  return labelled("button", { type: "button", textContent: "In a box", title: "Drag a box: all curves that lie in it", onclick: start }, { "aria-pressed": page.isBoxing });
}

function selectionTitle(page) {
  const { curves, names } = page, keys = names.keysOf(curves), [first] = curves;
  const name = keys.length === 1 && names.nameOf(first) ? `: ${keys[0]}` : "";
  return `${curves.size === 1 ? `Curve ${names.madeNumber(first) || first}` : `${curves.size} curves`}${name}`;
}

/** The value that all keys have in a table; "" if they differ. */
function commonValue(table, keys) {
  const values = new Set(keys.map((key) => table[key] ?? ""));
  return values.size === 1 ? String([...values][0]) : "";
}

function curvePanel(page) {
  const { curves, names, state } = page, keys = names.keysOf(curves), given = new Set([...curves].map((curve) => names.nameOf(curve)));
  const wall = wallMembers(commonValue(state.walls, keys)), others = keys.flatMap((key) => names.curvesOf(key)).filter((c) => !curves.has(page.groups.lower(c)));
  const form = benchForm((values) => applyToCurves(page, values),
    field("name", "Name", given.size === 1 ? [...given][0] : "", { placeholder: given.size > 1 ? "several" : "" }),
    field("near", "Length near it", commonValue(state.near, keys), { inputmode: "decimal" }),
    element("fieldset", {}, element("legend", {}, "Wall layers"),
      field("first", "First", wall.first || "", { inputmode: "decimal" }), field("growth", "Growth", wall.growth || "", { placeholder: "1.2", inputmode: "decimal" }),
      field("layers", "Number", wall.layers || "", { placeholder: "or fit" })),
    element("div", { className: "bench-group" }, element("button", {}, "Apply"), action("Close", "Escape", () => page.select([]))));
  const also = others.length ? [element("p", { className: "bench-hint" }, `Sizes and layers are for all curves of ${keys.length > 1 ? "these names" : "this name"}: ${others.length} more.`)] : [];
  return [element("h2", {}, selectionTitle(page)), form, ...also, ...moreCurves(page)];
}

/** Buttons that select more curves. */
function moreCurves(page) {
  const [first] = page.curves, diameter = page.groups.diameterOf(first), rows = [];
  if (diameter) {
    const below = benchForm((values) => page.selectBelow(values.diameter),
      field("diameter", "Circles below", Number((1.01 * diameter).toPrecision(3)), { inputmode: "decimal", "aria-label": "Diameter" }), element("button", {}, "Select"));
    rows.push(Object.assign(below, { className: "bench-row" }));
  }
  const tangent = action("Tangent to it", "All curves that continue it without a corner", () => page.selectTangent());
  return [element("h2", {}, "Select more"), ...rows, element("div", { className: "bench-group" }, tangent, boxButton(page))];
}

function cornerPanel(page, number) {
  const valence = page.valenceOf(number), [a, b] = page.curvesAt(number);
  const isPrescribed = page.state.valences.some((known) => String(known.corner) === String([a, b]));
  const undo = () => page.prescribe(number, null, "corner as computed");
  const buttons = [action("−", "One block less (arrow down)", () => page.changeValence(number, -1)),
    element("output", {}, `${valence} block${valence === 1 ? "" : "s"}`),
    action("+", "One block more (arrow up)", () => page.changeValence(number, 1))];
  if (isPrescribed) buttons.push(action("As computed", "Without a prescribed number", undo));
  return [element("h2", {}, `Corner between curves ${a} and ${b}`),
    element("p", { className: "bench-hint" }, page.corners.heading(number)), element("div", { className: "bench-group" }, ...buttons)];
}

function nodePanel(page, number) {
  const [x, y] = page.rounded(page.nodes.points.subarray(2 * number, 2 * number + 2));
  const back = page.isMoved(number) ? [action("Put back", "To where it was", () => page.moveNodeTo(number, null))] : [];
  const form = benchForm((values) => placeNode(page, number, [Number(values.x), Number(values.y)]),
    field("x", "x", x, { inputmode: "decimal" }), field("y", "y", y, { inputmode: "decimal" }), element("div", { className: "bench-group" }, element("button", {}, "Move"), ...back));
  const hint = `${page.nodes.heading(number)}. Its vertex of the mesh may lie beside it: vertices move to the sizes.`;
  return [element("h2", {}, "Irregular node"), element("p", { className: "bench-hint" }, hint), form];
}

function placeNode(page, number, to) {
  if (to.every(Number.isFinite)) page.moveNodeTo(number, to);
  else showFailure(page, "A position has two numbers, x and y.");
}

/** A length above 0 as a number, null for "", undefined for other texts, with a message. */
function lengthIn(page, text, what) {
  if (text === "") return null;
  if (Number(text) > 0) return Number(text);
  showFailure(page, `${what}: '${text}' is not a length above 0.`);
  return undefined;
}

function setSize(page, text) {
  const size = lengthIn(page, text, "Edge length");
  if (size !== undefined) page.commit(size === null ? "default edge length" : `edge length ${size}`, (state) => (state.size = size));
}

/** The fields of curves that were changed: {name: text}, as they were if untouched. */
function changedFields(page, values) {
  const { curves, names, state } = page, keys = names.keysOf(curves), given = new Set([...curves].map((curve) => names.nameOf(curve)));
  const wall = wallMembers(commonValue(state.walls, keys));
  const before = { name: given.size === 1 ? [...given][0] : "", near: commonValue(state.near, keys), first: "", growth: "", layers: "", ...wall };
  return Object.fromEntries(Object.entries(values).filter(([key, text]) => text !== String(before[key])));
}

/** Name, size and layers of the selected curves, as one step; fields that were not touched change nothing. */
function applyToCurves(page, values) {
  const { name, near, ...wall } = changedFields(page, values), { curves, boundary, rule } = page;
  const length = near === undefined ? undefined : lengthIn(page, near, "Length");
  if (near !== undefined && length === undefined) return;
  if (name !== undefined && page.names.isRenumbered) return showFailure(page, "Layers with blocks of their own give curves other numbers: name curves on the command line (--name).");
  if (/[=,@:*?"<>]/.test(name || "")) return showFailure(page, `Name: '${name}' has a character that options of names use: = , @ : * ? " < >`);
  const isRule = rule && rule.curves.size === curves.size && [...curves].every((curve) => rule.curves.has(curve));
  const what = [name && `name ${name}`, name === "" && "name taken away", length !== undefined && "length", Object.keys(wall).length && "layers"];
  page.commit(what.filter(Boolean).join(", "), (state) => {
    if (name !== undefined) nameCurves(state, curves, name, isRule ? rule.text : "", boundary);
    for (const key of new CurveNames(state, boundary).keysOf(curves)) {
      if (length !== undefined) setKey(state.near, key, length);
      if (Object.keys(wall).length) setKey(state.walls, key, wallText(state.walls[key], wall));
    }
  });
}
