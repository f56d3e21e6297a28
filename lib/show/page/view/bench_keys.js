// The workbench: its keys. Tab goes through curves, corners and nodes while the drawing has the focus.

const benchKeys = [
  ["Tab  Shift Tab", "next curve, corner or node; back"], ["Enter", "open it; move the node"],
  ["Shift Enter", "add the curve to the selection"], ["←  ↑  →  ↓", "of a chosen node: move it by a step, with Shift a small one; of a corner: blocks"],
  ["e", "edge length"], ["b", "lines of the mesh before"], ["Ctrl Z  Ctrl Shift Z", "undo, redo"], ["Ctrl S", "save the command"],
];

function addBenchKeys() {
  keys.unshift(...benchKeys);
  Object.assign(actions, { former: (page) => page.toggleFormer(), size: () => document.querySelector("#bench-size input").select() });
  Object.assign(keyActions, { b: "former", e: "size" });
}

/** Before the page's own keys: true, and nothing else happens, where a key is one of the workbench's. */
function onBenchKey(page, event) {
  const isText = event.target.matches("input[type=text]"), isDrawing = event.target === byId("overlay");
  const isLeft = event.key === "Escape" && event.target.closest("#bench-item");
  if (isLeft) byId("overlay").focus();
  const isHandled = event.ctrlKey || event.metaKey ? onControlKey(page, event, isText) : (isDrawing && onDrawingKey(page, event)) || (isLeft && leave(page));
  if (!isHandled) return;
  event.preventDefault();
  event.stopPropagation();
}

function onControlKey(page, event, isText) {
  const key = event.key.toLowerCase();
  if (key === "s") page.save("command");
  else if (isText && event.target.value !== event.target.defaultValue) return false; // the field's own undo
  else if (key === "z") page.step(event.shiftKey ? 1 : -1);
  else if (key === "y") page.step(1);
  else return false;
  return true;
}

function onDrawingKey(page, event) {
  const { item } = page, move = moves[event.key];
  if (event.key === "Tab") return page.chooseNext(event.shiftKey ? -1 : 1);
  if (event.key === "Escape") return leave(page);
  if (event.key === "Enter" && item) return openItem(page, event.shiftKey);
  if (!move || !item || item.kind === "curve") return false;
  if (item.kind === "corner") return move[1] ? !page.changeValence(item.number, Math.sign(move[1])) : false;
  const step = event.shiftKey ? 1 : 8;
  page.nudge(-Math.sign(move[0]) * step, -Math.sign(move[1]) * step);
  return true;
}

/** What is begun is given up, else what is chosen or selected. Then Tab leaves the drawing. */
function leave(page) {
  const isBegun = page.ghost || page.isBoxing || page.item || page.curves.size;
  if (page.ghost) page.ghost = null;
  else Object.assign(page, { isBoxing: false, box: null, item: null, curves: new Set() });
  page.showBench();
  page.drawOverlay();
  return Boolean(isBegun);
}

function openItem(page, isMore) {
  if (page.ghost) return page.dropGhost() || true;
  page.pick(page.item, isMore);
  if (!isMore) document.querySelector("#bench-item input, #bench-item button")?.focus();
  return true;
}
