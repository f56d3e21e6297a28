// Which part of the plane the window shows: a centre and pixels per length.

class View {
  constructor(width, height) {
    this.x = 0;
    this.y = 0;
    this.scale = 1;
    this.resize(width, height);
  }
  resize(width, height) {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
  }
  copy() {
    return Object.assign(new View(this.width, this.height), this);
  }
  toScreen(x, y) {
    return [this.width / 2 + (x - this.x) * this.scale, this.height / 2 - (y - this.y) * this.scale];
  }
  toPlane(px, py) {
    return [this.x + (px - this.width / 2) / this.scale, this.y - (py - this.height / 2) / this.scale];
  }
  /** Shows the whole box with a margin. */
  fit(x0, y0, x1, y1, margin) {
    this.x = (x0 + x1) / 2;
    this.y = (y0 + y1) / 2;
    const across = Math.max(x1 - x0, 1e-300), up = Math.max(y1 - y0, 1e-300);
    this.scale = Math.min((this.width - 2 * margin) / across, (this.height - 2 * margin) / up);
    if (!(this.scale > 0)) this.scale = 1 / Math.max(across, up);
  }
  pan(dx, dy) {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
  }
  /** Zooms about a point of the window, which stays where it is. */
  zoom(factor, px, py, limits) {
    const [x, y] = this.toPlane(px, py);
    this.scale = Math.min(limits[1], Math.max(limits[0], this.scale * factor));
    this.x = x - (px - this.width / 2) / this.scale;
    this.y = y + (py - this.height / 2) / this.scale;
  }
  /** The part of the plane in the window: x0, y0, x1, y1. */
  rectangle() {
    return [...this.toPlane(0, this.height), ...this.toPlane(this.width, 0)];
  }
  /** Functions for drawing loops: x and y in pixels. */
  maps() {
    const { scale, width, height, x, y } = this;
    return [(px) => width / 2 + (px - x) * scale, (py) => height / 2 - (py - y) * scale];
  }
}
