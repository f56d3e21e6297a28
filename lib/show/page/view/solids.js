// Hexahedra: a layer that has quantities and names, and is drawn in space alone (space.js).

class Solids {
  constructor(json) {
    Object.assign(this, layerBase(json));
    this.count = this.quantities[0].values.length;
    this.regions = intsOf(json.regions); // of the elements of a layer
    this.regionNames = json.regionNames;
  }

  heading(item) {
    const quads = this.regions.length, region = this.regionNames[this.regions[item % quads]];
    return `${this.noun} ${item} · layer ${Math.floor(item / quads)} · ${region}`;
  }

  sizes() {
    return {};
  }
}
