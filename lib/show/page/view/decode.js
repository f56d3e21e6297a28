// The page's data as typed arrays. Positions become lengths relative to the centre of the page's frame.

function bytesOf(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

const intsOf = (text) => new Int32Array(bytesOf(text).buffer);
const shortsOf = (text) => new Int16Array(bytesOf(text).buffer);
const floatsOf = (text) => new Float32Array(bytesOf(text).buffer);

function positionsOf(text, step) {
  const units = intsOf(text);
  const positions = new Float64Array(units.length);
  for (let i = 0; i < units.length; ++i) positions[i] = units[i] * step;
  return positions;
}

/** A quantity with its range and the items sorted from the worst to the best. */
function decodeQuantity(json) {
  const values = floatsOf(json.values);
  const order = Uint32Array.from(values.keys());
  const sign = json.worst === "high" ? -1 : 1;
  order.sort((a, b) => sign * (values[a] - values[b]) || a - b);
  const ends = [values[order[0]], values[order[order.length - 1]]];
  const [least, greatest] = sign < 0 ? ends.reverse() : ends;
  const isGiven = json.high > json.low;
  const low = isGiven ? Math.min(json.low, least) : least, high = isGiven ? json.high : greatest;
  const isLog = json.log && low > 0;
  const isJudged = Boolean(json.worst) && isGiven; // what is good and bad is known, not only what is more and less
  return { title: json.title, worst: json.worst, isJudged, values, order, least, greatest, low, high, isLog };
}

/** Where a value lies on the ramp: 0 is bad, 1 is good; of figures that are neither, 0 is low, 1 is high. */
function rampPosition(quantity, value) {
  const at = quantity.isLog ? Math.log : (x) => x;
  const width = at(quantity.high) - at(quantity.low);
  const t = width > 0 ? (at(value) - at(quantity.low)) / width : quantity.isJudged ? 1 : 0.5;
  const clamped = Math.min(1, Math.max(0, t));
  return isReversed(quantity) ? 1 - (width > 0 ? clamped : 0) : clamped;
}

/** Whether great values are bad. */
const isReversed = (quantity) => quantity.isJudged && quantity.worst === "high";

/** Boxes of items: x0, y0, x1, y1 each. */
function emptyBoxes(count) {
  const boxes = new Float64Array(4 * count);
  for (let i = 0; i < count; ++i) boxes.set([Infinity, Infinity, -Infinity, -Infinity], 4 * i);
  return boxes;
}

function include(boxes, item, x, y) {
  const k = 4 * item;
  if (x < boxes[k]) boxes[k] = x;
  if (y < boxes[k + 1]) boxes[k + 1] = y;
  if (x > boxes[k + 2]) boxes[k + 2] = x;
  if (y > boxes[k + 3]) boxes[k + 3] = y;
}

/** The items whose boxes meet the rectangle [x0, x1] x [y0, y1]. */
function itemsWithin(boxes, rectangle) {
  const [x0, y0, x1, y1] = rectangle;
  const items = [];
  for (let i = 0, k = 0; k < boxes.length; ++i, k += 4)
    if (boxes[k] <= x1 && boxes[k + 2] >= x0 && boxes[k + 1] <= y1 && boxes[k + 3] >= y0) items.push(i);
  return items;
}

const layerTypes = {
  cells: (json, step) => new Cells(json, step),
  chains: (json, step) => new Chains(json, step),
  marks: (json, step) => new Marks(json, step),
  discs: (json, step) => new Discs(json, step),
  arrows: (json, step) => new Arrows(json, step),
  samples: (json, step) => new Samples(json, step),
  solids: (json) => new Solids(json),
};

/** The tabs with their layers. The boundary is a layer of every tab that has a face, or of the page's first face. */
function decodeSheets(page) {
  const withFace = page.sheets.find((sheet) => sheet.boundary);
  const sheets = page.sheets.map((sheet) => {
    const boundary = sheet.only_in_space ? null : sheet.boundary || (withFace && withFace.boundary);
    const layers = boundary ? [boundary, ...sheet.layers] : sheet.layers;
    const decoded = layers.map((json) => layerTypes[json.type](json, page.step));
    for (const layer of decoded) layer.isAdded = page.comparison && ["arcs", "lines", "mesh"].includes(layer.key);
    return { ...sheet, layers: decoded };
  });
  if (page.comparison) shareRanges(sheets);
  return sheets;
}

/** Equal colours of A and B stand for equal values. */
function shareRanges([a, b]) {
  for (const quantity of a.layers.flatMap((layer) => layer.quantities)) {
    const all = b.layers.flatMap((layer) => layer.quantities);
    const other = all.find((candidate) => candidate.title === quantity.title);
    if (!other) continue;
    quantity.low = other.low = Math.min(quantity.low, other.low);
    quantity.high = other.high = Math.max(quantity.high, other.high);
    quantity.isLog = other.isLog = quantity.isLog && other.isLog;
  }
}

let numLayers = 0;

/** Fields that all layers have. */
function layerBase(json) {
  return {
    number: numLayers++, key: json.key, title: json.title, noun: json.noun, names: json.names || [], isShown: json.shown, isAdded: false,
    quantities: (json.quantities || []).map(decodeQuantity), quantity: json.quantities && !json.plain ? 0 : -1,
  };
}
