// What the marks, lines and colours of the shown layers mean: the legend in the panel.

const legendSize = [30, 18]; // pixels of a mark

/** A small canvas on which `draw(context)` draws; wider for ramps. */
function legendMark(draw, width = legendSize[0]) {
  const canvas = element("canvas", {}), ratio = Math.min(2, window.devicePixelRatio || 1), height = legendSize[1];
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  canvas.style.width = `${width}px`;
  const context = canvas.getContext("2d");
  context.scale(ratio, ratio);
  context.lineJoin = context.lineCap = "round";
  draw(context);
  return canvas;
}

/** A line from left to right. */
function legendLine(colour, width, dashes = []) {
  return legendMark((context) => {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.setLineDash(dashes);
    context.stroke(new Path2D(`M3 9H${legendSize[0] - 3}`));
  });
}

const legendRow = (mark, text) => element("p", {}, mark, text);

/** Rows of the layers that are shown, each meaning once. */
function showLegend(layers, theme) {
  const rows = new Map();
  for (const layer of layers)
    for (const [text, mark] of layer.legend ? layer.legend(theme) : []) if (!rows.has(text)) rows.set(text, mark);
  byId("legend").hidden = !rows.size;
  byId("legend-rows").replaceChildren(...[...rows].map(([text, mark]) => legendRow(mark, text)));
}

/** The field: colours of the cross angle, contours of its components, crosses. */
function legendOfField(theme, isUnit) {
  const ramp = legendMark((context) => {
    for (let x = 0; x < 90; ++x) {
      context.fillStyle = css(theme.angleColours[Math.round((256 * x) / 89)]);
      context.fillRect(x, 3, 1, 12);
    }
  }, 90);
  const cross = legendMark((context) => {
    context.strokeStyle = `rgba(${theme.line},0.6)`;
    context.stroke(new Path2D("M8 5L22 13M11 16L19 2"));
  });
  const rows = [["cross angle, −45° to 45°", ramp], ["directions of grid lines", cross]];
  if (isUnit) return rows;
  const grey = legendMark((context) => {
    context.fillStyle = theme.calm;
    context.fillRect(4, 3, legendSize[0] - 8, 12);
  });
  rows.push(["near a zero of the field", grey]);
  ["u = 0", "v = 0; zeros are where both cross"].forEach((text, k) => rows.push([text, legendLine(theme.contours[k], 1.6)]));
  return rows;
}

/** Marks of nodes by kind and valence; `title` is that of their layer. */
function legendOfMarks(layer, theme) {
  const rows = new Map();
  for (let item = 0; item < layer.count; ++item) {
    const kind = layer.kinds[item], valence = layer.valences[item];
    const text = {
      node: `irregular node, valence ${valence}`, boundary: `node on the boundary, valence ${valence}`, corner: "corner",
      dot: "crossing or end of lines", hollow: `${layer.title}, valence ${valence}`,
    }[kind];
    if (rows.has(text)) continue;
    const path = layer.shape(item, legendSize[0] / 2, legendSize[1] / 2, 0.85);
    rows.set(text, legendMark((context) => layer.draw(context, theme, item, path)));
  }
  return [...rows];
}
