// Elements: vertices, sides as cubic pieces relative to their chords, three or four sides for each element.

class Cells {
  constructor(json, step) {
    Object.assign(this, layerBase(json));
    this.isPlain = json.plain; // with a pale fill where no quantity is shown
    this.sides = json.sides;
    this.vertices = positionsOf(json.vertices, step);
    this.ends = intsOf(json.ends);
    this.elements = intsOf(json.elements);
    this.pieces = bytesOf(json.pieces);
    this.bends = shortsOf(json.bends);
    this.blocks = json.blocks ? intsOf(json.blocks) : null;
    this.blockNames = json.blockNames || [];
    this.count = this.elements.length / this.sides;
    this.bendStarts = this.startsOfBends();
    this.boxes = this.boxesOfElements();
    this.borders = this.blocks ? this.bordersOfBlocks() : [];
    this.stamps = new Uint32Array(this.pieces.length);
    this.stamp = 0;
  }

  startsOfBends() {
    const starts = new Uint32Array(this.pieces.length);
    for (let e = 0, at = 0; e < starts.length; ++e) {
      starts[e] = at;
      if (this.pieces[e]) at += 6 * this.pieces[e] - 2;
    }
    return starts;
  }

  /** Control point k of a curved side, in the plane. */
  control(edge, k, to) {
    const { ends, vertices, bends } = this;
    const a = 2 * ends[2 * edge], b = 2 * ends[2 * edge + 1], z = this.bendStarts[edge] + 2 * k;
    const dx = vertices[b] - vertices[a], dy = vertices[b + 1] - vertices[a + 1];
    const re = bends[z] / 8192, im = bends[z + 1] / 8192;
    to[0] = vertices[a] + re * dx - im * dy;
    to[1] = vertices[a + 1] + re * dy + im * dx;
    return to;
  }

  boxesOfElements() {
    const boxes = emptyBoxes(this.count), point = [0, 0];
    for (let i = 0; i < this.elements.length; ++i) {
      const edge = Math.abs(this.elements[i]) - 1, item = Math.floor(i / this.sides);
      for (const v of [this.ends[2 * edge], this.ends[2 * edge + 1]])
        include(boxes, item, this.vertices[2 * v], this.vertices[2 * v + 1]);
      for (let k = 0; k < 3 * this.pieces[edge] - 1; ++k) {
        this.control(edge, k, point);
        include(boxes, item, point[0], point[1]);
      }
    }
    return boxes;
  }

  /** Sides between two blocks, and of the boundary. */
  bordersOfBlocks() {
    const seen = new Int32Array(this.pieces.length).fill(-1), isInner = new Uint8Array(this.pieces.length);
    for (let i = 0; i < this.elements.length; ++i) {
      const edge = Math.abs(this.elements[i]) - 1, block = this.blocks[Math.floor(i / this.sides)];
      if (seen[edge] === block) isInner[edge] = 1;
      else seen[edge] = block;
    }
    return Array.from(seen.keys()).filter((edge) => !isInner[edge]);
  }

  /** The corners of an element, each where its side starts: numbers of vertices. */
  corner(item, k) {
    const side = this.elements[item * this.sides + k];
    return side > 0 ? this.ends[2 * side - 2] : this.ends[-2 * side - 1];
  }

  /** Appends a side to a path that is at its start; `isBackwards`: from its end to its start. */
  traceSide(path, maps, edge, isBackwards, isCoarse) {
    const [mx, my] = maps, pieces = isCoarse ? 0 : this.pieces[edge];
    const target = 2 * this.ends[2 * edge + (isBackwards ? 0 : 1)];
    const x = mx(this.vertices[target]), y = my(this.vertices[target + 1]);
    if (!pieces) return path.lineTo(x, y);
    const last = 3 * pieces - 2, p = [0, 0];
    for (let i = 0; i < pieces; ++i) {
      const points = [];
      for (let j = 0; j < 3; ++j) {
        const k = isBackwards ? last - 3 * i - j : 3 * i + j;
        const isTarget = i === pieces - 1 && j === 2;
        if (!isTarget) this.control(edge, k, p);
        points.push(isTarget ? x : mx(p[0]), isTarget ? y : my(p[1]));
      }
      path.bezierCurveTo(...points);
    }
  }

  traceElement(path, maps, item, isCoarse) {
    const start = 2 * this.corner(item, 0);
    path.moveTo(maps[0](this.vertices[start]), maps[1](this.vertices[start + 1]));
    for (let k = 0; k < this.sides; ++k) {
      const side = this.elements[item * this.sides + k];
      this.traceSide(path, maps, Math.abs(side) - 1, side < 0, isCoarse);
    }
    path.closePath();
  }

  traceEdge(path, maps, edge, isCoarse) {
    const start = 2 * this.ends[2 * edge];
    path.moveTo(maps[0](this.vertices[start]), maps[1](this.vertices[start + 1]));
    this.traceSide(path, maps, edge, false, isCoarse);
  }

  /** Items of each colour of the ramp. */
  binned(items, theme) {
    const quantity = this.quantities[this.quantity], colours = coloursOf(theme, quantity), last = colours.length - 1;
    const bins = Array.from(colours, () => []);
    for (const item of items) bins[Math.round(last * rampPosition(quantity, quantity.values[item]))].push(item);
    return bins;
  }

  /** Median size of visible elements in pixels. */
  pixelSize(items, view) {
    const sizes = [];
    for (let i = 0; i < items.length; i += Math.ceil(items.length / 200)) {
      const k = 4 * items[i];
      sizes.push(Math.sqrt((this.boxes[k + 2] - this.boxes[k]) * (this.boxes[k + 3] - this.boxes[k + 1])));
    }
    return sizes.length ? view.scale * sizes.sort((a, b) => a - b)[sizes.length >> 1] : 0;
  }

  fill(context, view, theme) {
    const items = itemsWithin(this.boxes, view.rectangle());
    const size = this.pixelSize(items, view);
    if (this.quantity < 0) return this.fillPlain(context, view, theme, items, size);
    const bins = this.binned(items, theme), colours = coloursOf(theme, this.quantities[this.quantity]);
    if (size < 7 && items.length > 3000) return paintSmallCells(context, view, this, bins, colours);
    const maps = view.maps();
    bins.forEach((bin, i) => {
      if (!bin.length) return;
      context.fillStyle = context.strokeStyle = css(colours[i]);
      context.lineWidth = 0.6;
      context.beginPath();
      for (const item of bin) this.traceElement(context, maps, item, size < 10);
      context.fill();
      context.stroke(); // closes the seams between neighbours
    });
  }

  fillPlain(context, view, theme, items, size) {
    if (!this.isPlain || !items.length) return;
    context.fillStyle = theme.fill;
    context.beginPath();
    for (const item of items) this.traceElement(context, view.maps(), item, size < 10);
    context.fill();
  }

  stroke(context, view, theme) {
    const maps = view.maps(), items = itemsWithin(this.boxes, view.rectangle()), size = this.pixelSize(items, view);
    const alpha = Math.min(0.55, (size - 3) / 25);
    if (alpha > 0.02 && items.length < 60000) {
      context.strokeStyle = `rgba(${theme.line},${alpha})`;
      context.lineWidth = 0.8;
      context.beginPath();
      for (const edge of this.edgesOf(items)) this.traceEdge(context, maps, edge, size < 10);
      context.stroke();
    }
    this.strokeBorders(context, view, theme, size);
  }

  edgesOf(items) {
    const edges = [];
    ++this.stamp;
    for (const item of items)
      for (let k = item * this.sides; k < (item + 1) * this.sides; ++k) {
        const edge = Math.abs(this.elements[k]) - 1;
        if (this.stamps[edge] === this.stamp) continue;
        this.stamps[edge] = this.stamp;
        edges.push(edge);
      }
    return edges;
  }

  strokeBorders(context, view, theme, size) {
    const [x0, y0, x1, y1] = view.rectangle(), v = this.vertices;
    context.strokeStyle = theme.border;
    context.lineWidth = 1.4;
    context.globalAlpha = 0.75;
    context.beginPath();
    for (const edge of this.borders) {
      const a = 2 * this.ends[2 * edge], b = 2 * this.ends[2 * edge + 1];
      const slack = Math.abs(v[a] - v[b]) + Math.abs(v[a + 1] - v[b + 1]);
      if (Math.max(v[a], v[b]) + slack < x0 || Math.min(v[a], v[b]) - slack > x1) continue;
      if (Math.max(v[a + 1], v[b + 1]) + slack < y0 || Math.min(v[a + 1], v[b + 1]) - slack > y1) continue;
      this.traceEdge(context, view.maps(), edge, size < 6);
    }
    context.stroke();
    context.globalAlpha = 1;
  }

  legend(theme) {
    return this.borders.length ? [["border of a block", legendLine(theme.border, 1.4)]] : [];
  }

  outline(view, item) {
    const path = new Path2D();
    this.traceElement(path, view.maps(), item, false);
    return path;
  }

  itemAt(context, view, px, py) {
    const [x, y] = view.toPlane(px, py);
    const hit = itemsWithin(this.boxes, [x, y, x, y]).find((i) => context.isPointInPath(this.outline(view, i), px, py));
    return hit === undefined ? -1 : hit;
  }

  heading(item) {
    const block = this.blocks ? this.blocks[item] : -1, name = this.blockNames[block] || "";
    const within = block < 0 ? "" : ` · block ${block}${nameSuffix(name, "block", block)}`;
    return `${this.noun} ${item}${within}`;
  }

  /** Points along the sides, for lengths and areas. */
  sidePoints(item, k) {
    const side = this.elements[item * this.sides + k], edge = Math.abs(side) - 1, p = [0, 0];
    const at = (vertex) => [this.vertices[2 * vertex], this.vertices[2 * vertex + 1]];
    const controls = [at(this.ends[2 * edge])];
    for (let i = 0; i < 3 * this.pieces[edge] - 1; ++i) controls.push([...this.control(edge, i, p)]);
    controls.push(at(this.ends[2 * edge + 1]));
    const points = this.pieces[edge] ? flattened(controls, 8) : controls;
    return side < 0 ? points.reverse() : points;
  }

  sizes(item) {
    const sides = Array.from({ length: this.sides }, (_, k) => this.sidePoints(item, k));
    const lengths = sides.map(lengthOf);
    return { area: areaOf(sides.flat()), least: Math.min(...lengths), greatest: Math.max(...lengths) };
  }
}
