// The page at work: its state, and what keys, pointer and buttons change in it.

class Page extends SpacePage {
  constructor(data) {
    super();
    this.data = data;
    this.sheets = decodeSheets(data);
    this.sheets.isComparison = data.comparison;
    this.current = data.comparison ? 0 : this.sheets.length - 1;
    this.scenes = [new Scene(byId("picture"), byId("overlay")), new Scene(byId("picture-b"), byId("overlay-b"))];
    this.space = new SpacePane(byId("space"), () => this.spaceMoved(), (x, y) => this.pointInSpace(x, y));
    this.isBeside = data.comparison;
    this.isReport = false;
    this.pointer = null; // {pane, at}: the pane that the pointer is over, and where in the plane
    this.view = new View(1, 1);
    this.focus = null;
    this.isPinned = false;
    this.labels = "given";
    this.rank = -1;
    this.setTheme(matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
    this.timer = 0;
  }

  get sheet() {
    return this.sheets[this.current];
  }
  /** The layers of other stages that are added to this one, below its own. */
  get added() {
    const others = this.sheets.filter((sheet) => sheet !== this.sheet);
    return others.flatMap((sheet) => sheet.layers.filter((layer) => layer.isAdded));
  }
  get shown() {
    return this.shownIn(this.current);
  }
  /** The layers of a pane: side by side, each has those of its own stage. */
  shownIn(pane) {
    const isShown = (layer) => layer.isShown && !(layer instanceof Solids);
    if (this.isBeside) return this.sheets[pane].layers.filter(isShown);
    return [...this.added, ...this.sheet.layers.filter(isShown)];
  }
  /** The visible panes: numbers of scenes. */
  get panes() {
    return this.isBeside ? [0, 1] : [0];
  }
  get limits() {
    const fit = Math.min(this.view.width / this.data.width, this.view.height / this.data.height);
    return [fit / 20, fit * 1e6];
  }

  start() {
    byId("title").textContent = this.data.title;
    fillHelp();
    document.querySelector("[data-do=beside]").hidden = !this.data.comparison;
    listenToCut(this);
    document.querySelector("[data-do=body]").hidden = !this.data.body;
    this.resize();
    this.firstView();
    this.choose(this.current);
    listen(this);
  }

  resize() {
    byId("window").classList.toggle("beside", this.isBeside);
    byId("picture-b").parentElement.hidden = !this.isBeside;
    byId("window").classList.toggle("spatial", this.isSpatial);
    byId("window").classList.toggle("alone", this.isAlone);
    byId("space").hidden = byId("cut").hidden = !this.isSpatial;
    const { clientWidth, clientHeight } = byId("picture").parentElement;
    this.view.resize(clientWidth, clientHeight);
    for (const scene of this.scenes) scene.resize(clientWidth, clientHeight);
    const width = this.isAlone ? byId("window").clientWidth : clientWidth;
    if (this.isSpatial) this.space.resize(width, clientHeight, this.scenes[0].ratio);
  }

  /** Tabs are the stages and, behind them, the report of the run if there is one. */
  get tabCount() {
    return this.sheets.length + (this.data.report ? 1 : 0);
  }
  get tab() {
    return this.isReport ? this.sheets.length : this.current;
  }

  choose(number) {
    const chosen = (number + this.tabCount) % this.tabCount;
    this.isReport = chosen === this.sheets.length;
    const wasSpatial = this.isSpatial, wasAlone = this.isAlone;
    if (!this.isReport) this.current = chosen;
    if (this.isSpatial) this.space.set(this.sheet.space);
    if (this.isSpatial !== wasSpatial || this.isAlone !== wasAlone) {
      this.resize();
      this.firstView();
    }
    this.forget();
    byId("report").hidden = !this.isReport;
    showTabs(this.sheets, this.tab, (i) => this.choose(i), Boolean(this.data.report));
    if (this.isReport) return fillReport(this.data, this.sheets, this.theme);
    showFacts(this.sheet);
    if (this.data.comparison) showComparison(this.sheets);
    showLayers(this.sheet.layers, () => this.changed());
    showOthers(this.sheets, this.current, () => this.changed());
    this.changed();
  }

  /** Layers, quantity or theme changed: everything is drawn anew. */
  changed() {
    this.rank = -1;
    if (this.isBeside) this.copyLayers();
    showMeasure(this.sheet.layers, this.theme);
    showLegend(this.shown, this.theme);
    if (this.isReport) fillReport(this.data, this.sheets, this.theme);
    this.drawSharp();
  }

  drawSharp() {
    clearTimeout(this.timer);
    this.timer = 0;
    const added = new Set(this.isBeside ? [] : this.added);
    for (const pane of this.panes)
      this.scenes[pane].drawSharp(this.view, this.theme, this.shownIn(pane), added);
    this.drawSpace(false);
    this.drawOverlay();
  }

  drawOverlay() {
    for (const pane of this.panes) {
      const layers = this.shownIn(pane);
      const focus = this.focus && layers.includes(this.focus.layer) ? this.focus : null;
      const title = this.isBeside && tabTitles(this.sheets)[pane];
      const cross = this.isBeside && this.pointer && this.pointer.pane !== pane && this.pointer.at;
      const extras = { focus, labels: this.labels, title, cross };
      this.scenes[pane].drawOverlay(this.view, this.theme, this.data, layers, extras);
    }
    if (this.isPinned) this.placeTip(...this.focusPoint());
  }

  /** The view moved: the last picture moves with it; a sharp one follows when it rests, or at once if it is quick. */
  moved() {
    if (this.isAlone) return this.spaceMoved();
    if (!this.isPinned) this.forget();
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => {
      if (this.panes.every((pane) => this.scenes[pane].sharpTime < 12)) return this.drawSharp();
      for (const pane of this.panes) this.scenes[pane].show(this.view, this.theme);
      this.drawOverlay();
      clearTimeout(this.timer);
      this.timer = setTimeout(() => this.drawSharp(), 120);
    });
  }

  fit() {
    const { width, height } = this.data;
    this.view.fit(-width / 2, -height / 2, width / 2, height / 2, 64);
  }

  /** What is in a far field, with as much around it; without one, everything. */
  firstView() {
    if (!this.data.body) return this.fit();
    this.view.fit(...this.data.body, Math.min(this.view.width, this.view.height) / 4);
  }

  showBody() {
    if (!this.data.body) return this.tell("No body lies in a far field here: 0 shows everything.");
    this.firstView();
    this.drawSharp();
  }

  setTheme(name) {
    this.theme = themeNamed(name, this.data.palettes);
  }

  forget() {
    this.focus = null;
    this.isPinned = false;
    byId("tip").hidden = true;
  }

  showReport() {
    if (!this.data.report) return this.tell("This page has no report: quadmesh --html writes one.");
    this.choose(this.isReport ? this.current : this.sheets.length);
  }

  /** The other stage shows the layers and quantities of the chosen one, where it has them. */
  copyLayers() {
    const others = this.sheets[1 - this.current].layers;
    for (const { key, isShown, quantity } of this.sheet.layers)
      for (const other of others.filter((layer) => layer.key === key))
        Object.assign(other, { isShown, quantity: Math.min(quantity, other.quantities.length - 1) });
  }

  /** Side by side, or the lines of one over the other. */
  toggleBeside() {
    if (!this.data.comparison) return this.tell("Only a page of --compare has two stages to show side by side.");
    this.isBeside = !this.isBeside;
    this.resize();
    this.firstView();
    this.changed();
  }

  /** Shows the item under the pointer. */
  point(px, py, pane = 0) {
    const [x, y] = this.view.toPlane(px, py);
    byId("place").textContent = this.positionText(x, y);
    this.pointer = { pane, at: [x, y] };
    this.mark(-1);
    const layers = this.shownIn(pane);
    const found = this.scenes[pane].itemAt(this.view, layers, px, py);
    this.forget();
    this.focus = found;
    if (found) this.showTip(px, py);
    this.drawOverlay();
  }

  /** In the coordinates of the CAD file, to a pixel. */
  positionText(x, y) {
    const pixel = roundStep(1 / this.view.scale), text = (value) => tickText(value, pixel);
    return `${text(x + this.data.x)}, ${text(y + this.data.y)} ${this.data.unit}`;
  }

  showTip(px, py) {
    const { layer, item } = this.focus;
    const figures = element("table", {}, ...tableRows(this.figures()));
    byId("tip").replaceChildren(element("strong", {}, layer.heading(item)), figures);
    byId("tip").hidden = false;
    this.placeTip(px, py);
  }

  /** Size and quality of the item in focus. */
  figures() {
    const { layer, item } = this.focus, unit = this.data.unit, sizes = layer.sizes(item), rows = [];
    if (sizes.at) rows.push(["position", this.positionText(...sizes.at)]);
    if (sizes.least !== undefined) rows.push(["sides", `${figure(sizes.least)} to ${figure(sizes.greatest)} ${unit}`]);
    const whole = layer.isClosed ? "perimeter" : "length";
    if (sizes.length !== undefined) rows.push([whole, `${figure(sizes.length)} ${unit}`]);
    if (sizes.area !== undefined) rows.push(["area", `${figure(sizes.area)} ${unit && unit + "²"}`]);
    for (const quantity of layer.quantities) rows.push([quantity.title, figure(quantity.values[item])]);
    return rows;
  }

  placeTip(px, py) {
    const tip = byId("tip"), { clientWidth: width, clientHeight: height } = byId("window");
    if (this.isBeside && this.focus && this.sheets[1].layers.includes(this.focus.layer)) px += width / 2;
    const x = px + 18 + tip.offsetWidth > width ? px - 18 - tip.offsetWidth : px + 18;
    const y = py + 18 + tip.offsetHeight > height ? py - 18 - tip.offsetHeight : py + 18;
    tip.style.left = `${Math.max(4, x)}px`;
    tip.style.top = `${Math.max(4, y)}px`;
  }

  focusPoint() {
    if (this.focus.layer instanceof Solids) return this.space.placeOf(this.focus.item);
    const [x0, y0, x1, y1] = this.boxOf(this.focus);
    return this.view.toScreen((x0 + x1) / 2, (y0 + y1) / 2);
  }

  boxOf({ layer, item }) {
    if (layer.boxes) return layer.boxes.subarray(4 * item, 4 * item + 4);
    const [x, y] = layer.points.subarray(2 * item, 2 * item + 2);
    return [x, y, x, y];
  }

  /** Zooms to an item and pins its figures. */
  goTo(layer, item) {
    this.focus = { layer, item };
    if (layer instanceof Solids) return this.goToSolid(item);
    const [x0, y0, x1, y1] = this.boxOf(this.focus);
    const size = Math.max(x1 - x0, y1 - y0) || Math.max(this.data.width, this.data.height) / 10;
    this.view.fit((x0 + x1 - size) / 2, (y0 + y1 - size) / 2, (x0 + x1 + size) / 2, (y0 + y1 + size) / 2, 0);
    this.view.scale = Math.min(this.view.scale / 7, this.limits[1]);
    this.isPinned = true;
    this.showTip(...this.focusPoint());
    this.drawSharp();
    byId("status").textContent = layer.heading(item);
  }

  worst(step) {
    const layer = measuredLayer(this.sheet.layers);
    if (!layer) return this.tell("This stage has no quality: choose another one.");
    const quantity = layer.quantities[Math.max(0, layer.quantity)], count = quantity.order.length;
    this.rank = (this.rank + step + count) % count;
    this.goTo(layer, quantity.order[this.rank]);
    this.tell(`${layer.heading(quantity.order[this.rank])}: number ${this.rank + 1} from the worst, ${quantity.title}`);
  }

  nextQuantity(step) {
    const layer = measuredLayer(this.sheet.layers);
    if (!layer) return;
    layer.quantity = ((layer.quantity + 1 + step + layer.quantities.length + 1) % (layer.quantities.length + 1)) - 1;
    showLayers(this.sheet.layers, () => this.changed());
    this.changed();
  }

  find(text) {
    const wanted = text.trim().toLowerCase();
    if (!wanted) return;
    const layers = this.isAlone ? [this.spatialLayer] : [...this.shown].reverse();
    const number = /^\d+$/.test(wanted) ? Number(wanted) : -1;
    const numbered = layers.find((layer) => (layer.boxes || layer instanceof Solids) && number >= 0 && number < layer.count);
    if (numbered) return this.goTo(numbered, number);
    for (const layer of layers) {
      const item = layer.names.findIndex((name) => name.toLowerCase().includes(wanted));
      if (item >= 0) return this.goTo(layer, item);
    }
    this.tell(`Nothing that is shown has the number or name ${text.trim()}.`);
  }

  tell(text) {
    byId("status").textContent = text;
  }
}

function start() {
  new Page(JSON.parse(byId("data").textContent)).start();
}
