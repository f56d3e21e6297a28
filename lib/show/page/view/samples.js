// The field: cubic pieces (u, v) on parts of each triangle, as colours of the cross angle, with contours and crosses.
// They are drawn as small triangles on which u and v are linear (lib/show/page/field_samples.hpp).

class Samples {
  constructor(json, step) {
    Object.assign(this, layerBase(json));
    this.isUnit = json.unit;
    this.count = 0;
    const stored = {
      points: positionsOf(json.points, step), scales: floatsOf(json.scales), values: shortsOf(json.values),
      point: 0, value: 0, triangle: 0,
    };
    const lattices = Array.from(bytesOf(json.forms), (form) => latticeOf(form & 7, (form >> 3) & 15));
    const sum = (member) => lattices.reduce((total, lattice) => total + lattice[member].length, 0);
    this.points = new Float64Array(2 * sum("points"));
    this.values = new Float32Array(2 * sum("points"));
    this.triangles = new Uint32Array(sum("corners"));
    let first = 0, corner = 0;
    bytesOf(json.forms).forEach((form, t) => {
      this.decode(stored, lattices[t], form > 127, first);
      for (const p of lattices[t].corners) this.triangles[corner++] = first + p;
      first += lattices[t].points.length;
    });
    this.boxes = emptyBoxes(this.triangles.length / 3);
    const at = (p) => [this.points[2 * p], this.points[2 * p + 1]];
    this.triangles.forEach((p, i) => include(this.boxes, Math.floor(i / 3), ...at(p)));
  }

  /** Values and positions at the points of the lattice of the next triangle; those are numbered from `first` on. */
  decode(stored, lattice, isCurved, first) {
    const { points, values, scales } = stored, count = isCurved ? lattice.stored : 3;
    const [u, v] = scales.subarray(2 * stored.triangle, 2 * stored.triangle + 2), weights = isCurved ? "cubic" : "corners3";
    lattice.points.forEach((point, k) => {
      const to = 2 * (first + k);
      for (const [number, weight] of point.cubic) {
        this.values[to] += (weight * u * values[stored.value + 2 * number]) / 32767;
        this.values[to + 1] += (weight * v * values[stored.value + 2 * number + 1]) / 32767;
      }
      for (const [number, weight] of point[weights]) {
        this.points[to] += weight * points[stored.point + 2 * number];
        this.points[to + 1] += weight * points[stored.point + 2 * number + 1];
      }
    });
    stored.point += 2 * count;
    stored.value += 2 * lattice.stored;
    ++stored.triangle;
  }

  fill(context, view, theme) {
    paintedPixels(context, view, (pixels, width, height, ratio) => {
      const scale = view.scale * ratio, x0 = width / 2 - view.x * scale, y0 = height / 2 + view.y * scale;
      const colours = this.pixelColours(theme), at = [0, 0, 0];
      for (const triangle of itemsWithin(this.boxes, view.rectangle())) {
        const corners = at.map((_, k) => {
          const p = 2 * this.triangles[3 * triangle + k];
          return [x0 + this.points[p] * scale, y0 - this.points[p + 1] * scale, this.values[p], this.values[p + 1]];
        });
        paintBlend(pixels, width, height, corners, colours);
      }
    });
  }

  /** The colour of (u, v): 256 angles by 64 magnitudes, fading to the paper's grey where the field vanishes. */
  pixelColours(theme) {
    const grey = channelsOf(theme.calm), table = new Uint32Array(16384);
    for (let i = 0; i < 16384; ++i) {
      const strength = Math.sqrt((i >> 8) / 63), colour = theme.angleColours[i & 255]; // of the phase, from -180 degrees
      table[i] = pixelOf(colour.map((c, k) => Math.round(grey[k] + strength * (c - grey[k]))));
    }
    return (u, v) => {
      const angle = Math.round((Math.atan2(v, u) / (2 * Math.PI) + 0.5) * 256) & 255;
      return table[(Math.min(63, Math.round(63 * Math.sqrt(u * u + v * v))) << 8) | angle];
    };
  }

  stroke(context, view, theme) {
    const visible = itemsWithin(this.boxes, view.rectangle());
    if (!this.isUnit) this.strokeContours(context, view, theme, visible);
    this.strokeCrosses(context, view, theme, visible);
  }

  /** u = 0 and v = 0, each the zeros of linear functions on the small triangles. */
  strokeContours(context, view, theme, triangles) {
    const maps = view.maps();
    for (const component of [0, 1]) {
      context.strokeStyle = theme.contours[component];
      context.lineWidth = 1.3;
      context.globalAlpha = 0.85;
      context.beginPath();
      for (const triangle of triangles) this.traceZero(context, maps, triangle, component);
      context.stroke();
    }
    context.globalAlpha = 1;
  }

  traceZero(context, maps, triangle, component) {
    const ends = [];
    for (let k = 0; k < 3; ++k) {
      const p = 2 * this.triangles[3 * triangle + k], q = 2 * this.triangles[3 * triangle + ((k + 1) % 3)];
      const a = this.values[p + component], b = this.values[q + component];
      if (a < 0 === b < 0) continue;
      const t = a / (a - b);
      ends.push(maps[0](this.points[p] + t * (this.points[q] - this.points[p])));
      ends.push(maps[1](this.points[p + 1] + t * (this.points[q + 1] - this.points[p + 1])));
    }
    if (ends.length !== 4) return;
    context.moveTo(ends[0], ends[1]);
    context.lineTo(ends[2], ends[3]);
  }

  /** Crosses on a lattice of the window that is fixed to the plane. */
  strokeCrosses(context, view, theme, triangles) {
    const spacing = 2 ** Math.round(Math.log2(36 / view.scale)), maps = view.maps();
    context.strokeStyle = `rgba(${theme.line},0.6)`;
    context.lineWidth = 1;
    context.beginPath();
    for (const triangle of triangles)
      this.latticePoints(triangle, spacing, (x, y, u, v) => {
        const angle = Math.atan2(v, u) / 4, r = 9 * Math.min(1, 2 * Math.hypot(u, v));
        for (const turn of [angle, angle + Math.PI / 2]) {
          const dx = r * Math.cos(turn), dy = -r * Math.sin(turn);
          context.moveTo(maps[0](x) - dx, maps[1](y) - dy);
          context.lineTo(maps[0](x) + dx, maps[1](y) + dy);
        }
      });
    context.stroke();
  }

  /** Calls `found` with the lattice points in a triangle and the field there. */
  latticePoints(triangle, spacing, found) {
    const box = this.boxes.subarray(4 * triangle, 4 * triangle + 4);
    for (let i = Math.ceil(box[0] / spacing); i * spacing <= box[2]; ++i)
      for (let j = Math.ceil(box[1] / spacing); j * spacing <= box[3]; ++j) {
        const value = this.valueIn(triangle, i * spacing, j * spacing);
        if (value) found(i * spacing, j * spacing, ...value);
      }
  }

  /** (u, v) at a point of a small triangle; null outside. */
  valueIn(triangle, x, y) {
    const [a, b, c] = [0, 1, 2].map((k) => 2 * this.triangles[3 * triangle + k]), p = this.points;
    const det = (p[b] - p[a]) * (p[c + 1] - p[a + 1]) - (p[c] - p[a]) * (p[b + 1] - p[a + 1]);
    const s = ((x - p[a]) * (p[c + 1] - p[a + 1]) - (p[c] - p[a]) * (y - p[a + 1])) / det;
    const t = ((p[b] - p[a]) * (y - p[a + 1]) - (x - p[a]) * (p[b + 1] - p[a + 1])) / det;
    if (!(s >= 0 && t >= 0 && s + t <= 1)) return null;
    return [0, 1].map((k) => (1 - s - t) * this.values[a + k] + s * this.values[b + k] + t * this.values[c + k]);
  }

  legend(theme) {
    return legendOfField(theme, this.isUnit);
  }

  /** Nothing: the field has no items that could be told apart. */
  outline() {
    return new Path2D();
  }

  itemAt(context, view, px, py) {
    const [x, y] = view.toPlane(px, py);
    this.probe = null;
    const hit = itemsWithin(this.boxes, [x, y, x, y]).find((i) => (this.probe = this.valueIn(i, x, y)));
    return hit === undefined ? -1 : hit;
  }

  heading() {
    if (!this.probe) return "field";
    const [u, v] = this.probe;
    return `cross angle ${figure((Math.atan2(v, u) * 45) / Math.PI)}°, u ${u.toFixed(3)}, v ${v.toFixed(3)}`;
  }

  sizes() {
    return {};
  }
}

/** Paints a triangle whose corners are [x, y, u, v], with (u, v) linear between them, row by row. */
function paintBlend(pixels, width, height, [a, b, c], colourOf) {
  const det = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  if (!det) return;
  const alongX = (k) => ((b[k] - a[k]) * (c[1] - a[1]) - (c[k] - a[k]) * (b[1] - a[1])) / det;
  const alongY = (k) => ((c[k] - a[k]) * (b[0] - a[0]) - (b[k] - a[k]) * (c[0] - a[0])) / det;
  const ux = alongX(2), uy = alongY(2), vx = alongX(3), vy = alongY(3);
  const end = Math.min(height, Math.ceil(Math.max(a[1], b[1], c[1])));
  for (let row = Math.max(0, Math.floor(Math.min(a[1], b[1], c[1]))); row < end; ++row) {
    const dy = row + 0.5 - a[1], [first, last] = rowSpan(a, b, c, row + 0.5, width);
    for (let column = first; column <= last; ++column) {
      const dx = column + 0.5 - a[0];
      pixels[row * width + column] = colourOf(a[2] + ux * dx + uy * dy, a[3] + vx * dx + vy * dy);
    }
  }
}

/** The first and last column whose centres lie in the triangle at height y; a little more, against seams. */
function rowSpan(a, b, c, y, width) {
  let left = Infinity, right = -Infinity;
  const meet = (p, q) => {
    if (p[1] <= y === q[1] <= y) return;
    const x = p[0] + ((y - p[1]) * (q[0] - p[0])) / (q[1] - p[1]);
    if (x < left) left = x;
    if (x > right) right = x;
  };
  meet(a, b);
  meet(b, c);
  meet(c, a);
  return [Math.max(0, Math.ceil(left - 0.51)), Math.min(width - 1, Math.floor(right - 0.49))];
}

const lattices = new Map();

/** The lattice on which a triangle of parts² cubic pieces is drawn, by `lines` lines on each side of a piece: its points
 *  with the weights [number, weight] of stored values (cubic) and of the triangle's corners (corners3), and the corners
 *  of its small triangles. */
function latticeOf(parts, lines) {
  const key = 16 * parts + lines, n = parts * lines;
  if (lattices.has(key)) return lattices.get(key);
  const points = [], corners = [], rows = Array.from({ length: n + 2 }, (_, j) => (j * (2 * n + 3 - j)) / 2);
  for (let j = 0; j <= n; ++j)
    for (let i = 0; i + j <= n; ++i) {
      points.push({ cubic: cubicWeights(parts, lines, i, j), corners3: [[0, 1 - (i + j) / n], [1, i / n], [2, j / n]] });
      if (i + j < n) corners.push(rows[j] + i, rows[j] + i + 1, rows[j + 1] + i);
      if (i + j + 1 < n) corners.push(rows[j] + i + 1, rows[j + 1] + i + 1, rows[j + 1] + i);
    }
  lattices.set(key, { points, corners, stored: ((3 * parts + 1) * (3 * parts + 2)) / 2 });
  return lattices.get(key);
}

/** The weights [number, weight] of stored values at the point (p, q) of the lattice. Pieces that point down are those
 *  that point up, turned by half a turn. */
function cubicWeights(parts, lines, p, q) {
  const number = (i, j) => (j * (6 * parts + 3 - j)) / 2 + i;
  const factor = (a, s) => Array.from({ length: a }, (_, r) => (3 * s - r) / (r + 1)).reduce((x, y) => x * y, 1);
  let [i, j, a, b, sign] = [Math.floor(p / lines), Math.floor(q / lines), p % lines, q % lines, 1];
  if (a + b > lines) [i, j, a, b, sign] = [i + 1, j + 1, lines - a, lines - b, -1];
  if (!a && !b) return [[number(3 * i, 3 * j), 1]];
  const weights = [], s = a / lines, t = b / lines;
  for (let beta = 0; beta <= 3; ++beta)
    for (let alpha = 0; alpha + beta <= 3; ++alpha) {
      const weight = factor(alpha, s) * factor(beta, t) * factor(3 - alpha - beta, 1 - s - t);
      if (weight) weights.push([number(3 * i + sign * alpha, 3 * j + sign * beta), weight]);
    }
  return weights;
}
