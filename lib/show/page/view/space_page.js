// What the page does with the mesh in space of the chosen stage: the part of Page that concerns SpacePane.

class SpacePage {
  /** Whether the chosen stage is shown in space too, beside its chart. */
  get isSpatial() {
    return !this.isBeside && !this.isReport && Boolean(this.sheet.space);
  }
  /** Whether it is shown in space alone: hexahedra have no chart. */
  get isAlone() {
    return this.isSpatial && Boolean(this.sheet.only_in_space);
  }
  /** The layer that the pane in space shows. */
  get spatialLayer() {
    return this.sheet.layers.find((layer) => layer.key === "mesh");
  }

  drawSpace(isQuick) {
    if (!this.isSpatial) return;
    this.space.draw(this.theme, this.spatialLayer, isQuick);
    showCut(this.space, this.spatialLayer, this.data.unit);
  }

  /** What the pane in space shows is turned or cut: a quick picture, and a sharp one when it rests. */
  spaceMoved() {
    this.forget();
    this.mark(-1, false);
    cancelAnimationFrame(this.spaceFrame);
    this.spaceFrame = requestAnimationFrame(() => {
      this.drawSpace(true);
      clearTimeout(this.spaceTimer);
      this.spaceTimer = setTimeout(() => this.drawSpace(false), 120);
    });
  }

  chooseCut(along) {
    this.space.cut.choose(along, this.space.axes);
    this.spaceMoved();
  }

  moveCut(by) {
    if (!this.isSpatial || !this.space.cut.along) return this.tell("No mesh is cut: choose a direction of the cut (c).");
    this.space.cut.move(by);
    this.spaceMoved();
  }

  /** Shows the element in space under the pointer. */
  pointInSpace(px, py) {
    if (this.isPinned) return;
    const item = px < 0 ? -1 : this.space.itemAt(px, py);
    this.forget();
    this.mark(item);
    if (item < 0) return this.drawOverlay();
    this.focus = { layer: this.spatialLayer, item };
    this.showTip(px + byId("space").offsetLeft, py);
    this.drawOverlay();
  }

  /** The element that is marked in space. */
  mark(item, isPainted = true) {
    if (!this.isSpatial || item === this.space.marked) return;
    this.space.marked = item;
    if (isPainted) this.space.paint(this.theme, this.spatialLayer);
  }

  /** Cuts off what hides it. */
  goToSolid(item) {
    this.mark(item, false);
    if (!this.space.isSeen(item)) this.space.reveal(item);
    this.isPinned = true;
    this.drawSpace(false);
    this.showTip(...this.focusPoint());
    byId("status").textContent = this.focus.layer.heading(item);
  }

  /** By keys: of the drawing, or where there is none, of the mesh in space. */
  pan(dx, dy) {
    if (this.isAlone) this.space.turn(-dx / 3, -dy / 3);
    else this.view.pan(dx, dy);
  }
  zoomBy(factor) {
    if (this.isAlone) this.space.zoomBy(factor);
    else this.view.zoom(factor, this.view.width / 2, this.view.height / 2, this.limits);
  }
}
