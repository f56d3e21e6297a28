// How nodes came about: circles of clusters, of error bars and of the search; arrows of changes and of directions.

class Discs {
  constructor(json, step) {
    Object.assign(this, layerBase(json));
    this.points = positionsOf(json.points, step);
    this.radii = floatsOf(json.radii);
    this.leastPixels = json.leastPixels;
    this.isToScale = json.toScale; // and not drawn where too small
    this.count = this.radii.length;
  }

  fill() {}

  radius(view, item) {
    return Math.max(this.leastPixels, view.scale * this.radii[item]);
  }

  outline(view, item) {
    const path = new Path2D(), [x, y] = view.toScreen(this.points[2 * item], this.points[2 * item + 1]);
    path.arc(x, y, this.radius(view, item), 0, 2 * Math.PI);
    return path;
  }

  get isDot() {
    return this.leastPixels > 0 && this.leastPixels < 5;
  }

  legend(theme) {
    return [[this.title, legendMark((context) => {
      context.strokeStyle = context.fillStyle = theme.ink;
      context.setLineDash(this.isToScale ? [] : [5, 4]);
      const path = new Path2D();
      path.arc(legendSize[0] / 2, legendSize[1] / 2, this.isDot ? this.leastPixels : 7, 0, 2 * Math.PI);
      if (this.isDot) context.fill(path);
      else context.stroke(path);
    })]];
  }

  stroke(context, view, theme) {
    context.strokeStyle = context.fillStyle = theme.ink;
    context.lineWidth = 1.2;
    context.setLineDash(this.isToScale ? [] : [5, 4]);
    for (let i = 0; i < this.count; ++i) {
      if (this.isToScale && this.radius(view, i) < 2) continue;
      if (this.isDot) context.fill(this.outline(view, i));
      else context.stroke(this.outline(view, i));
    }
    context.setLineDash([]);
  }

  /** Those whose rim is near; marks in them are found first. */
  itemAt(context, view, px, py) {
    for (let i = 0; i < this.count; ++i) {
      const [x, y] = view.toScreen(this.points[2 * i], this.points[2 * i + 1]), radius = this.radius(view, i);
      if (radius >= 2 && Math.abs(Math.hypot(x - px, y - py) - radius) < 5) return i;
    }
    return -1;
  }

  heading(item) {
    return this.names[item];
  }

  sizes() {
    return {};
  }
}

class Arrows {
  constructor(json, step) {
    Object.assign(this, layerBase(json));
    this.points = positionsOf(json.points, step); // two for each arrow
    this.pixels = json.pixels; // the length of all; 0: to the second point
    this.count = this.names.length;
  }

  fill() {}

  /** Both ends in pixels. */
  ends(view, item) {
    const p = this.points, k = 4 * item, from = view.toScreen(p[k], p[k + 1]), to = view.toScreen(p[k + 2], p[k + 3]);
    if (!this.pixels) return [from, to];
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1, t = this.pixels / length;
    return [from, [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])]];
  }

  outline(view, item) {
    const path = new Path2D(), [[x0, y0], [x, y]] = this.ends(view, item), angle = Math.atan2(y - y0, x - x0);
    if (Math.hypot(x - x0, y - y0) < 3) return path;
    path.moveTo(x0, y0);
    path.lineTo(x, y);
    for (const turn of [2.7, -2.7]) {
      path.moveTo(x, y);
      path.lineTo(x + 7 * Math.cos(angle + turn), y + 7 * Math.sin(angle + turn));
    }
    return path;
  }

  legend(theme) {
    return [[this.title, legendMark((context) => {
      context.strokeStyle = this.pixels ? theme.faint : theme.ink;
      context.lineWidth = 1.3;
      context.stroke(new Path2D("M4 9H26M20 6L26 9L20 12"));
    })]];
  }

  stroke(context, view, theme) {
    context.strokeStyle = this.pixels ? theme.faint : theme.ink;
    context.lineWidth = 1.3;
    for (let i = 0; i < this.count; ++i) context.stroke(this.outline(view, i));
  }

  itemAt(context, view, px, py) {
    context.lineWidth = 8;
    for (let i = 0; i < this.count; ++i) if (context.isPointInStroke(this.outline(view, i), px, py)) return i;
    return -1;
  }

  heading(item) {
    return this.names[item];
  }

  sizes() {
    return {};
  }
}
