// Hidden surfaces: for each sample of a picture the face that is nearest to the viewer there.

class DepthBuffer {
  constructor() {
    this.width = this.height = 0;
  }

  begin(width, height) {
    if (width !== this.width || height !== this.height) {
      Object.assign(this, { width, height });
      this.depths = new Float32Array(width * height);
      this.faces = new Int32Array(width * height);
    }
    this.depths.fill(-Infinity);
    this.faces.fill(-1);
  }

  /** The triangle between three of `points`, which are x, y (down) and depth (greater is nearer), in samples. */
  triangle(points, i, j, k, face) {
    let a = 3 * i, b = 3 * j, c = 3 * k, kept;
    if (points[b + 1] < points[a + 1]) (kept = a), (a = b), (b = kept);
    if (points[c + 1] < points[b + 1]) (kept = b), (b = c), (c = kept);
    if (points[b + 1] < points[a + 1]) (kept = a), (a = b), (b = kept);
    const ax = points[a], ay = points[a + 1], az = points[a + 2];
    const ux = points[b] - ax, uy = points[b + 1] - ay, uz = points[b + 2] - az;
    const vx = points[c] - ax, vy = points[c + 1] - ay, vz = points[c + 2] - az;
    const area = ux * vy - vx * uy;
    if (area === 0) return;
    const perX = (uz * vy - vz * uy) / area, perY = (vz * ux - uz * vx) / area;
    const first = Math.max(0, Math.ceil(ay - 0.5)), last = Math.min(this.height, Math.ceil(ay + vy - 0.5));
    for (let row = first; row < last; ++row) {
      const y = row + 0.5 - ay, long = (vx * y) / vy;
      const short = y < uy ? (ux * y) / uy : ux + ((vx - ux) * (y - uy)) / (vy - uy);
      this.span(row, ax + Math.min(long, short), ax + Math.max(long, short), ax, az + perY * y, perX, face);
    }
  }

  /** The samples of a row from `left` to `right`; `depth` at `ax`. */
  span(row, left, right, ax, depth, perX, face) {
    const { depths, faces, width } = this, end = row * width + Math.min(width, Math.ceil(right - 0.5));
    const from = Math.max(0, Math.ceil(left - 0.5));
    let z = depth + perX * (from + 0.5 - ax);
    for (let at = row * width + from; at < end; ++at, z += perX)
      if (z > depths[at]) (depths[at] = z), (faces[at] = face);
  }

  /** Colours of the samples: `lined` where a face meets another one or ends, on both sides of that line if `isThick`. */
  paint(pixels, { plain, lined, paper }, isThick) {
    const { faces, width, height } = this, last = width * height;
    for (let at = 0; at < last; ++at) {
      const face = faces[at];
      if (face < 0) {
        pixels[at] = paper;
        continue;
      }
      const column = at % width;
      const right = column + 1 < width ? faces[at + 1] : face, below = at + width < last ? faces[at + width] : face;
      const left = column ? faces[at - 1] : face, above = at >= width ? faces[at - width] : face;
      const isLine = right !== face || below !== face || (isThick ? left !== face || above !== face : left < 0 || above < 0);
      pixels[at] = isLine ? lined[face] : plain[face];
    }
  }
}
