// The mesh of a curved face in space, beside its chart: the pointer turns it, far elements are drawn first, and normals
// shade them.

/** The rotation by `angle` about the unit vector (x, y, z), applied to v. */
function turned([vx, vy, vz], [x, y, z], angle) {
  const c = Math.cos(angle), s = Math.sin(angle), d = (1 - c) * (x * vx + y * vy + z * vz);
  return [
    c * vx + s * (y * vz - z * vy) + d * x, c * vy + s * (z * vx - x * vz) + d * y, c * vz + s * (x * vy - y * vx) + d * z,
  ];
}

const product = ([a, b, c], [x, y, z]) => a * x + b * y + c * z;

class SpacePane {
  constructor(canvas) {
    this.canvas = canvas;
    this.drawn = null; // the arguments of the last drawing
    this.listen();
  }

  /** `json`: outlines of the elements as points in space, `samples` each, relative to the middle of all, and the axes
      of the first view. */
  set(json) {
    this.points = floatsOf(json.points);
    this.samples = json.samples;
    this.extent = json.extent;
    this.axes = [json.right, json.up, json.towards];
    this.zoom = 1;
    this.count = this.points.length / (3 * this.samples);
  }

  resize(width, height, ratio) {
    Object.assign(this, { width, height, ratio });
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
  }

  point(elem, k) {
    const at = 3 * (elem * this.samples + k);
    return this.points.subarray(at, at + 3);
  }

  /** How far to the viewer the middle of an element is, and how much it faces the viewer. */
  placeOf(elem) {
    const quarter = this.samples / 4, [a, b, c, d] = [0, 1, 2, 3].map((side) => this.point(elem, side * quarter));
    const [ux, uy, uz] = [0, 1, 2].map((i) => c[i] - a[i]), [vx, vy, vz] = [0, 1, 2].map((i) => d[i] - b[i]);
    const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const towards = this.axes[2], length = Math.hypot(...normal) || 1;
    const depth = [a, b, c, d].reduce((sum, x) => sum + product(x, towards), 0);
    return { elem, depth, facing: Math.abs(product(normal, towards)) / length };
  }

  /** Elements have the colours that they have in the chart. */
  draw(theme, layer) {
    this.drawn = [theme, layer];
    const context = this.canvas.getContext("2d"), [right, up] = this.axes;
    const scale = (0.92 * this.zoom * Math.min(this.width, this.height)) / this.extent;
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.fillStyle = theme.paper;
    context.fillRect(0, 0, this.width, this.height);
    context.translate(this.width / 2, this.height / 2);
    context.lineWidth = 0.7;
    context.lineJoin = "round";
    context.strokeStyle = `rgba(${theme.line},0.7)`;
    const quantity = layer && layer.quantities[layer.quantity], fill = channelsOf(theme.fill);
    const places = Array.from({ length: this.count }, (_, elem) => this.placeOf(elem));
    places.sort((a, b) => a.depth - b.depth || a.elem - b.elem);
    for (const { elem, facing } of places) {
      context.beginPath();
      for (let k = 0; k < this.samples; ++k) {
        const x = this.point(elem, k);
        context.lineTo(scale * product(x, right), -scale * product(x, up));
      }
      context.closePath();
      const colours = quantity && coloursOf(theme, quantity);
      const colour = quantity ? colours[Math.round(rampPosition(quantity, quantity.values[elem]) * (colours.length - 1))] : fill;
      context.fillStyle = css(colour.map((channel) => Math.round(channel * (0.5 + 0.5 * facing))));
      context.fill();
      context.stroke();
    }
  }

  /** By pixels: to the right and down. */
  turn(dx, dy) {
    const [right, up] = this.axes, speed = Math.PI / Math.max(200, Math.min(this.width, this.height));
    this.axes = this.axes.map((axis) => turned(turned(axis, up, -dx * speed), right, -dy * speed));
    this.again();
  }

  again() {
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => this.drawn && this.draw(...this.drawn));
  }

  listen() {
    let last = null;
    this.canvas.addEventListener("pointerdown", (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      last = [event.offsetX, event.offsetY];
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (!last) return;
      const now = [event.offsetX, event.offsetY];
      this.turn(now[0] - last[0], now[1] - last[1]);
      last = now;
    });
    for (const end of ["pointerup", "pointercancel"]) this.canvas.addEventListener(end, () => (last = null));
    const onWheel = (event) => {
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 24 : 1;
      this.zoom = Math.min(50, Math.max(0.2, this.zoom * Math.exp(-0.0018 * lines * event.deltaY)));
      this.again();
    };
    this.canvas.addEventListener("wheel", onWheel, { passive: false });
    this.canvas.addEventListener("keydown", (event) => {
      const move = moves[event.key];
      if (!move) return;
      event.preventDefault();
      event.stopPropagation();
      this.turn(-move[0] / 3, -move[1] / 3);
    });
  }
}
