// Draws the layers. A sharp picture is larger than the window; while the view moves, that picture moves with it.

class Scene {
  constructor(canvas, overlay) {
    this.canvas = canvas;
    this.overlay = overlay;
    this.probe = new OffscreenCanvas(1, 1).getContext("2d");
    this.sharp = null; // {canvas, view, ratio}: the last sharp picture
    this.sharpTime = 0;
  }

  /** Sets the size of both canvases to that of the window's part. */
  resize(width, height) {
    this.ratio = Math.min(2, window.devicePixelRatio || 1);
    for (const canvas of [this.canvas, this.overlay]) {
      canvas.width = Math.round(width * this.ratio);
      canvas.height = Math.round(height * this.ratio);
    }
  }

  /** Draws everything anew, with a margin of a fifth of the window on each side. */
  drawSharp(view, theme, layers, added) {
    const start = performance.now(), large = view.copy();
    large.resize(...[view.width, view.height].map((size) => size + 2 * Math.round(size / 5))); // whole pixels
    const canvas = new OffscreenCanvas(Math.ceil(large.width * this.ratio), Math.ceil(large.height * this.ratio));
    const context = canvas.getContext("2d");
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.lineJoin = context.lineCap = "round";
    context.fillStyle = theme.paper;
    context.fillRect(0, 0, large.width, large.height);
    const other = { ...theme, ...theme.added }; // for lines of other stages
    const isMark = (layer) => layer instanceof Marks;
    for (const layer of layers) layer.fill(context, large, theme);
    for (const layer of layers)
      if (!isMark(layer) && layer.style !== "boundary") layer.stroke(context, large, added.has(layer) ? other : theme);
    for (const layer of layers) if (layer.style === "boundary") layer.stroke(context, large, theme);
    for (const layer of layers) if (isMark(layer)) layer.stroke(context, large, theme);
    this.sharp = { canvas, view: large };
    this.show(view, theme);
    this.sharpTime = performance.now() - start;
    performance.measure("draw sharp", { start });
  }

  /** Moves the last sharp picture to where it belongs in the view. */
  show(view, theme) {
    const start = performance.now(), context = this.canvas.getContext("2d"), last = this.sharp.view;
    const zoom = view.scale / last.scale, [x, y] = view.toScreen(last.x, last.y);
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.fillStyle = theme.paper;
    context.fillRect(0, 0, view.width, view.height);
    const width = last.width * zoom, height = last.height * zoom;
    context.drawImage(this.sharp.canvas, x - width / 2, y - height / 2, width, height);
    performance.measure("draw moved", { start });
  }

  drawOverlay(view, theme, page, layers, { focus, labels, title, cross }) {
    const context = this.overlay.getContext("2d");
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.clearRect(0, 0, view.width, view.height);
    if (focus) {
      drawFocus(context, view, theme, focus);
      drawRing(context, view, theme, focus);
    }
    if (labels !== "none") drawLabels(context, view, theme, layers, labels === "all", this);
    drawAxes(context, view, theme, page);
    drawScaleBar(context, view, theme, page);
    if (title) drawTitle(context, theme, title);
    if (cross) drawCross(context, view, theme, cross);
  }

  /** The topmost item under a point of the window: {layer, item}, or null. Marks are above lines, lines above areas. */
  itemAt(view, layers, px, py) {
    const rank = (layer) => (layer instanceof Marks ? 0 : layer instanceof Cells || layer.isFilled ? 2 : layer instanceof Samples ? 3 : 1);
    const ordered = layers.map((layer, i) => [layer, rank(layer), -i]);
    ordered.sort((a, b) => a[1] - b[1] || a[2] - b[2]);
    for (const [layer] of ordered) {
      const item = layer.itemAt(this.probe, view, px, py);
      if (item >= 0) return { layer, item };
    }
    return null;
  }
}
