// Slider, play button, and what follows them.
"use strict";

const kDashes = {"-": "none", "--": "7 4", "-.": "8 3 2 3", ":": "2 4"};
const kPlaySeconds = 10;
const byId = (name) => document.getElementById(name);
const scaled = (values, factor) => values.map((value) => value === null ? null : value * factor);

function makeCharts() {
  const {columns, energies} = curves;
  const closure = {name: "closure (µm)", values: scaled(columns.closure_m, 1e6)};
  return [
    new Chart(byId("stress_closure"), closure, "axial stress (MPa)", [
      {name: "axial stress (MPa)", colour: "#0072b2", dash: "none",
        values: scaled(columns.axial_stress_Pa, 1e-6)}],
    "Axial stress against closure of the platens"),
    new Chart(byId("failures"), closure, "failed particles", [
      {name: "in tension", colour: "#c00d1e", dash: "none", values: columns.failed_tension},
      {name: "in shear", colour: "#b37700", dash: "7 4", values: columns.failed_shear}],
    "Failed particles against closure of the platens"),
    new Chart(byId("energy"), {name: "time (ms)", values: scaled(columns.time_s, 1e3)},
      `energy (${curves.energy_unit})`,
      energies.map((one) => ({...one, dash: kDashes[one.dash]})), "Energies over time"),
  ];
}

// The last row of the history up to a step.
function rowOf(step) {
  const after = curves.columns.step.findIndex((other) => other > step);
  return after < 0 ? curves.columns.step.length - 1 : Math.max(after - 1, 0);
}

const charts = makeCharts(), slider = byId("slider"), play = byId("play"), turn = byId("turn");

function show() {
  const frame = growth.frames[Number(slider.value)];
  const stress = frame.stress === null ? "not a number" : `${(frame.stress * 1e-6).toPrecision(4)} MPa`;
  const closure = frame.closure === null ? "not a number" : `${format(frame.closure * 1e6)} µm`;
  byId("step").textContent = frame.step.toLocaleString("en");
  byId("closure").textContent = closure;
  byId("stress").textContent = stress;
  byId("tension").textContent = frame.tension.toLocaleString("en");
  byId("shear").textContent = frame.shear.toLocaleString("en");
  slider.setAttribute("aria-valuetext", `step ${frame.step}`);
  byId("specimen").setAttribute("aria-label",
    `Step ${frame.step}: ${frame.tension} particles failed in tension, ${frame.shear} in shear`);
  drawGrowth(byId("specimen"), frame.step, turn ? Number(turn.value) : 0);
  charts.forEach((chart) => chart.show(rowOf(frame.step)));
}

let playing = null;  // the timer, while it plays

function stop() {
  clearInterval(playing);
  playing = null;
  play.textContent = "Play";
}

play.addEventListener("click", () => {
  if (playing !== null) { stop(); return; }
  if (slider.value === slider.max) slider.value = 0;
  play.textContent = "Pause";
  playing = setInterval(() => {
    slider.value = Number(slider.value) + 1;
    show();
    if (slider.value === slider.max) stop();
  }, 1000 * kPlaySeconds / growth.frames.length);
});
slider.addEventListener("input", () => { if (playing !== null) stop(); show(); });
if (turn) turn.addEventListener("input", show);
window.addEventListener("resize", show);
show();
