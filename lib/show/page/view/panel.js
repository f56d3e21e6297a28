// The part of the page beside the drawing: tabs, layers, histogram, figures, steps, keys.

/** An element with properties and children; texts are never read as markup. */
function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

const byId = (id) => document.getElementById(id);

function tableRows(rows) {
  return rows.map(([label, value]) => element("tr", {}, element("td", {}, label), element("td", {}, value)));
}

/** The titles of the tabs; equal ones are numbered. */
function tabTitles(sheets) {
  if (sheets.isComparison) return sheets.map((sheet, i) => `${"AB"[i]}: ${sheet.name || sheet.title}`);
  return sheets.map((sheet, i) => {
    const equal = sheets.filter((other) => other.title === sheet.title);
    return equal.length > 1 ? `${sheet.title} ${equal.indexOf(sheet) + 1}` : sheet.title;
  });
}

/** The stages; with a report of the run a tab for it behind them, whose number is theirs. */
function showTabs(sheets, current, choose, hasReport) {
  const titles = [...tabTitles(sheets), ...(hasReport ? ["Report"] : [])];
  byId("tabs").replaceChildren(
    ...titles.map((title, i) => {
      const tab = element("button", { textContent: title, title: `Key ${i + 1}`, onclick: () => choose(i) });
      tab.setAttribute("role", "tab");
      tab.setAttribute("aria-selected", String(i === current));
      return tab;
    }),
  );
  byId("tabs").children[current].scrollIntoView({ block: "nearest", inline: "nearest" });
}

function layerBox(layer, member, title, changed) {
  const box = element("input", { type: "checkbox", checked: layer[member] });
  box.onchange = () => {
    layer[member] = box.checked;
    changed();
  };
  return element("label", {}, box, title);
}

/** Boxes to switch layers, and for each layer with quantities the one that its colours show. */
function showLayers(layers, changed) {
  const rows = [];
  for (const layer of layers) {
    rows.push(layerBox(layer, "isShown", layer.title, changed));
    if (layer.quantities.length) rows.push(quantityChoice(layer, changed));
  }
  byId("layers").replaceChildren(...rows);
}

/** Boxes to add layers of other stages. */
function showOthers(sheets, current, changed) {
  const titles = tabTitles(sheets), rows = [];
  sheets.forEach((sheet, i) => {
    for (const layer of i === current ? [] : sheet.layers.filter((other) => other.key !== "boundary" && !(other instanceof Solids)))
      rows.push(layerBox(layer, "isAdded", `${titles[i]}: ${layer.title}`, changed));
  });
  byId("others").replaceChildren(...rows);
  byId("others").parentElement.hidden = !rows.length;
}

function quantityChoice(layer, changed) {
  const select = element("select", { ariaLabel: `Colours of ${layer.title}` });
  const titles = ["no colours", ...layer.quantities.map((quantity) => quantity.title)];
  titles.forEach((title, i) => select.append(element("option", { value: i - 1, textContent: title })));
  select.value = layer.quantity;
  select.onchange = () => {
    layer.quantity = Number(select.value);
    changed();
  };
  return select;
}

/** The layer whose quantity the histogram shows and whose worst item is looked for. */
function measuredLayer(layers) {
  const shown = layers.filter((layer) => layer.isShown && layer.quantities.length);
  return shown.findLast((layer) => layer.quantity >= 0) || shown[shown.length - 1] || null;
}

function showMeasure(layers, theme) {
  const layer = measuredLayer(layers), quantity = layer && layer.quantities[Math.max(0, layer.quantity)];
  byId("measure").hidden = !quantity;
  if (!quantity) return;
  byId("measure-title").textContent = quantity.title;
  drawHistogram(byId("histogram"), quantity, theme);
  byId("measure-text").textContent = limitsText(quantity);
}

function limitsText(quantity) {
  const median = quantity.values[quantity.order[quantity.order.length >> 1]];
  const limits = [["least", quantity.least], ["median", median], ["greatest", quantity.greatest]]
    .map(([name, value]) => `${name}\u00a0${figure(value)}`).join(", ");
  return `${limits}${quantity.isLog ? "; logarithmic scale" : ""}`;
}

function histogramCounts(quantity, count) {
  const counts = new Array(count).fill(0);
  const isFlipped = isReversed(quantity);
  for (const value of quantity.values) {
    const t = rampPosition(quantity, value);
    ++counts[Math.min(count - 1, Math.floor((isFlipped ? 1 - t : t) * count))];
  }
  return counts;
}

/** Bars in the colours of the drawing, which stand on a strip of them from the least value to the greatest; heights grow
 *  with the root of the count, so that few bad elements are seen. */
function drawHistogram(canvas, quantity, theme) {
  const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth || 260, height = 120, foot = 16;
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  const context = canvas.getContext("2d"), counts = histogramCounts(quantity, 40), most = Math.max(...counts);
  const colours = coloursOf(theme, quantity);
  context.scale(ratio, ratio);
  const bar = width / counts.length, first = counts.findIndex((count) => count), last = counts.findLastIndex((count) => count);
  context.fillStyle = theme.rule;
  context.fillRect(0, height - foot + 1, width, 2);
  counts.forEach((count, i) => {
    const t = (i + 0.5) / counts.length, good = isReversed(quantity) ? 1 - t : t;
    context.fillStyle = css(colours[Math.round(good * (colours.length - 1))]);
    if (i >= first && i <= last) context.fillRect(i * bar, height - foot, bar + 0.5, 4);
    const tall = count ? Math.max(2, Math.sqrt(count / most) * (height - foot - 6)) : 0;
    context.fillRect(i * bar + 0.5, height - foot - 2 - tall, bar - 1, tall);
    context.strokeStyle = theme.faint;
    context.lineWidth = 0.5;
    if (tall) context.strokeRect(i * bar + 0.5, height - foot - 2 - tall, bar - 1, tall);
  });
  context.fillStyle = theme.faint;
  context.font = "11px system-ui, sans-serif";
  context.fillText(figure(quantity.low), 0, height - 1);
  context.textAlign = "right";
  context.fillText(figure(quantity.high), width, height - 1);
}

function showFacts(sheet) {
  byId("caption").textContent = sheet.caption;
  byId("facts").replaceChildren(...tableRows(sheet.facts));
  byId("steps").replaceChildren(
    ...sheet.steps.map(([tool, version, options]) =>
      element("li", {}, element("strong", {}, `${tool} ${version}`), ` ${optionsText(options)}`)),
  );
}

/** Rows [label, value] of the counts and qualities of a stage. */
function figuresOf(sheet) {
  const rows = [...sheet.facts];
  for (const { title, values, order, least, greatest } of sheet.layers.flatMap((layer) => layer.quantities))
    rows.push([`${title}: least`, figure(least)], ["median", figure(values[order[order.length >> 1]]), title],
      ["greatest", figure(greatest), title]);
  return rows;
}

/** A table of the figures of two stages beside each other. */
function showComparison(sheets) {
  const keyOf = ([label, , group]) => `${group || ""}/${label}`;
  const [a, b] = sheets.map((sheet) => new Map(figuresOf(sheet).map((row) => [keyOf(row), row])));
  const rows = [...new Set([...a.keys(), ...b.keys()])].map((key) => {
    const texts = [a, b].map((rowsOf) => (rowsOf.get(key) || ["", "–"])[1]);
    return [(a.get(key) || b.get(key))[0], ...texts];
  });
  byId("facts").className = "comparison";
  byId("facts").replaceChildren(
    ...[["", "A", "B"], ...rows].map((row) => element("tr", {}, ...row.map((text) => element("td", {}, text)))),
  );
}

/** '{"order":4}' as "--order 4". */
function optionsText(json) {
  const options = JSON.parse(json || "{}");
  const text = (value) => (typeof value === "string" ? value : JSON.stringify(value));
  const given = Object.entries(options).filter(([, value]) => value !== "" && value !== false && text(value) !== "[]");
  return given.map(([key, value]) => (value === true ? `--${key}` : `--${key} ${text(value)}`)).join(" ");
}

const keys = [
  ["←  ↑  →  ↓", "move"], ["+  −", "zoom"], ["0", "show everything"], ["v", "show the body in a far field"], ["1 … 9", "stage by its number"],
  ["[  ]", "stage before, next stage"], ["w  W", "next worst element, one back"], ["q  Q", "next quantity, one back"],
  ["l", "given names, numbers too, neither"], ["f", "find by number or name"], ["t", "light or dark"], ["r", "report of the run"], ["s", "side by side, of a comparison"], ["p", "panel"],
  ["c  C", "next direction of the cut in space, one back"], [",  .", "move the cut"], ["x", "other side of the cut"], ["Esc", "close"],
  ["?", "these keys"],
];

function fillHelp() {
  const rows = keys.map(([names, text]) => {
    const caps = names.split("  ").flatMap((name) => [element("kbd", {}, name), " "]);
    return element("tr", {}, element("td", {}, ...caps), element("td", {}, text));
  });
  const about = "Drag to move, turn the wheel or pinch to zoom, point at an element to see its figures. A mesh in space turns by dragging it; a plane cuts it, and elements on one side of that are left out.";
  byId("help").replaceChildren(element("h2", {}, "Keys"), element("table", {}, ...rows), element("p", {}, about));
}
