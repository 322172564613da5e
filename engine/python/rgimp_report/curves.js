// Curves as SVG, with the values at the step of the slider, or where one points.
"use strict";

const kWidest = 760, kNarrowest = 320, kHeight = 260, kLeft = 64, kBottom = 40, kTop = 10, kRight = 14;

function svgElement(name, attributes, text) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  return element;
}

// Round numbers between two values, some six of them.
function ticksOf(low, high) {
  const raw = (high - low) / 6, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= raw);
  const ticks = [];
  for (let tick = Math.ceil(low / step - 1e-9); tick * step <= high + 1e-9 * step; ++tick) {
    ticks.push(Number((tick * step).toPrecision(12)));
  }
  return ticks;
}

function format(value) {
  return value === null ? "not a number" : String(Number(value.toPrecision(4)));
}

function rangeOf(values, startsAtZero) {
  const finite = values.filter((value) => value !== null);
  let low = startsAtZero ? 0 : Infinity, high = startsAtZero ? 0 : -Infinity;
  for (const value of finite) { low = Math.min(low, value); high = Math.max(high, value); }
  return high > low ? [low, high] : [Number.isFinite(low) ? low : 0, (Number.isFinite(low) ? low : 0) + 1];
}

class Chart {
  // series: {name, colour, dash, values}; x: {name, values}
  constructor(place, x, yName, series, title) {
    this.x = x;
    // Drawn as wide as it is shown: else the letters shrink on a phone.
    this.width = Math.min(kWidest, Math.max(kNarrowest, place.clientWidth));
    this.series = series;
    this.xRange = rangeOf(x.values, false);
    this.yRange = rangeOf(series.flatMap((one) => one.values), true);
    this.svg = svgElement("svg", {viewBox: `0 0 ${this.width} ${kHeight}`, role: "img", "aria-label": title});
    this.drawAxes(x.name, yName);
    series.forEach((one) => this.drawCurve(one));
    this.cursor = this.svg.appendChild(svgElement("line", {
      y1: kTop, y2: kHeight - kBottom, stroke: "#333", "stroke-dasharray": "2 3"}));
    this.legend = document.createElement("figcaption");
    this.legend.className = "legend";
    place.append(this.svg, this.legend);
    this.svg.addEventListener("pointermove", (event) => this.point(event));
    this.svg.addEventListener("pointerleave", () => this.show(this.row));
  }

  across(value) {
    const [low, high] = this.xRange;
    return kLeft + (value - low) / (high - low) * (this.width - kLeft - kRight);
  }

  up(value) {
    const [low, high] = this.yRange;
    return kHeight - kBottom - (value - low) / (high - low) * (kHeight - kBottom - kTop);
  }

  drawAxes(xName, yName) {
    for (const tick of ticksOf(...this.yRange)) {
      const y = this.up(tick);
      this.svg.append(
        svgElement("line", {x1: kLeft, x2: this.width - kRight, y1: y, y2: y, stroke: "#ddd"}),
        svgElement("text", {x: kLeft - 6, y: y + 4, "text-anchor": "end"}, format(tick)));
    }
    for (const tick of ticksOf(...this.xRange)) {
      this.svg.append(svgElement("text", {
        x: this.across(tick), y: kHeight - kBottom + 16, "text-anchor": "middle"}, format(tick)));
    }
    this.svg.append(
      svgElement("text", {x: (this.width + kLeft) / 2, y: kHeight - 6, "text-anchor": "middle"}, xName),
      svgElement("text", {transform: `translate(12 ${(kHeight - kBottom) / 2}) rotate(-90)`,
        "text-anchor": "middle"}, yName));
  }

  drawCurve(one) {
    let path = "", pen = "M";
    one.values.forEach((value, row) => {
      if (value === null) { pen = "M"; return; }
      path += `${pen}${this.across(this.x.values[row]).toFixed(1)} ${this.up(value).toFixed(1)}`;
      pen = "L";
    });
    this.svg.append(svgElement("path", {d: path, fill: "none", stroke: one.colour,
      "stroke-width": 1.8, "stroke-dasharray": one.dash, "stroke-linecap": "round"}));
  }

  // The row whose x is nearest to where the pointer is.
  point(event) {
    const box = this.svg.getBoundingClientRect();
    const at = (event.clientX - box.left) / box.width * this.width;
    let nearest = 0;
    this.x.values.forEach((value, row) => {
      if (Math.abs(this.across(value) - at) < Math.abs(this.across(this.x.values[nearest]) - at)) {
        nearest = row;
      }
    });
    this.mark(nearest);
  }

  show(row) {
    this.row = row;
    this.mark(row);
  }

  mark(row) {
    const x = this.across(this.x.values[row]);
    this.cursor.setAttribute("x1", x);
    this.cursor.setAttribute("x2", x);
    const where = document.createElement("span");
    where.textContent = `${this.x.name}: ${format(this.x.values[row])}`;
    this.legend.replaceChildren(where, ...this.series.map((one) => {
      const entry = document.createElement("span");
      const key = svgElement("svg", {viewBox: "0 0 32 8", "aria-hidden": "true"});
      key.append(svgElement("line", {x1: 0, x2: 32, y1: 4, y2: 4, stroke: one.colour,
        "stroke-width": 2.5, "stroke-dasharray": one.dash}));
      entry.append(key, `${one.name}: ${format(one.values[row])}`);
      return entry;
    }));
  }
}
