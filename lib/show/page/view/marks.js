// Nodes: polygons with a vertex for each block, dots on corners, diamonds on the boundary.

class Marks {
  constructor(json, step) {
    Object.assign(this, layerBase(json));
    this.points = positionsOf(json.points, step);
    this.valences = intsOf(json.valences);
    this.kinds = json.kinds;
    this.count = this.valences.length;
  }

  fill() {}

  stroke(context, view, theme) {
    const rectangle = view.rectangle();
    this.isCrowded = this.crowding(view) < 1;
    for (let i = 0; i < this.count; ++i) {
      const [x, y] = [this.points[2 * i], this.points[2 * i + 1]];
      if (x < rectangle[0] || x > rectangle[2] || y < rectangle[1] || y > rectangle[3]) continue;
      this.draw(context, theme, i, this.outline(view, i));
    }
  }

  /** Smaller where many would cover each other: a part of their mean distance, if they were spread evenly. */
  crowding(view) {
    if (!this.extent) {
      const box = emptyBoxes(1);
      for (let i = 0; i < this.count; ++i) include(box, 0, this.points[2 * i], this.points[2 * i + 1]);
      this.extent = Math.sqrt(Math.max(box[2] - box[0], 0) * Math.max(box[3] - box[1], 0));
    }
    const spacing = (view.scale * this.extent) / Math.sqrt(this.count);
    return this.extent ? Math.min(1, Math.max(0.45, spacing / 48)) : 1;
  }

  draw(context, theme, item, path) {
    const kind = this.kinds[item], colour = valenceColour(theme, this.valences[item], kind === "boundary");
    context.lineWidth = 1.6;
    context.strokeStyle = kind === "hollow" ? colour : theme.paper;
    context.fillStyle = kind === "corner" || kind === "dot" ? theme.ink : colour;
    if (kind !== "hollow") context.fill(path);
    if (kind !== "dot" || !this.isCrowded) context.stroke(path); // rims of many dots would cut the lines
  }

  radius(item) {
    const node = this.valences[item] === 3 ? 9.5 : 8;
    return { node, boundary: 8, corner: 4.5, dot: 3.2, hollow: 7 }[this.kinds[item]];
  }

  outline(view, item) {
    return this.shape(item, ...view.toScreen(this.points[2 * item], this.points[2 * item + 1]), this.crowding(view));
  }

  /** The mark of an item at a point of the window. */
  shape(item, x, y, factor) {
    const path = new Path2D(), kind = this.kinds[item], valence = this.valences[item], r = this.radius(item) * factor;
    const isPolygon = (kind === "node" || kind === "hollow") && valence >= 3 && valence <= 8;
    const vertices = isPolygon ? valence : kind === "boundary" ? 4 : 0;
    if (!vertices) path.arc(x, y, r, 0, 2 * Math.PI);
    for (let k = 0; k < vertices; ++k) {
      const angle = (2 * Math.PI * k) / vertices - Math.PI / 2;
      path.lineTo(x + r * Math.cos(angle), y + r * Math.sin(angle));
    }
    path.closePath();
    return path;
  }

  legend(theme) {
    return legendOfMarks(this, theme);
  }

  itemAt(context, view, px, py) {
    let nearest = -1, least = 11;
    for (let i = 0; i < this.count; ++i) {
      const [x, y] = view.toScreen(this.points[2 * i], this.points[2 * i + 1]);
      const away = Math.hypot(x - px, y - py);
      if (away < least) [nearest, least] = [i, away];
    }
    return nearest;
  }

  heading(item) {
    return this.names[item];
  }

  sizes(item) {
    return { at: [this.points[2 * item], this.points[2 * item + 1]] };
  }
}
