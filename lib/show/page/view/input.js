// Keys, pointer and buttons.

const moves = { ArrowLeft: [60, 0], ArrowRight: [-60, 0], ArrowUp: [0, 60], ArrowDown: [0, -60] };

const actions = {
  fit: (page) => {
    page.fit();
    if (page.isSpatial) page.space.fit();
    page.drawSharp();
  },
  body: (page) => page.showBody(),
  worst: (page) => page.worst(1),
  back: (page) => page.worst(-1),
  labels: (page) => {
    page.labels = { given: "all", all: "none", none: "given" }[page.labels];
    page.drawOverlay();
  },
  report: (page) => page.showReport(),
  beside: (page) => page.toggleBeside(),
  theme: (page) => {
    page.setTheme(page.theme.name === "dark" ? "light" : "dark");
    page.changed();
  },
  help: () => (byId("help").hidden = !byId("help").hidden),
  find: () => byId("find-text").focus(),
  panel: (page) => {
    document.querySelector("aside").hidden = !document.querySelector("aside").hidden;
    page.resize();
    page.drawSharp();
  },
  quantity: (page) => page.nextQuantity(1),
  quantityBack: (page) => page.nextQuantity(-1),
  close: (page) => {
    byId("help").hidden = true;
    page.forget();
    page.drawOverlay();
  },
  cut: (page) => page.chooseCut(page.space.cut.along + 1),
  cutBack: (page) => page.chooseCut(page.space.cut.along - 1),
  cutDown: (page) => page.moveCut(-0.01),
  cutUp: (page) => page.moveCut(0.01),
  cutSide: (page) => {
    page.space.cut.sign *= -1;
    page.moveCut(0);
  },
  next: (page) => page.choose(page.tab + 1),
  before: (page) => page.choose(page.tab - 1),
};

const keyActions = {
  0: "fit", v: "body", w: "worst", W: "back", l: "labels", t: "theme", "?": "help", f: "find", p: "panel", q: "quantity",
  Q: "quantityBack", Escape: "close", s: "beside", r: "report", "]": "next", "[": "before",
  c: "cut", C: "cutBack", ",": "cutDown", ".": "cutUp", x: "cutSide",
};

function listen(page) {
  document.addEventListener("keydown", (event) => onKey(page, event));
  for (const button of document.querySelectorAll("[data-do]"))
    button.addEventListener("click", () => actions[button.dataset.do](page));
  byId("find").addEventListener("submit", (event) => {
    event.preventDefault();
    page.find(byId("find-text").value);
    byId("overlay").focus();
  });
  new ResizeObserver(() => {
    page.resize();
    page.drawSharp();
  }).observe(byId("window"));
  listenToPointer(page, byId("overlay"), 0);
  listenToPointer(page, byId("overlay-b"), 1);
}

function onKey(page, event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.target.matches("input[type=text], select") && event.key !== "Escape") return;
  if (event.target.matches("input[type=range]") && moves[event.key]) return;
  if (event.key === "Escape") event.target.blur();
  const action = keyActions[event.key];
  if (action) actions[action](page);
  else if (moves[event.key]) page.pan(...moves[event.key]);
  else if (event.key === "+" || event.key === "=") page.zoomBy(1.4);
  else if (event.key === "-") page.zoomBy(1 / 1.4);
  else if (/^[1-9]$/.test(event.key) && event.key <= page.tabCount) page.choose(event.key - 1);
  else return;
  event.preventDefault();
  if (!action && !/^[1-9]$/.test(event.key)) page.moved();
}

/** Drag, wheel and pinch. */
function listenToPointer(page, canvas, pane) {
  const pointers = new Map();
  const position = (event) => [event.offsetX, event.offsetY];
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, position(event));
    canvas.classList.add("moving");
  });
  canvas.addEventListener("pointermove", (event) => {
    const now = position(event);
    if (!pointers.has(event.pointerId)) return page.point(...now, pane);
    drag(page, pointers, event.pointerId, now);
  });
  const release = (event) => {
    pointers.delete(event.pointerId);
    canvas.classList.toggle("moving", pointers.size > 0);
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("pointerleave", () => {
    page.pointer = null;
    if (page.isPinned) return;
    page.forget();
    page.drawOverlay();
  });
  canvas.addEventListener("dblclick", (event) => {
    page.view.zoom(2.5, ...position(event), page.limits);
    page.moved();
  });
  const onWheel = (event) => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 24 : 1;
    page.view.zoom(Math.exp(-0.0018 * lines * event.deltaY), ...position(event), page.limits);
    page.moved();
  };
  canvas.addEventListener("wheel", onWheel, { passive: false });
}

/** One pointer moves the drawing, two also zoom it. */
function drag(page, pointers, id, now) {
  const before = pointers.get(id), other = [...pointers].find(([key]) => key !== id);
  pointers.set(id, now);
  if (other) {
    const [x, y] = other[1];
    const factor = Math.hypot(now[0] - x, now[1] - y) / Math.max(1, Math.hypot(before[0] - x, before[1] - y));
    page.view.zoom(factor, x, y, page.limits);
  } else {
    page.view.pan(now[0] - before[0], now[1] - before[1]);
  }
  page.moved();
}
