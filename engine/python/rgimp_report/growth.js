// The specimen with the particles that have failed so far.
"use strict";

function decode(text, Kind) {
  return new Kind(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer);
}

const failed = {
  place: decode(growth.place, Float32Array),
  step: decode(growth.step, Int32Array),
  mode: decode(growth.mode, Uint8Array),
};
const kColours = {1: "#c00d1e", 2: "#ffab00"};  // those of rgimp-plot: tension, shear
const kSpecimen = "#dbe8f5", kLine = "#555";

// How many of the particles, which are in the order of their failure, failed up to a step.
function countUntil(step) {
  let low = 0, high = failed.step.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (failed.step[middle] <= step) low = middle + 1; else high = middle;
  }
  return low;
}

// Millimetres to the picture's: right, down, and towards the viewer.
function cameraOf(azimuth) {
  if (growth.dimension === 2) return (at) => [at[0], -at[1], 0];
  const a = azimuth * Math.PI / 180, e = 18 * Math.PI / 180;
  return ([x, y, z]) => {
    const right = x * Math.cos(a) - z * Math.sin(a), back = x * Math.sin(a) + z * Math.cos(a);
    return [right, -(y * Math.cos(e) - back * Math.sin(e)), back * Math.cos(e) + y * Math.sin(e)];
  };
}

// Scale and origin that show the specimen from wherever it is looked at.
function frameOf(canvas) {
  const middle = growth.low.map((low, axis) => (low + growth.high[axis]) / 2);
  let [width, height] = growth.low.map((low, axis) => growth.high[axis] - low);
  if (growth.dimension === 3) {
    const depth = growth.high[2] - growth.low[2];
    width = Math.hypot(width, depth);
    height += 0.31 * width;  // sin 18 degrees
  }
  const room = Math.min(420, document.documentElement.clientWidth - 32);
  const scale = Math.min(room / width, 520 / height) * 0.96;
  const size = [width * scale / 0.96, height * scale / 0.96];
  const density = window.devicePixelRatio || 1;
  canvas.width = Math.round(size[0] * density);
  canvas.height = Math.round(size[1] * density);
  canvas.style.width = `${size[0]}px`;
  return {scale: scale * density, middle, origin: [canvas.width / 2, canvas.height / 2]};
}

function drawOutlines(pen, toPicture) {
  if (growth.dimension === 3) {
    for (const edges of [...growth.bodies, ...growth.flaws]) {
      pen.beginPath();
      edges.forEach((at, index) => {
        const [x, y] = toPicture(at);
        if (index % 2) pen.lineTo(x, y); else pen.moveTo(x, y);
      });
      pen.stroke();
    }
    return;
  }
  [[growth.bodies, kSpecimen], [growth.flaws, "#fff"]].forEach(([outlines, colour]) => {
    for (const outline of outlines) {
      pen.beginPath();
      outline.forEach((at) => pen.lineTo(...toPicture(at).slice(0, 2)));
      pen.closePath();
      pen.fillStyle = colour;
      pen.fill();
      pen.stroke();
    }
  });
}

function drawGrowth(canvas, step, azimuth) {
  const {scale, middle, origin} = frameOf(canvas), camera = cameraOf(azimuth);
  const toPicture = (at) => {
    const [x, y, near] = camera(at.map((value, axis) => value - middle[axis]));
    return [origin[0] + scale * x, origin[1] + scale * y, near];
  };
  const pen = canvas.getContext("2d");
  pen.clearRect(0, 0, canvas.width, canvas.height);
  pen.strokeStyle = kLine;
  drawOutlines(pen, toPicture);
  const dots = [], size = Math.max(1.5, growth.size * scale);
  for (let index = 0, end = countUntil(step); index < end; ++index) {
    const at = failed.place.subarray(index * growth.dimension, (index + 1) * growth.dimension);
    dots.push([...toPicture(Array.from(at)), failed.mode[index]]);
  }
  if (growth.dimension === 3) dots.sort((one, other) => one[2] - other[2]);
  for (const [x, y, , mode] of dots) {
    pen.fillStyle = kColours[mode] || "#4d4d4d";
    pen.fillRect(x - size / 2, y - size / 2, size, size);
    if (growth.dimension === 3) {  // else neighbours are one blot
      pen.lineWidth = 0.4;
      pen.strokeStyle = "#fff";
      pen.strokeRect(x - size / 2, y - size / 2, size, size);
    }
  }
}
