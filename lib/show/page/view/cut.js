// The cut of a mesh in space: a plane, and the side on which elements are left out, each whole.

const cutChoices = ["none", "x", "y", "z", "view"];

class Cut {
  constructor() {
    this.along = 0; // of cutChoices
    this.at = 0.5; // fraction of the extent along the direction
    this.sign = 1; // elements beyond the plane are left out; -1: the others
  }

  /** The direction across the plane; of "view" it turns with the view. */
  normal(axes) {
    return this.along === 4 ? axes[2] : [1, 2, 3].map((axis) => Number(axis === this.along));
  }

  /** Another direction; what is left out is what hides the rest. */
  choose(along, axes) {
    this.along = (along + cutChoices.length) % cutChoices.length;
    this.sign = product(this.normal(axes), axes[2]) < 0 ? -1 : 1;
  }

  /** Keeps the plane within the mesh. */
  move(by) {
    this.at = Math.min(1, Math.max(0, this.at + by));
  }

  /** Which elements are shown (1), by their middles; `extent`: [least, greatest] along the normal. */
  shown(middles, axes, extent) {
    const count = middles.length / 3, shown = new Uint8Array(count).fill(1);
    if (!this.along) return shown;
    const [x, y, z] = this.normal(axes), at = this.position(extent) + 1e-6 * (extent[1] - extent[0]);
    for (let e = 0, k = 0; e < count; ++e, k += 3)
      shown[e] = x * middles[k] + y * middles[k + 1] + z * middles[k + 2] > at === this.sign < 0;
    return shown;
  }

  position([least, greatest]) {
    return least + this.at * (greatest - least);
  }
}

/** The section of the panel; `pane` is the SpacePane. */
function showCut(pane, layer, unit) {
  const { cut } = pane, shown = pane.shown.reduce((sum, isShown) => sum + isShown, 0);
  byId("cut-along").value = cut.along;
  byId("cut-at").value = 100 * cut.at;
  byId("cut-at").hidden = byId("cut-side").hidden = byId("cut-text").hidden = !cut.along;
  if (!cut.along) return;
  const at = cut.position(pane.extentAlong(cut.normal(pane.axes)));
  const place = cut.along === 4 ? `${figure(Math.abs(at))} ${unit}`.trim() + (at < 0 ? " behind" : " before") + " the middle"
    : `${cutChoices[cut.along]} = ${figure(at + pane.middle[cut.along - 1])} ${unit}`.trim();
  byId("cut-text").textContent = `${place}: ${shown} of ${pane.shown.length} ${layer.title} shown`;
}

function listenToCut(page) {
  const { cut } = page.space;
  byId("cut-along").append(...cutChoices.map((name, value) => element("option", { value, textContent: name === "view" ? "the view" : name })));
  byId("cut-along").onchange = (event) => page.chooseCut(Number(event.target.value));
  byId("cut-at").oninput = (event) => {
    cut.at = event.target.value / 100;
    page.spaceMoved();
  };
}
