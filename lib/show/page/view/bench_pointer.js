// The workbench: the pointer selects curves and corners, drags nodes, and draws boxes; all else moves the view.

/** The item of the workbench under the pointer: a node, else a corner, else a curve; null without one. */
function benchItemAt(page, px, py) {
  if (page.isReport || page.isAlone || page.isBeside) return null;
  const probe = page.scenes[0].probe, shown = page.shown;
  for (const kind of ["node", "corner", "curve"]) {
    const layer = page.layerOf(kind);
    if (!layer || !shown.some(({ key }) => key === layer.key)) continue; // each stage has a boundary of its own
    const number = layer.itemAt(probe, page.view, px, py);
    if (number >= 0 && (kind !== "node" || layer.kinds[number] === "node")) return { kind, number: kind === "curve" ? page.groups.lower(number) : number };
  }
  return null;
}

/** Listens before the page does (in the capturing phase): what it handles does not move the view. */
function listenToBench(page) {
  const pane = byId("overlay").parentElement;
  let pressed = null; // {at, item}: where the pointer went down, and on what
  const on = (type, handle) => pane.addEventListener(type, (event) => handle(event, [event.offsetX, event.offsetY]), { capture: true });
  on("pointerdown", (event, at) => {
    pressed = event.isPrimary && event.button === 0 ? { at, item: benchItemAt(page, ...at) } : null;
    if (!pressed) return;
    page.ghost = null; // of the keyboard
    pressed.isHeld = page.isBoxing || (pressed.item && pressed.item.kind === "node");
    if (!pressed.isHeld) return;
    event.stopPropagation();
    event.target.setPointerCapture(event.pointerId);
    byId("overlay").focus({ preventScroll: true });
  });
  on("pointermove", (event, at) => {
    if (!pressed) return showCursor(page, event.target, at);
    if (!pressed.isHeld) return;
    event.stopPropagation();
    dragItem(page, pressed, at);
  });
  on("pointerup", (event, at) => {
    if (pressed) releaseItem(page, pressed, at, event.shiftKey);
    pressed = null;
  });
  on("pointercancel", () => {
    pressed = page.ghost = page.box = null;
    page.drawOverlay();
  });
  document.addEventListener("keydown", (event) => onBenchKey(page, event), { capture: true });
}

function showCursor(page, canvas, at) {
  const item = page.isBoxing ? null : benchItemAt(page, ...at);
  canvas.style.cursor = page.isBoxing ? "crosshair" : item ? (item.kind === "node" ? "move" : "pointer") : "";
}

const hasMoved = (a, b) => awayFrom(a, b) > 4;

function dragItem(page, { at, item }, now) {
  if (page.isBoxing) page.box = [page.view.toPlane(...at), page.view.toPlane(...now)];
  else if (hasMoved(at, now) || page.ghost) page.ghost = { number: item.number, at: page.view.toPlane(...now) };
  page.forget();
  cancelAnimationFrame(page.benchFrame);
  page.benchFrame = requestAnimationFrame(() => page.drawOverlay());
}

function releaseItem(page, { at, item, isHeld }, now, isMore) {
  if (page.isBoxing && isHeld) return page.selectBox(isMore);
  if (page.ghost && isHeld) return page.dropGhost();
  if (hasMoved(at, now)) return;
  page.pick(item, isMore);
}
