// Labels of curves, regions and blocks. The rule is that of pictures (lib/show/draw/labels.cpp): a label lies beside the
// curve that it names, outside the face where there is room, else inside; it covers neither the boundary nor another
// text, and no curve of another name is nearer to it.

const labelCell = 4; // pixels of the raster of what is taken

/** Which parts of the window are taken, by the boundary or by texts. */
class Taken {
  constructor(view) {
    this.columns = Math.ceil(view.width / labelCell);
    this.rows = Math.ceil(view.height / labelCell);
    this.cells = new Uint8Array(this.columns * this.rows);
    this.lines = []; // pieces of the boundary: {name, from, to}
  }

  cellsOf([x0, y0, x1, y1], visit) {
    const at = (value, count) => Math.min(count - 1, Math.max(0, Math.floor(value / labelCell)));
    for (let row = at(y0, this.rows); row <= at(y1, this.rows); ++row)
      for (let column = at(x0, this.columns); column <= at(x1, this.columns); ++column)
        if (visit(row * this.columns + column)) return true;
    return false;
  }

  mark(box) {
    this.cellsOf(box, (cell) => void (this.cells[cell] = 1));
  }

  isFree(box) {
    if (box[0] < 2 || box[1] < 2 || box[2] > this.columns * labelCell - 6 || box[3] > this.rows * labelCell - 6) return false;
    return !this.cellsOf(box, (cell) => this.cells[cell]);
  }

  /** A piece of the boundary, of a curve with this label. */
  markLine(name, [x0, y0], [x1, y1]) {
    this.lines.push({ name, from: [x0, y0], to: [x1, y1] });
    const count = Math.min(4000, Math.ceil(Math.max(Math.abs(x1 - x0), Math.abs(y1 - y0)) / labelCell)) || 1;
    for (let i = 0; i <= count; ++i) {
      const x = Math.floor((x0 + (i / count) * (x1 - x0)) / labelCell), y = Math.floor((y0 + (i / count) * (y1 - y0)) / labelCell);
      if (x >= 0 && y >= 0 && x < this.columns && y < this.rows) this.cells[y * this.columns + x] = 1;
    }
  }
}

/** What labels must not cover: the boundary; below and on the left the figures of the axes; the scale bar, the title. */
function takenBy(view, layers, scaleBar, all) {
  const taken = new Taken(view);
  taken.mark([0, 0, 40, view.height]);
  taken.mark([0, view.height - 24, view.width, view.height]);
  taken.mark([view.width - scaleBar - 24, view.height - 52, view.width, view.height]);
  taken.mark([0, 0, view.width / 2, 28]);
  for (const layer of layers)
    if (layer.style === "boundary")
      for (const item of itemsWithin(layer.boxes, view.rectangle())) {
        const points = layer.screenPoints(view, item);
        for (let k = 1; k < points.length; ++k) taken.markLine(layer.labelOf(item, all), points[k - 1], points[k]);
      }
  return taken;
}

/** Where labels lie: [{text, x, y}]. */
function placedLabels(context, view, layers, all) {
  const placed = [], taken = takenBy(view, layers, roundStep(80 / view.scale) * view.scale, all);
  const put = (text, x, y, half) => {
    placed.push({ text, x, y });
    taken.mark([x - half, y - 9, x + half, y + 9]);
  };
  const halfOf = (text) => context.measureText(text).width / 2 + 3;
  const labelled = layers.filter((layer) => layer.places);
  for (const { text, at, clearance } of labelled.flatMap((layer) => layer.places(view))) {
    const half = halfOf(text), [x, y] = view.toScreen(at[0], at[1]);
    if (clearance * view.scale < Math.min(half, 9)) continue;
    if (taken.isFree([x - half, y - 8, x + half, y + 8])) put(text, x, y, half);
  }
  const curves = labelled.flatMap((layer) => layer.curveLabels(view, all)).sort((a, b) => a.points.length - b.points.length);
  for (const { text, points } of curves) {
    const half = halfOf(text), place = placeBeside(text, points, half, taken);
    if (place) put(text, ...place, half);
  }
  return placed;
}

/** The first free place [x, y] for the label of a curve, whose points are a few pixels apart and have the face on their
 *  left; null if there is none. */
function placeBeside(name, points, half, taken) {
  for (const gap of [5, 10, 18])
    for (const fraction of [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9])
      for (const side of [1, -1]) {
        const i = Math.min(points.length - 2, Math.floor(fraction * points.length));
        const [x, y] = points[i], dx = points[i + 1][0] - x, dy = points[i + 1][1] - y, length = Math.hypot(dx, dy) || 1;
        const nx = (-side * dy) / length, ny = (side * dx) / length; // y is down
        const reach = gap + half * Math.abs(nx) + 9 * Math.abs(ny), at = [x + reach * nx, y + reach * ny];
        const box = [at[0] - half, at[1] - 9, at[0] + half, at[1] + 9];
        if (taken.isFree(box) && isNearest(taken, name, box)) return at;
      }
  return null;
}

/** Whether no curve is nearer to a label than its own, whose it would seem to be. Curves that meet are equal. */
function isNearest(taken, name, box) {
  let own = Infinity, other = Infinity;
  for (const line of taken.lines) {
    const distance = distanceToBox(line.from, line.to, box);
    if (line.name === name) own = Math.min(own, distance);
    else other = Math.min(other, distance);
  }
  return own <= other + 1e-3;
}

/** Draws the labels; their places are found again only after the view or the layers changed. */
function drawLabels(context, view, theme, layers, all, scene) {
  context.font = "12px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = theme.ink;
  const key = [view.x, view.y, view.scale, view.width, view.height, all, ...layers.map((layer) => layer.number)].join();
  if (scene.labelKey !== key) Object.assign(scene, { labelKey: key, placed: placedLabels(context, view, layers, all) });
  for (const { text, x, y } of scene.placed) haloText(context, theme, text, x, y);
}
