// A mesh in space: the pointer turns it, a plane cuts it, normals shade it, and what is nearest hides the rest.

/** The rotation by `angle` about the unit vector (x, y, z), applied to v. */
function turned([vx, vy, vz], [x, y, z], angle) {
  const c = Math.cos(angle), s = Math.sin(angle), d = (1 - c) * (x * vx + y * vy + z * vz);
  return [
    c * vx + s * (y * vz - z * vy) + d * x, c * vy + s * (z * vx - x * vz) + d * y, c * vz + s * (x * vy - y * vx) + d * z,
  ];
}

const product = ([a, b, c], [x, y, z]) => a * x + b * y + c * z;

/** A colour between two, [r, g, b]. */
const mixed = (from, to, part) => from.map((channel, i) => Math.round(channel + part * (to[i] - channel)));

class SpacePane {
  /** `changed`: is called when the pointer turned it; `pointed`: with the position of a pointer that drags nothing. */
  constructor(canvas, changed, pointed) {
    this.canvas = canvas;
    this.cut = new Cut();
    this.buffer = new DepthBuffer();
    this.marked = -1; // element
    this.listen(changed, pointed);
  }

  /** `json`: points relative to `middle`, outlines of faces as indices of points, `samples` each, the one or two
      elements of each face, and the axes of the first view. */
  set(json) {
    const points = floatsOf(json.points);
    Object.assign(this, { json, samples: json.samples, middle: json.middle, marked: -1 });
    this.outlines = intsOf(json.outlines);
    this.elems = intsOf(json.elems);
    this.count = this.elems.length / 2;
    this.numPoints = points.length / 3;
    this.points = new Float32Array(points.length + 3 * this.count); // the centres of faces behind them
    this.points.set(points);
    this.normals = new Float32Array(3 * this.count);
    for (let face = 0; face < this.count; ++face) this.measure(face);
    this.middles = this.middlesOfElements();
    this.cut = Object.assign(this.cut, new Cut());
    this.fit();
  }

  /** The first view. */
  fit() {
    this.axes = [this.json.right, this.json.up, this.json.towards];
    this.zoom = 1;
  }

  resize(width, height, ratio) {
    Object.assign(this, { width, height, ratio });
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
  }

  /** The middle of a face, of the blend between its sides, and its normal. */
  measure(face) {
    const { points, outlines, samples, normals } = this, first = face * samples, quarter = samples / 4;
    const at = (k, i) => points[3 * outlines[first + k] + i], to = 3 * (this.numPoints + face);
    const u = [0, 0, 0], v = [0, 0, 0];
    for (let i = 0; i < 3; ++i) {
      let corners = 0, sides = 0;
      for (let side = 0; side < 4; ++side) {
        const start = at(side * quarter, i), end = at(((side + 1) % 4) * quarter, i);
        corners += start;
        sides += quarter > 1 ? at(side * quarter + quarter / 2, i) : (start + end) / 2;
      }
      points[to + i] = sides / 2 - corners / 4;
      u[i] = at(2 * quarter, i) - at(0, i);
      v[i] = at(3 * quarter, i) - at(quarter, i);
    }
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const length = Math.hypot(...normal) || 1;
    for (let i = 0; i < 3; ++i) normals[3 * face + i] = normal[i] / length;
  }

  /** The mean of the middles of its faces. */
  middlesOfElements() {
    const { elems, points, numPoints } = this, count = elems.reduce((most, elem) => Math.max(most, elem), -1) + 1;
    const sums = new Float32Array(3 * count), faces = new Uint8Array(count);
    for (let k = 0; k < elems.length; ++k) {
      if (elems[k] < 0) continue;
      ++faces[elems[k]];
      for (let i = 0; i < 3; ++i) sums[3 * elems[k] + i] += points[3 * (numPoints + (k >> 1)) + i];
    }
    return sums.map((sum, k) => sum / faces[Math.floor(k / 3)]);
  }

  /** [least, greatest] of the points along a direction. */
  extentAlong([x, y, z]) {
    const { points } = this, range = [Infinity, -Infinity];
    for (let k = 0; k < 3 * this.numPoints; k += 3) {
      const at = x * points[k] + y * points[k + 1] + z * points[k + 2];
      if (at < range[0]) range[0] = at;
      if (at > range[1]) range[1] = at;
    }
    return range;
  }

  /** Samples for each length; `detail` samples along each pixel. */
  scale(detail) {
    return (0.92 * this.zoom * detail * this.ratio * Math.min(this.width, this.height)) / this.json.extent;
  }

  /** The points as samples of the picture: x, y (down), depth. */
  projected(detail) {
    const { points, axes: [r, u, t] } = this, scale = this.scale(detail), to = new Float32Array(points.length);
    const x0 = (detail * this.canvas.width) / 2, y0 = (detail * this.canvas.height) / 2;
    for (let k = 0; k < points.length; k += 3) {
      const x = points[k], y = points[k + 1], z = points[k + 2];
      to[k] = x0 + scale * (x * r[0] + y * r[1] + z * r[2]);
      to[k + 1] = y0 - scale * (x * u[0] + y * u[1] + z * u[2]);
      to[k + 2] = scale * (x * t[0] + y * t[1] + z * t[2]);
    }
    return to;
  }

  /** The element of which a face is seen: the one that is shown if the other one is not; -1: none. */
  ownerOf(face) {
    const a = this.elems[2 * face], b = this.elems[2 * face + 1];
    const isA = this.shown[a], isB = b >= 0 && this.shown[b];
    return isA && !isB ? a : isB && !isA ? b : -1;
  }

  /** Elements have the colours of their quantity. `isQuick`: while it moves, a sample for each pixel. */
  draw(theme, layer, isQuick = false) {
    const start = performance.now();
    this.detail = isQuick || this.ratio > 1.5 ? 1 : 2;
    this.shown = this.cut.shown(this.middles, this.axes, this.extentAlong(this.cut.normal(this.axes)));
    this.visible = [];
    for (let face = 0; face < this.count; ++face) if (layer.isShown && this.ownerOf(face) >= 0) this.visible.push(face);
    const points = this.projected(this.detail);
    this.buffer.begin(this.detail * this.canvas.width, this.detail * this.canvas.height);
    for (const face of this.visible) this.fill(points, face);
    this.lineWeight = this.weightOfLines(points);
    this.paint(theme, layer);
    performance.measure(isQuick ? "draw turned" : "draw space", { start });
  }

  fill(points, face) {
    const { outlines, samples, buffer } = this, first = face * samples;
    if (samples === 4) {
      buffer.triangle(points, outlines[first], outlines[first + 1], outlines[first + 2], face);
      return buffer.triangle(points, outlines[first], outlines[first + 2], outlines[first + 3], face);
    }
    for (let k = 0; k < samples; ++k)
      buffer.triangle(points, outlines[first + k], outlines[first + ((k + 1) % samples)], this.numPoints + face, face);
  }

  /** How dark the lines of the mesh are: those of faces of few pixels would hide the colours. */
  weightOfLines(points) {
    const sizes = [], quarter = this.samples / 4, detail = this.detail * this.ratio;
    for (let i = 0; i < this.visible.length; i += Math.ceil(this.visible.length / 200)) {
      const [a, b, c, d] = [0, 1, 2, 3].map((k) => 3 * this.outlines[this.visible[i] * this.samples + k * quarter]);
      const along = Math.hypot(points[c] - points[a], points[c + 1] - points[a + 1]);
      sizes.push(Math.min(along, Math.hypot(points[d] - points[b], points[d + 1] - points[b + 1])) / detail);
    }
    const median = sizes.length ? sizes.sort((a, b) => a - b)[sizes.length >> 1] : 0;
    return Math.min(0.7, Math.max(0, (median - 3) / 25));
  }

  /** Colours of the faces that are seen: of their areas and of their lines. */
  coloursOfFaces(theme, layer) {
    const quantity = layer.quantities[layer.quantity], colours = quantity && coloursOf(theme, quantity);
    const fill = channelsOf(theme.fill), line = theme.line.split(",").map(Number), accent = channelsOf(theme.accent);
    const plain = new Uint32Array(this.count), lined = new Uint32Array(this.count), { normals, axes: [, , towards] } = this;
    for (const face of this.visible) {
      const owner = this.ownerOf(face);
      const facing = Math.abs(product(normals.subarray(3 * face, 3 * face + 3), towards));
      const own = quantity ? colours[Math.round(rampPosition(quantity, quantity.values[owner]) * (colours.length - 1))] : fill;
      const shaded = own.map((channel) => Math.round(channel * (0.5 + 0.5 * facing))), isMarked = owner === this.marked;
      plain[face] = pixelOf(isMarked ? mixed(shaded, accent, 0.35) : shaded);
      lined[face] = pixelOf(isMarked ? accent : mixed(shaded, line, this.lineWeight));
    }
    return { plain, lined, paper: pixelOf(channelsOf(theme.paper)) };
  }

  /** Colours what was drawn. */
  paint(theme, layer) {
    const { width, height } = this.buffer, own = new OffscreenCanvas(width, height), to = own.getContext("2d");
    const image = to.createImageData(width, height), context = this.canvas.getContext("2d");
    this.buffer.paint(new Uint32Array(image.data.buffer), this.coloursOfFaces(theme, layer), this.detail > 1 || this.ratio > 1.5);
    to.putImageData(image, 0, 0);
    context.drawImage(own, 0, 0, this.canvas.width, this.canvas.height);
  }

  /** The element that is seen at a position of the canvas; -1: none. */
  itemAt(x, y) {
    const at = (v) => Math.floor(v * this.detail * this.ratio), face = this.buffer.faces[at(y) * this.buffer.width + at(x)];
    return face >= 0 ? this.ownerOf(face) : -1;
  }

  isSeen(elem) {
    return this.buffer.faces.some((face) => face >= 0 && this.ownerOf(face) === elem);
  }

  /** Where the middle of an element is on the canvas. */
  placeOf(elem) {
    const x = this.middles.subarray(3 * elem, 3 * elem + 3), scale = this.scale(1) / this.ratio, [right, up] = this.axes;
    return [this.width / 2 + scale * product(x, right), this.height / 2 - scale * product(x, up)];
  }

  /** Cuts off what is nearer to the viewer than an element. */
  reveal(elem) {
    this.cut.choose(4, this.axes);
    const towards = this.axes[2], [least, greatest] = this.extentAlong(towards);
    this.cut.at = (product(this.middles.subarray(3 * elem, 3 * elem + 3), towards) - least) / (greatest - least || 1);
  }

  /** By pixels: to the right and down. */
  turn(dx, dy) {
    const [right, up] = this.axes, speed = Math.PI / Math.max(200, Math.min(this.width, this.height));
    this.axes = this.axes.map((axis) => turned(turned(axis, up, -dx * speed), right, -dy * speed));
  }

  zoomBy(factor) {
    this.zoom = Math.min(50, Math.max(0.2, this.zoom * factor));
  }

  listen(changed, pointed) {
    let last = null;
    this.canvas.addEventListener("pointerdown", (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      last = [event.offsetX, event.offsetY];
    });
    this.canvas.addEventListener("pointermove", (event) => {
      const now = [event.offsetX, event.offsetY];
      if (!last) return pointed(...now);
      this.turn(now[0] - last[0], now[1] - last[1]);
      last = now;
      changed();
    });
    for (const end of ["pointerup", "pointercancel"]) this.canvas.addEventListener(end, () => (last = null));
    this.canvas.addEventListener("pointerleave", () => pointed(-1, -1));
    const onWheel = (event) => {
      event.preventDefault();
      this.zoomBy(Math.exp(-0.0018 * (event.deltaMode === 1 ? 24 : 1) * event.deltaY));
      changed();
    };
    this.canvas.addEventListener("wheel", onWheel, { passive: false });
    this.canvas.addEventListener("keydown", (event) => {
      const move = moves[event.key];
      if (!move) return;
      event.preventDefault();
      event.stopPropagation();
      this.turn(-move[0] / 3, -move[1] / 3);
      changed();
    });
  }
}
