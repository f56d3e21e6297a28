// The workbench: its part of the panel and the bar with the command; what is selected is in bench_fields.js.

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
