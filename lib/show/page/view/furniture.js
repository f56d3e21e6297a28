// What lies above the drawing: axes with figures, the scale bar, the outline of the item in focus.

/** 1, 2 or 5 by a power of ten, at least `least`. */
function roundStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * [1, 2, 5, 10].find((m) => m * power >= least * (1 - 1e-12));
}

function tickText(value, step) {
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  if (Math.abs(value) >= 1e6 || digits > 6) return value.toExponential(3);
  return (Math.abs(value) < step / 2 ? 0 : value).toFixed(digits).replace("-", "−");
}

function haloText(context, theme, text, x, y) {
  context.lineWidth = 3.5;
  context.lineJoin = "round";
  context.strokeStyle = theme.halo;
  context.strokeText(text, x, y);
  context.fillText(text, x, y);
}

function drawAxes(context, view, theme, page) {
  const step = roundStep(90 / view.scale), rectangle = view.rectangle();
  context.font = "11px system-ui, sans-serif";
  context.fillStyle = theme.faint;
  const tick = (x, y, dx, dy) => {
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x + dx, y + dy);
    context.lineWidth = 1;
    context.strokeStyle = theme.faint;
    context.stroke();
  };
  context.textAlign = "center";
  context.textBaseline = "alphabetic";
  for (let i = Math.ceil((rectangle[0] + page.x) / step); i * step <= rectangle[2] + page.x; ++i) {
    const x = view.toScreen(i * step - page.x, 0)[0];
    if (x < 44 || x > view.width - 24) continue;
    tick(x, view.height, 0, -6);
    haloText(context, theme, tickText(i * step, step), x, view.height - 10);
  }
  context.textAlign = "left";
  context.textBaseline = "middle";
  for (let i = Math.ceil((rectangle[1] + page.y) / step); i * step <= rectangle[3] + page.y; ++i) {
    const y = view.toScreen(0, i * step - page.y)[1];
    if (y > view.height - 34 || y < 14) continue;
    tick(0, y, 6, 0);
    haloText(context, theme, tickText(i * step, step), 10, y);
  }
}

function drawScaleBar(context, view, theme, page) {
  const length = roundStep(80 / view.scale), pixels = length * view.scale;
  const x = view.width - pixels - 20, y = view.height - 28;
  for (const [width, colour] of [[5, theme.halo], [2, theme.ink]]) {
    context.lineWidth = width;
    context.strokeStyle = colour;
    context.beginPath();
    context.moveTo(x, y - 5);
    context.lineTo(x, y);
    context.lineTo(x + pixels, y);
    context.lineTo(x + pixels, y - 5);
    context.stroke();
  }
  context.font = "12px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "alphabetic";
  context.fillStyle = theme.ink;
  haloText(context, theme, `${figure(length)} ${page.unit}`.trim(), x + pixels / 2, y - 6);
}

/** "A" or "B" at the upper edge of a pane. */
function drawTitle(context, theme, title) {
  context.font = "bold 14px system-ui, sans-serif";
  context.textAlign = "left";
  context.textBaseline = "top";
  context.fillStyle = theme.ink;
  haloText(context, theme, title, 12, 10);
}

/** Where the pointer is in the other pane. */
function drawCross(context, view, theme, [x, y]) {
  const [px, py] = view.toScreen(x, y);
  context.strokeStyle = theme.accent;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(px - 9, py);
  context.lineTo(px + 9, py);
  context.moveTo(px, py - 9);
  context.lineTo(px, py + 9);
  context.stroke();
}

function drawFocus(context, view, theme, focus) {
  const path = focus.layer.outline(view, focus.item);
  for (const [width, colour] of [[5, theme.halo], [2.4, theme.accent]]) {
    context.lineWidth = width;
    context.strokeStyle = colour;
    context.stroke(path);
  }
}

/** A ring about an item that is too small to be seen. */
function drawRing(context, view, theme, focus) {
  const { layer, item } = focus, k = 4 * item;
  if (!layer.boxes || layer instanceof Samples) return;
  const [x0, y0] = view.toScreen(layer.boxes[k], layer.boxes[k + 3]);
  const [x1, y1] = view.toScreen(layer.boxes[k + 2], layer.boxes[k + 1]);
  if (Math.max(x1 - x0, y1 - y0) > 14) return;
  context.lineWidth = 2;
  context.strokeStyle = theme.accent;
  context.beginPath();
  context.arc((x0 + x1) / 2, (y0 + y1) / 2, 14, 0, 2 * Math.PI);
  context.stroke();
}
