// Small geometry: points of cubic pieces, lengths, areas; quads of a few pixels painted pixel by pixel.

/** Points of a chain of cubic pieces, `count` for each piece after the first point. */
function flattened(controls, count) {
  const points = [controls[0]];
  for (let i = 0; i + 3 < controls.length; i += 3)
    for (let k = 1; k <= count; ++k) points.push(cubicPoint(controls, i, k / count));
  return points;
}

function cubicPoint(controls, i, s) {
  const r = 1 - s, weights = [r * r * r, 3 * r * r * s, 3 * r * s * s, s * s * s];
  return [0, 1].map((axis) => weights.reduce((sum, w, k) => sum + w * controls[i + k][axis], 0));
}

/** Points of a polyline `step` apart, those that `isSeen`. */
function evenlySpaced(points, step, isSeen) {
  const found = [];
  for (let k = 1; k < points.length; ++k) {
    const [x0, y0] = points[k - 1], [x1, y1] = points[k], count = Math.min(2000, Math.ceil(Math.hypot(x1 - x0, y1 - y0) / step));
    for (let i = 0; i < count; ++i) {
      const point = [x0 + (i / count) * (x1 - x0), y0 + (i / count) * (y1 - y0)];
      if (isSeen(point)) found.push(point);
    }
  }
  return found;
}

function distanceToSegment([x, y], [ax, ay], [bx, by]) {
  const dx = bx - ax, dy = by - ay, square = dx * dx + dy * dy;
  const part = square > 0 ? Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / square)) : 0;
  return Math.hypot(x - ax - part * dx, y - ay - part * dy);
}

/** Of a segment that does not cross the box. */
function distanceToBox(from, to, [x0, y0, x1, y1]) {
  const ends = [from, to].map(([x, y]) => Math.hypot(Math.max(x0 - x, 0, x - x1), Math.max(y0 - y, 0, y - y1)));
  const corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map((corner) => distanceToSegment(corner, from, to));
  return Math.min(...ends, ...corners);
}

/** Of the points of a lattice in the box, the one inside the closed polygon that is farthest from it: {at, clearance}. */
function roomiestPoint(polygon, [x0, y0, x1, y1]) {
  const count = 9;
  let best = { at: [(x0 + x1) / 2, (y0 + y1) / 2], clearance: 0 };
  for (let j = 1; j <= count; ++j)
    for (let i = 1; i <= count; ++i) {
      const at = [x0 + ((x1 - x0) * i) / (count + 1), y0 + ((y1 - y0) * j) / (count + 1)];
      const clearance = signedClearance(polygon, at);
      if (clearance > best.clearance * (1 + 1e-6)) best = { at, clearance };
    }
  return best;
}

/** The distance of a point from a closed polygon, negative outside. */
function signedClearance(polygon, [x, y]) {
  let least = Infinity, isInside = false;
  for (let k = 0; k < polygon.length; ++k) {
    const [ax, ay] = polygon[k], [bx, by] = polygon[(k + 1) % polygon.length], dx = bx - ax, dy = by - ay;
    const along = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
    least = Math.min(least, Math.hypot(ax + along * dx - x, ay + along * dy - y));
    if (ay > y !== by > y && x < ax + ((y - ay) / dy) * dx) isInside = !isInside;
  }
  return isInside ? least : -least;
}

function lengthOf(points) {
  let length = 0;
  for (let i = 1; i < points.length; ++i)
    length += Math.hypot(points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1]);
  return length;
}

function areaOf(points) {
  let twice = 0;
  const [x0, y0] = points[0];
  for (let i = 1; i < points.length; ++i)
    twice += (points[i - 1][0] - x0) * (points[i][1] - y0) - (points[i][0] - x0) * (points[i - 1][1] - y0);
  return twice / 2;
}

/** ": wing", or nothing where the name is made from the number. */
function nameSuffix(name, noun, number) {
  return name && !new RegExp(`^${noun}[ _]?${number}$`).test(name) ? `: ${name}` : "";
}

/** A number for people: four significant digits. */
function figure(value) {
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  return size >= 1e-3 && size < 1e5 ? String(Number(value.toPrecision(4))) : value.toExponential(2).replace("e+", "e");
}

/** An image of the window's pixels, as a canvas that `paint` fills through 32-bit pixels. */
function paintedPixels(context, view, paint) {
  const ratio = context.getTransform().a;
  const width = Math.ceil(view.width * ratio), height = Math.ceil(view.height * ratio);
  const canvas = new OffscreenCanvas(width, height), own = canvas.getContext("2d");
  const image = own.createImageData(width, height);
  paint(new Uint32Array(image.data.buffer), width, height, ratio);
  own.putImageData(image, 0, 0);
  context.drawImage(canvas, 0, 0, width / ratio, height / ratio);
}

const pixelOf = ([r, g, b]) => ((255 << 24) | (b << 16) | (g << 8) | r) >>> 0;

/** Fills cells of a few pixels by their straight outlines: as two triangles, and at least one pixel. */
function paintSmallCells(context, view, cells, bins, colours) {
  paintedPixels(context, view, (pixels, width, height, ratio) => {
    const scale = view.scale * ratio, x0 = width / 2 - view.x * scale, y0 = height / 2 + view.y * scale;
    const corners = new Float64Array(2 * cells.sides);
    bins.forEach((bin, i) => {
      const colour = pixelOf(colours[i]);
      for (const item of bin) {
        for (let k = 0; k < cells.sides; ++k) {
          const vertex = 2 * cells.corner(item, k);
          corners[2 * k] = x0 + cells.vertices[vertex] * scale;
          corners[2 * k + 1] = y0 - cells.vertices[vertex + 1] * scale;
        }
        for (let k = 2; k < cells.sides; ++k)
          paintTriangle(pixels, width, height, corners, [0, 2 * k - 2, 2 * k], colour);
      }
    });
  });
}

/** Sets the pixels whose centres lie in the triangle, or the one of its first corner. */
function paintTriangle(pixels, width, height, points, at, colour) {
  const ax = points[at[0]], ay = points[at[0] + 1], bx = points[at[1]], by = points[at[1] + 1];
  const cx = points[at[2]], cy = points[at[2] + 1];
  const top = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5));
  const bottom = Math.min(height - 1, Math.floor(Math.max(ay, by, cy) - 0.5));
  if (ax >= 0 && ax < width && ay >= 0 && ay < height) pixels[Math.floor(ay) * width + Math.floor(ax)] = colour;
  for (let row = top; row <= bottom; ++row) {
    const y = row + 0.5;
    let left = Infinity, right = -Infinity;
    const meet = (px, py, qx, qy) => {
      if (py <= y === qy <= y) return;
      const x = px + ((y - py) * (qx - px)) / (qy - py);
      if (x < left) left = x;
      if (x > right) right = x;
    };
    meet(ax, ay, bx, by);
    meet(bx, by, cx, cy);
    meet(cx, cy, ax, ay);
    const first = Math.max(0, Math.ceil(left - 0.5)), last = Math.min(width - 1, Math.floor(right - 0.5));
    for (let column = first; column <= last; ++column) pixels[row * width + column] = colour;
  }
}
