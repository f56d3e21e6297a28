// The workbench: what is selected and chosen, and how it is drawn over the picture.

class BenchSelection extends Page {
  constructor(data) {
    super(data);
    this.curves = new Set(); // selected
    this.rule = null; // {text, curves}: what selected them
    this.item = null; // {kind: "curve", "corner" or "node", number}: chosen
    this.ghost = null; // {number, at, isDropped}: where a node is dragged to
    this.box = null; // two corners, while it is dragged
    this.isBoxing = false;
  }

  /** Selects curves; `rule`: the words by which options select the same. */
  select(curves, rule = "") {
    this.curves = new Set(curves);
    this.rule = rule ? { text: rule, curves: new Set(curves) } : null;
    if (this.item && curves.length && !(this.item.kind === "curve" && this.curves.has(this.item.number))) this.item = null;
    this.showBench();
    this.drawOverlay();
    if (curves.length > 1) this.tell(`${curves.length} curves are selected.`);
  }

  /** A click or Enter on an item, null beside all; `isMore`: curves are added to the selection or taken out of it. */
  pick(item, isMore) {
    this.item = item;
    if (item && item.kind === "curve") {
      const curves = new Set(isMore ? this.curves : []);
      if (isMore && curves.has(item.number)) curves.delete(item.number);
      else curves.add(item.number);
      return this.select([...curves]);
    }
    if (item || !isMore) this.select([]); // beside all with Shift: a slip
  }

  selectTangent() {
    this.select(this.groups.tangentTo([...this.curves][0]));
  }

  selectBelow(text) {
    const diameter = Number(text), curves = diameter > 0 ? this.groups.circlesBelow(diameter) : [];
    if (curves.length) return this.select(curves, `circles(<${diameter})`);
    this.tell(`No circle has a diameter below ${text}.`);
  }

  /** The curves in the dragged box, whose corners are rounded first: options have the same numbers. */
  selectBox(isMore) {
    const box = this.box;
    this.box = null;
    this.isBoxing = false;
    if (!box) return this.showBench();
    const [a, b] = box.map((corner) => this.rounded(corner));
    const ends = [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.max(a[0], b[0]), Math.max(a[1], b[1])];
    const { x, y } = this.data, curves = this.groups.inBox([ends[0] - x, ends[1] - y, ends[2] - x, ends[3] - y]);
    if (isMore) this.select([...new Set([...this.curves, ...curves])]);
    else this.select(curves, `box(${ends.join(",")})`);
    if (!curves.length) this.tell("No curve lies in the box as a whole.");
  }

  /** The keyboard's way through all items: curves, corners, nodes; false at the end. */
  chooseNext(by) {
    const inner = (this.nodes ? [...this.nodes.kinds.keys()] : []).filter((i) => this.nodes.kinds[i] === "node");
    const all = [
      ...this.groups.all.map((number) => ({ kind: "curve", number })),
      ...(this.corners ? [...this.corners.kinds.keys()] : []).map((number) => ({ kind: "corner", number })),
      ...inner.map((number) => ({ kind: "node", number })),
    ];
    const is = ({ kind, number }) => this.item && kind === this.item.kind && number === this.item.number;
    const now = all.findIndex(is), next = now < 0 ? (by > 0 ? 0 : all.length - 1) : now + by;
    this.ghost = null;
    this.item = all[next] || null;
    this.drawOverlay();
    if (this.item) this.tell(this.layerOf(this.item.kind).heading(this.item.number));
    return Boolean(this.item);
  }

  /** Moves the chosen node's ghost by pixels. */
  nudge(dx, dy) {
    const { number } = this.item, from = this.ghost ? this.ghost.at : [...this.nodes.points.subarray(2 * number, 2 * number + 2)];
    this.ghost = { number, at: [from[0] + dx / this.view.scale, from[1] - dy / this.view.scale] };
    this.drawOverlay();
    this.tell(`node to ${this.positionText(...this.ghost.at)}: Enter moves it, Escape leaves it`);
  }

  dropGhost() {
    this.ghost.isDropped = true;
    this.item = { kind: "node", number: this.ghost.number };
    this.curves = new Set();
    this.moveNodeTo(this.ghost.number, this.rounded(this.ghost.at));
  }

  drawOverlay() {
    super.drawOverlay();
    if (this.isBeside || this.isAlone || !this.groups) return;
    const { scenes, view, theme } = this, context = scenes[0].overlay.getContext("2d");
    const isRinged = this.item && this.layerOf(this.item.kind) && !(this.item.kind === "curve" && this.curves.has(this.item.number));
    for (const curve of this.curves) strokeHaloed(context, theme, this.boundary.outline(view, curve), 3.5);
    if (isRinged) strokeHaloed(context, theme, ringOf(this, this.item), 2);
    if (this.ghost) drawGhost(context, this);
    if (this.box) drawBox(context, this);
  }
}

function strokeHaloed(context, theme, path, width) {
  for (const [extra, colour] of [[3, theme.halo], [0, theme.accent]]) {
    context.lineWidth = width + extra;
    context.strokeStyle = colour;
    context.stroke(path);
  }
}

/** A ring about a mark; of a curve its middle. */
function ringOf(page, { kind, number }) {
  const path = new Path2D(), layer = page.layerOf(kind);
  const curve = kind === "curve" ? page.groups.curves[number] : null;
  const [x, y] = curve ? curve[curve.length >> 1] : layer.points.subarray(2 * number, 2 * number + 2), at = page.view.toScreen(x, y);
  path.arc(...at, kind === "node" ? 15 : 10, 0, 2 * Math.PI);
  return path;
}

/** The node where it would go, with a line from where it is. */
function drawGhost(context, { view, theme, nodes, ghost }) {
  const from = view.toScreen(...nodes.points.subarray(2 * ghost.number, 2 * ghost.number + 2)), to = view.toScreen(...ghost.at);
  const line = new Path2D(), mark = new Path2D();
  line.moveTo(...from);
  line.lineTo(...to);
  mark.arc(...to, 9, 0, 2 * Math.PI);
  context.setLineDash([5, 4]);
  strokeHaloed(context, theme, line, 1.6);
  context.setLineDash([]);
  context.fillStyle = theme.paper;
  context.fill(mark);
  strokeHaloed(context, theme, mark, 2);
}

function drawBox(context, { view, theme, box }) {
  const [a, b] = box.map((corner) => view.toScreen(...corner)), path = new Path2D();
  path.rect(a[0], a[1], b[0] - a[0], b[1] - a[1]);
  context.setLineDash([6, 4]);
  strokeHaloed(context, theme, path, 1.6);
  context.setLineDash([]);
}
