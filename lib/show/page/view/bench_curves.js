// The workbench: curves of the boundary that belong together: whole circles, smooth continuations, those in a box.

class CurveGroups {
  constructor(boundary) {
    this.boundary = boundary;
    this.count = boundary.count;
    const all = [0, 1, 2, 3].map((k) => boundary.boxes.filter((_, i) => i % 4 === k));
    const [x0, y0, x1, y1] = all.map((side, k) => side.reduce((a, b) => (k < 2 ? Math.min(a, b) : Math.max(a, b)), k < 2 ? Infinity : -Infinity));
    this.slack = 1e-6 * Math.hypot(x1 - x0, y1 - y0);
    this.curves = Array.from({ length: this.count }, (_, i) => flattened(boundary.controls(i), 16));
    this.loops = this.loopsOfCurves();
  }

  /** Of both sides of a common curve the lower number; other curves are their own. */
  lower(curve) {
    return this.boundary.isInterface(curve) ? Math.min(curve, this.boundary.partners[curve]) : curve;
  }
  get all() {
    return [...new Set(Array.from({ length: this.count }, (_, i) => this.lower(i)))];
  }

  /** Curves are listed loop after loop, each from the end of the one before. */
  loopsOfCurves() {
    const loops = [];
    for (let first = 0, i = 0; i < this.count; ++i) {
      if (awayFrom(this.curves[i].at(-1), this.curves[first][0]) > this.slack) continue;
      loops.push(Array.from({ length: i + 1 - first }, (_, k) => first + k));
      first = i + 1;
    }
    return loops;
  }

  /** The diameter of the circle that the whole loop of a curve is; 0 for others. */
  diameterOf(curve) {
    const loop = this.loops.find((curves) => curves.includes(curve));
    if (!loop) return 0;
    const points = loop.flatMap((i) => this.curves[i]), n = points.length;
    const [ax, ay] = points[0], [ux, uy] = points[Math.floor(n / 3)], [vx, vy] = points[Math.floor((2 * n) / 3)];
    const bx = ux - ax, by = uy - ay, cx = vx - ax, cy = vy - ay, twice = 2 * (bx * cy - by * cx);
    if (Math.abs(twice) < 1e-300) return 0;
    const b = bx * bx + by * by, c = cx * cx + cy * cy;
    const centre = [ax + (cy * b - by * c) / twice, ay + (bx * c - cx * b) / twice], radius = awayFrom(centre, [ax, ay]);
    return points.every((p) => Math.abs(awayFrom(p, centre) - radius) < 1e-4 * radius + this.slack) ? 2 * radius : 0;
  }

  circlesBelow(diameter) {
    return this.all.filter((curve) => this.diameterOf(curve) > 0 && this.diameterOf(curve) < diameter);
  }

  /** Those that lie in a box as a whole. */
  inBox([x0, y0, x1, y1]) {
    const isIn = ([x, y]) => x >= x0 && x <= x1 && y >= y0 && y <= y1;
    return this.all.filter((curve) => this.curves[curve].every(isIn));
  }

  /** Both ends of a curve: where, and the unit vector into the curve. */
  endsOf(curve) {
    const points = this.curves[curve], controls = this.boundary.controls(curve);
    const into = (list) => {
      const [x, y] = list[0], next = list.find((p) => awayFrom(p, list[0]) > 1e-3 * this.slack) || list[0];
      const length = awayFrom(next, list[0]) || 1;
      return { at: list[0], along: [(next[0] - x) / length, (next[1] - y) / length] };
    };
    return points.length ? [into(controls), into([...controls].reverse())] : [];
  }

  /** A curve and all that continue it, and each other, with a turn of at most one degree. */
  tangentTo(curve) {
    const found = new Set([this.lower(curve)]), ends = this.all.map((i) => [i, this.endsOf(i)]);
    const goesOn = (a, b) =>
      awayFrom(a.at, b.at) < this.slack && a.along[0] * b.along[0] + a.along[1] * b.along[1] < -Math.cos(Math.PI / 180);
    for (const one of found)
      for (const [other, otherEnds] of ends)
        if (!found.has(other) && this.endsOf(one).some((a) => otherEnds.some((b) => goesOn(a, b)))) found.add(other);
    return [...found];
  }
}
