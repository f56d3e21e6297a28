// The workbench: what the user did, as the server takes it (pipelines/quadbench.md), and its history.

/** States, each with the words for what led to it; the first is that of the command. */
class History {
  constructor(state) {
    this.steps = [{ state, text: "" }];
    this.at = 0;
  }
  get state() {
    return this.steps[this.at].state;
  }
  get undoText() {
    return this.steps[this.at].text;
  }
  get redoText() {
    return this.at + 1 < this.steps.length ? this.steps[this.at + 1].text : "";
  }
  /** A new state, from a copy that `edit` changes; what was undone is forgotten. False if nothing changed. */
  add(text, edit) {
    const state = structuredClone(this.state);
    edit(state);
    if (JSON.stringify(state) === JSON.stringify(this.state)) return false;
    this.steps.splice(++this.at, Infinity, { state, text });
    return true;
  }
  /** By -1 or 1; false at the ends. */
  move(by) {
    const to = this.at + by;
    if (to < 0 || to >= this.steps.length) return false;
    this.at = to;
    return true;
  }
}

/** Names of curves under a state: a name that was given here, else that of the last mesh, else the number. */
class CurveNames {
  constructor(state, boundary) {
    this.state = state;
    this.boundary = boundary;
  }
  /** The given name of a curve, or "". */
  nameOf(curve) {
    const entry = this.state.names.findLast((known) => (coveredBy(known) || []).includes(curve));
    return entry ? entry.name : this.madeNumber(curve) ? "" : this.boundary.names[curve];
  }
  /** The number from which the name of a curve without a given one was made; null for others. */
  madeNumber(curve) {
    const made = /^curve_(\d+)$/.exec(this.boundary.names[curve]);
    return made && made[1];
  }
  /** By what options mean the curve: its name, or the number of one without, which is that of its name curve_N. */
  keyOf(curve) {
    return this.nameOf(curve) || this.madeNumber(curve) || String(curve);
  }
  /** Whether curves that quadmesh embeds for layers with blocks of their own have changed the numbers. */
  get isRenumbered() {
    return this.boundary.names.some((name, curve) => name.endsWith("_offset") && this.boundary.isInterface(curve));
  }
  keysOf(curves) {
    return [...new Set([...curves].map((curve) => this.keyOf(curve)))];
  }
  curvesOf(key) {
    return [...this.boundary.names.keys()].filter((curve) => this.keyOf(curve) === key);
  }
}

/** The curves that an entry of names is for; undefined for a rule of the command line. */
const coveredBy = (entry) => entry.curves || entry.covers;

/** As the server takes it. */
function sentState(state) {
  return { ...state, names: state.names.map(({ covers, ...entry }) => entry) };
}

/** Names the curves; no curve may be in two entries. `rule`: what selected exactly these, or "". Sizes and layers of
 *  keys that are no more go to the name. An empty name takes those given here away. */
function nameCurves(state, curves, name, rule, boundary) {
  const before = new CurveNames(structuredClone(state), boundary), isTaken = (curve) => curves.has(curve);
  state.names = state.names.flatMap((entry) => {
    const own = coveredBy(entry) || before.curvesOf(entry.name);
    if (!own.some(isTaken)) return [entry];
    const rest = own.filter((curve) => !isTaken(curve));
    return rest.length ? [{ curves: rest, name: entry.name }] : [];
  });
  const sorted = [...curves].sort((a, b) => a - b), same = !rule && state.names.find((entry) => entry.curves && entry.name === name);
  if (same) same.curves = [...same.curves, ...curves].sort((a, b) => a - b);
  else if (name) state.names.push(rule ? { selector: rule, name, covers: sorted } : { curves: sorted, name });
  for (const key of before.keysOf(curves).filter((old) => before.curvesOf(old).every(isTaken)))
    for (const table of [state.near, state.walls]) replaceKey(table, key, name ? [name] : before.curvesOf(key).map(String));
}

/** What a key has goes to keys that have nothing. */
function replaceKey(table, from, keys) {
  if (keys.includes(from) || !(from in table)) return;
  for (const key of keys) table[key] ??= table[from];
  delete table[from];
}

/** Sets or, if `value` is null, removes. */
function setKey(table, key, value) {
  if (value === null) delete table[key];
  else table[key] = value;
}

/** "first=0.01,growth=1.2" as an object; order and unknown members stay. */
function wallMembers(text) {
  return Object.fromEntries((text || "").split(",").filter(Boolean).map((part) => part.split("=")));
}

/** The layers with these members changed; null without any. */
function wallText(before, changes) {
  const members = { ...wallMembers(before), ...changes };
  const parts = Object.entries(members).filter(([, value]) => value !== "").map(([key, value]) => `${key}=${value}`);
  return parts.length ? parts.join(",") : null;
}

function setValence(state, corner, valence) {
  state.valences = state.valences.filter((known) => String(known.corner) !== String(corner));
  if (valence !== null) state.valences.push({ corner, valence });
}

const awayFrom = ([ax, ay], [bx, by]) => Math.hypot(ax - bx, ay - by);

/** Moves a node, which is at `origin` without moves; to null: back there. */
function moveNode(state, origin, to, slack) {
  state.moves = state.moves.filter((move) => awayFrom(move.node, origin) >= slack);
  if (to !== null) state.moves.push({ node: origin, to });
}
