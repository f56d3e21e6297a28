// The workbench: a page whose curves, corners and nodes can be changed; each change is run by the server.

class Workbench extends BenchSelection {
  constructor(data) {
    super(data);
    this.history = new History(data.workbench.state);
    this.server = new BenchServer((isWaiting) => showWaiting(isWaiting));
    this.command = data.workbench.command;
    this.runReport = data.workbench.report || data.report || {};
    this.former = null; // {mesh, figures}: of the state before
    this.isFormerShown = false;
    this.adopt(this.sheets);
  }

  start() {
    buildBench(this); // first: it takes room from the drawing
    super.start();
    listenToBench(this);
    this.showBench();
    if (this.data.workbench.message) showFailure(this, this.data.workbench.message);
    this.savedState = this.state;
    addEventListener("beforeunload", (event) => this.state !== this.savedState && event.preventDefault());
    this.server.keepAlive(() => showFailure(this, this.server.unreachable().message));
  }

  get state() {
    return this.history.state;
  }
  get names() {
    return new CurveNames(this.state, this.boundary);
  }
  /** Two positions nearer than this are one. */
  get slack() {
    return 1e-6 * Math.max(this.data.width, this.data.height);
  }
  get added() {
    return this.isFormerShown && this.former ? [...super.added, this.former.mesh] : super.added;
  }

  /** Layers that are worked on: nodes and corners are shown over every stage. */
  adopt(sheets) {
    const layers = sheets.flatMap((sheet) => sheet.layers), points = sheets.find((sheet) => kindOf(sheet) === "corners");
    const ofPoints = (key) => points && points.layers.find((layer) => layer.key === key);
    this.boundary = layers.find((layer) => layer.key === "boundary");
    this.groups = new CurveGroups(this.boundary);
    [this.nodes, this.corners] = [ofPoints("nodes"), ofPoints("corners")];
    for (const layer of [this.nodes, this.corners]) if (layer) layer.isAdded = true;
    this.mesh = layers.find((layer) => layer.noun === "quad");
    this.meshFigures = figuresOfMesh(this.runReport, layers, this.nodes);
  }

  /** Something was done: `edit` changes the state, the server runs it. */
  commit(text, edit) {
    if (this.history.add(text, edit)) return this.run();
    this.ghost = null;
    this.drawOverlay();
  }
  /** Undo (-1) and redo (1). */
  step(by) {
    const text = by < 0 ? this.history.undoText : this.history.redoText;
    if (!this.history.move(by)) return this.tell(by < 0 ? "Nothing to undo." : "Nothing to redo.");
    this.tell(`${by < 0 ? "Undone" : "Done again"}: ${text}`);
    this.run();
  }

  async run() {
    const start = performance.now();
    this.showBench();
    const answer = await this.server.run(this.state);
    if (!answer) return;
    if (answer.command) this.command = answer.command;
    if (answer.ok) this.replace(answer);
    else showFailure(this, answer.message);
    if (this.ghost && this.ghost.isDropped) this.ghost = null; // not one that is dragged meanwhile
    this.showBench();
    this.drawOverlay();
    performance.measure("change to mesh", { start });
  }

  /** New data: the view, the chosen tab, layers and quantities stay. */
  replace({ page, report, warnings }) {
    const kept = new Map(this.sheets.flatMap((sheet) => sheet.layers.map((layer) => [`${kindOf(sheet)}/${layer.key}`, layer])));
    const kind = kindOf(this.sheet), { axes, zoom } = this.space, wasSpatial = this.isSpatial;
    this.former = this.mesh && { mesh: shifted(this.mesh, this.data, page), figures: this.meshFigures };
    this.view.x += this.data.x - page.x;
    this.view.y += this.data.y - page.y;
    Object.assign(this, { data: page, sheets: decodeSheets(page), runReport: report });
    this.adopt(this.sheets);
    for (const sheet of this.sheets)
      for (const layer of sheet.layers) keepChoices(layer, kept.get(`${kindOf(sheet)}/${layer.key}`));
    this.current = Math.max(0, this.sheets.findIndex((sheet) => kindOf(sheet) === kind));
    this.warnings = warnings || [];
    this.choose(this.isReport ? this.sheets.length : this.current);
    if (wasSpatial && this.isSpatial) this.keepTurn(axes, zoom);
    hideFailure();
  }

  keepTurn(axes, zoom) {
    Object.assign(this.space, { axes, zoom });
    this.drawSpace(false);
  }

  showBench() {
    const isKnown = ({ kind, number }) => number < (kind === "curve" ? this.boundary : this.layerOf(kind)).count;
    if (this.item && !isKnown(this.item)) this.item = null;
    fillBench(this);
  }

  layerOf(kind) {
    return { curve: this.boundary, corner: this.corners, node: this.nodes }[kind];
  }

  toggleFormer() {
    if (!this.former) return this.tell("There is no mesh before: change something first.");
    this.isFormerShown = !this.isFormerShown;
    this.drawSharp();
    fillFigures(this);
    this.tell(this.isFormerShown ? "Lines of the mesh before are shown over the new one." : "The new mesh alone is shown.");
  }

  async save(what) {
    const { state } = this, answer = await this.server.save(state, what);
    if (!answer.ok) return showFailure(this, answer.message);
    this.savedState = state;
    this.tell(`Saved ${answer.file}.`);
  }

  /** Where a node of the mesh that is shown is without moves, in the coordinates of the CAD file. */
  originOf(node) {
    const { position } = this.data.workbench.nodes[node], { moves } = this.data.workbench.state;
    const move = moves.find(({ to }) => awayFrom(to, position) < this.slack);
    return move ? move.node : position;
  }
  isMoved(node) {
    const origin = this.originOf(node);
    return this.state.moves.some((move) => awayFrom(move.node, origin) < this.slack);
  }
  /** A position of the view as one of the CAD file, in seven digits of the extent. */
  rounded([x, y]) {
    const step = 10 ** Math.floor(Math.log10(Math.max(this.data.width, this.data.height)) - 6);
    const round = (value) => Number((Math.round(value / step) * step).toPrecision(12));
    return [round(x + this.data.x), round(y + this.data.y)];
  }

  /** A node of the last mesh to a position of the CAD file; null: to where it was. */
  moveNodeTo(number, to) {
    const origin = this.originOf(number);
    this.commit(to ? "move of a node" : "node put back", (state) => moveNode(state, origin, to, this.slack));
  }

  /** The numbers of both curves at a corner, as texts. */
  curvesAt(corner) {
    return this.data.workbench.corners[corner].curves.map(String);
  }
  valenceOf(corner) {
    const prescribed = this.state.valences.find((known) => String(known.corner) === String(this.curvesAt(corner)));
    return prescribed ? prescribed.valence : this.corners.valences[corner];
  }
  /** Nodes are other ones then: their moves are given up. */
  prescribe(corner, valence, text) {
    this.commit(text, (state) => {
      setValence(state, this.curvesAt(corner), valence);
      state.moves = [];
    });
  }
  changeValence(corner, by) {
    const valence = Math.max(0, this.valenceOf(corner) + by);
    this.prescribe(corner, valence, `${valence} blocks at a corner`);
  }
}

/** The same stage has the same word in each answer, whatever its title. */
function kindOf(sheet) {
  const keys = sheet.layers.map((layer) => layer.key);
  return ["corners", "blocks", "lines", "field"].find((key) => keys.includes(key)) || sheet.layers.at(-1).noun;
}

function keepChoices(layer, before) {
  if (!before) return;
  const { isShown, isAdded } = before;
  Object.assign(layer, { isShown, isAdded, quantity: Math.min(before.quantity, layer.quantities.length - 1) });
}

/** A mesh as lines alone, in the frame of other data. */
function shifted(mesh, from, to) {
  const own = Object.assign(Object.create(Cells.prototype), mesh, { quantity: -1, isPlain: false });
  if (from.x === to.x && from.y === to.y) return own;
  own.vertices = mesh.vertices.map((value, i) => value + (i % 2 ? from.y - to.y : from.x - to.x));
  own.boxes = own.boxesOfElements();
  return own;
}
