// Chains of cubic pieces: boundary curves, separatrices, arcs, and blocks, which are closed and filled.

class Chains {
  constructor(json, step) {
    Object.assign(this, layerBase(json));
    this.style = json.style;
    this.offsets = intsOf(json.offsets);
    this.points = positionsOf(json.points, step);
    this.colours = json.colours ? intsOf(json.colours) : null;
    this.partners = json.partners ? intsOf(json.partners) : null;
    this.regions = json.regions || [];
    this.runs = json.runs ? intsOf(json.runs) : null; // of curves with one given name: the first; -1: no given name
    this.count = this.offsets.length - 1;
    this.isFilled = this.style === "block";
    this.isClosed = this.isFilled || this.style === "search";
    this.boxes = emptyBoxes(this.count);
    for (let i = 0; i < this.count; ++i)
      for (let k = this.offsets[i]; k < this.offsets[i + 1]; ++k)
        include(this.boxes, i, this.points[2 * k], this.points[2 * k + 1]);
  }

  trace(path, maps, item) {
    const [mx, my] = maps, p = this.points, end = 2 * this.offsets[item + 1];
    let k = 2 * this.offsets[item];
    path.moveTo(mx(p[k]), my(p[k + 1]));
    for (k += 2; k < end; k += 6)
      path.bezierCurveTo(mx(p[k]), my(p[k + 1]), mx(p[k + 2]), my(p[k + 3]), mx(p[k + 4]), my(p[k + 5]));
    if (this.isClosed) path.closePath();
  }

  /** Whether two regions meet in the curve, or both sides of a slit. */
  isInterface(item) {
    return this.partners !== null && this.partners[item] >= 0;
  }

  fill(context, view, theme) {
    if (!this.isFilled) return;
    const quantity = this.quantities[this.quantity], ramp = quantity && coloursOf(theme, quantity);
    for (const item of itemsWithin(this.boxes, view.rectangle())) {
      const at = quantity && rampPosition(quantity, quantity.values[item]);
      context.fillStyle = quantity ? css(ramp[Math.round(at * (ramp.length - 1))]) : theme.blocks[this.colours[item] % theme.blocks.length];
      context.fill(this.outline(view, item));
    }
  }

  stroke(context, view, theme) {
    if (this.isFilled) return;
    const maps = view.maps();
    context.lineWidth = { boundary: 2.2, line: 1.7, arc: 1.1, search: 0.8 }[this.style];
    for (const item of itemsWithin(this.boxes, view.rectangle())) {
      const colour = this.colours ? this.colours[item] : -1;
      context.strokeStyle = this.style === "line" && colour >= 0 && !theme.isAdded ? theme.lines[colour % theme.lines.length] : theme.border;
      if (this.isInterface(item)) context.strokeStyle = theme.interface || theme.border;
      context.beginPath();
      this.trace(context, maps, item);
      context.stroke();
    }
  }

  legend(theme) {
    if (this.style === "search") return [[this.title, legendLine(theme.border, 0.8)]];
    if (this.style === "line") return [["separatrices, a colour for each start", legendLine(theme.lines[0], 1.7)]];
    if (this.partners && this.partners.some((partner) => partner >= 0))
      return [["curve between regions, or slit", legendLine(theme.interface, 2.2)]];
    return [];
  }

  outline(view, item) {
    const path = new Path2D();
    this.trace(path, view.maps(), item);
    return path;
  }

  itemAt(context, view, px, py) {
    const slack = 6 / view.scale, [x, y] = view.toPlane(px, py);
    context.lineWidth = 10;
    for (const i of itemsWithin(this.boxes, [x - slack, y - slack, x + slack, y + slack])) {
      const path = this.outline(view, i);
      if (this.isClosed ? context.isPointInPath(path, px, py) : context.isPointInStroke(path, px, py)) return i;
    }
    return -1;
  }

  controls(item) {
    const controls = [];
    for (let k = this.offsets[item]; k < this.offsets[item + 1]; ++k)
      controls.push([this.points[2 * k], this.points[2 * k + 1]]);
    return controls;
  }

  heading(item) {
    const name = this.names[item] || "";
    if (!this.noun) return name;
    return this.style === "arc" ? `arc ${item}, ${name}` : `${this.noun} ${item}${nameSuffix(name, this.noun, item)}`;
  }

  sizes(item) {
    const points = flattened(this.controls(item), 8);
    return this.isClosed ? { area: areaOf(points), length: lengthOf(points) } : { length: lengthOf(points) };
  }

  /** The names of regions and of blocks, where each has most room: {text, at, clearance}. Blocks have their numbers
   *  where several have one name. */
  places(view) {
    const regions = this.regions.map(([text, x, y, clearance]) => ({ text, at: [x, y], clearance }));
    if (!this.isFilled) return regions;
    const isShared = (name) => this.names.indexOf(name) !== this.names.lastIndexOf(name);
    return itemsWithin(this.boxes, view.rectangle()).map((item) => {
      const name = this.givenName(item), text = name && !isShared(name) ? name : String(item);
      return { text, ...this.middleOf(item) };
    });
  }

  /** The point of a lattice in an item that is farthest from its outline, and its distance: {at, clearance}. */
  middleOf(item) {
    this.middles ||= new Map();
    if (!this.middles.has(item)) this.middles.set(item, roomiestPoint(flattened(this.controls(item), 4), this.boxes.subarray(4 * item, 4 * item + 4)));
    return this.middles.get(item);
  }

  /** Texts with the visible points of their curves: given names, each beside the longest of successive curves that have
   *  it, or with `all` the numbers and names of all curves. */
  curveLabels(view, all) {
    if (this.style !== "boundary") return [];
    const isLabelled = (item) => !this.isInterface(item) || this.partners[item] > item;
    const labels = itemsWithin(this.boxes, view.rectangle()).filter(isLabelled).map((item) => {
      const isSeen = ([x, y]) => x >= 0 && y >= 0 && x <= view.width && y <= view.height;
      const text = all || this.runs[item] >= 0 ? this.labelOf(item, all) : "";
      return { text, item, points: text ? evenlySpaced(this.screenPoints(view, item), 4, isSeen) : [] };
    }).filter(({ points }) => points.length > 1);
    if (all) return labels;
    const longest = new Map();
    for (const label of labels) {
      const run = this.runs[label.item], other = longest.get(run);
      if (!other || other.points.length < label.points.length) longest.set(run, label);
    }
    return [...longest.values()];
  }

  /** Both sides of an interface have one. */
  labelOf(item, all) {
    const first = this.isInterface(item) ? Math.min(item, this.partners[item]) : item;
    return all ? this.numberAndName(first) : this.names[item];
  }

  screenPoints(view, item) {
    return flattened(this.controls(item), 8).map(([x, y]) => view.toScreen(x, y));
  }

  /** The name; empty where it is made from the number. */
  givenName(item) {
    return nameSuffix(this.names[item] || "", this.noun, item) && this.names[item];
  }

  numberAndName(item) {
    const number = this.isInterface(item) ? `${item}/${this.partners[item]}` : item;
    return `${number} ${this.runs[item] >= 0 ? this.names[item] : ""}`.trim();
  }
}
