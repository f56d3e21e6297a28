// The workbench: the panel of what is selected or chosen, and what its fields do.

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
  const button = action("In a box", "Drag a box: all curves that lie in it", start);
  button.setAttribute("aria-pressed", String(page.isBoxing));
  return button;
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

/** What the fields show for the selected curves: {name, near, first, growth, layers, ...}, "" where they differ. */
function curveFields({ curves, names, state }) {
  const keys = names.keysOf(curves), given = new Set([...curves].map((curve) => names.nameOf(curve)));
  const wall = { first: "", growth: "", layers: "", ...wallMembers(commonValue(state.walls, keys)) };
  return { name: given.size === 1 ? [...given][0] : "", near: commonValue(state.near, keys), ...wall };
}

function curvePanel(page) {
  const { name, near, first, growth, layers } = curveFields(page), number = { inputmode: "decimal" };
  const form = benchForm((values) => applyToCurves(page, values),
    field("name", "Name", name, name || page.curves.size === 1 ? {} : { placeholder: "none, or several" }), field("near", "Length near it", near, number),
    element("fieldset", {}, element("legend", {}, "Wall layers"), field("first", "First", first, number),
      field("growth", "Growth", growth, { placeholder: "1.2", ...number }), field("layers", "Number", layers, { placeholder: "or fit" })),
    element("div", { className: "bench-group" }, element("button", {}, "Apply"), action("Close", "Escape", () => page.select([]))));
  return [element("h2", {}, selectionTitle(page)), form, ...hintOfOthers(page), ...moreCurves(page)];
}

/** That other curves have the name too, to which sizes and layers belong. */
function hintOfOthers({ curves, names, groups }) {
  const keys = names.keysOf(curves), all = new Set(keys.flatMap((key) => names.curvesOf(key)).map((curve) => groups.lower(curve)));
  const count = [...all].filter((curve) => !curves.has(curve)).length, whose = keys.length > 1 ? "these names" : "this name";
  return count ? [element("p", { className: "bench-hint" }, `Sizes and layers are for all curves of ${whose}: ${count} more.`)] : [];
}

/** Buttons that select more curves. */
function moreCurves(page) {
  const [first] = page.curves, diameter = page.groups.diameterOf(first), rows = [];
  if (diameter) {
    const below = benchForm((values) => page.selectBelow(values.diameter),
      field("diameter", "Circles below", Number((1.01 * diameter).toPrecision(3)), { inputmode: "decimal" }), element("button", {}, "Select"));
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
  const form = benchForm((values) => placeNode(page, number, [values.x, values.y].map((text) => Number(text || NaN))),
    field("x", "x", x, { inputmode: "decimal" }), field("y", "y", y, { inputmode: "decimal" }),
    element("div", { className: "bench-group" }, element("button", {}, "Move"), ...back));
  const hint = `${page.nodes.heading(number)}. Its vertex of the mesh may lie beside it: vertices move to the sizes.`;
  return [element("h2", {}, "Irregular node"), element("p", { className: "bench-hint" }, hint), form];
}

function placeNode(page, number, to) {
  if (to.every(Number.isFinite)) page.moveNodeTo(number, to);
  else showFailure(page, "A position has two numbers, x and y.");
}

/** Why a name cannot be given; "" if it can. */
function faultOfName(page, name) {
  if (page.names.isRenumbered) return "Layers with blocks of their own give curves other numbers: name curves on the command line (--name).";
  const isTaken = /[=,@:*?"<>]/.test(name);
  return isTaken ? `Name: '${name}' has a character that options of names use: = , @ : * ? " < >` : "";
}

/** Name, size and layers of the selected curves, as one step; fields that were not touched change nothing. */
function applyToCurves(page, values) {
  const before = curveFields(page), { curves, boundary, rule } = page;
  const { name, near, ...wall } = Object.fromEntries(Object.entries(values).filter(([key, text]) => text !== before[key]));
  const fault = name !== undefined && faultOfName(page, name), length = near && lengthIn(page, near, "Length");
  if (fault) showFailure(page, fault);
  if (fault || (near && !length)) return;
  const isRule = rule && rule.curves.size === curves.size && [...curves].every((curve) => rule.curves.has(curve));
  const what = [name && `name ${name}`, name === "" && "name taken away", near !== undefined && "length", Object.keys(wall).length && "layers"];
  page.commit(what.filter(Boolean).join(", "), (state) => {
    if (name !== undefined) nameCurves(state, curves, name, isRule ? rule.text : "", boundary);
    for (const key of new CurveNames(state, boundary).keysOf(curves)) {
      if (near !== undefined) setKey(state.near, key, length || null);
      if (Object.keys(wall).length) setKey(state.walls, key, wallText(state.walls[key], wall));
    }
  });
}
