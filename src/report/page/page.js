"use strict";
// The report of a run: reads the data that stand in the page, and draws them. Everything is in SI units.
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const by = (id) => document.getElementById(id);
  const show = (id) => { by(id).hidden = false; return by(id); };
  const element = (tag, text, parent) => {
    const made = document.createElement(tag);
    if (text !== undefined) made.textContent = text;
    if (parent) parent.append(made);
    return made;
  };
  const readable = (name) => name.replaceAll("_", " ");
  const number = (x) => {
    if (x === null || x === undefined || Number.isNaN(x)) return "–";
    if (typeof x !== "number") return String(x);
    if (Number.isInteger(x) && Math.abs(x) < 1e7) return x.toLocaleString("en").replaceAll(",", "\u202f");
    const size = Math.abs(x);
    return size !== 0 && (size < 1e-3 || size >= 1e6) ? x.toExponential(3) : String(Number(x.toPrecision(4)));
  };
  const withUnit = (x, unit) => (unit ? `${number(x)} ${unit}` : number(x));
  const HUES = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#3c3c3c", "#8a6d3b", "#7b61ff", "#a0a7b4"];

  // ---- figures -------------------------------------------------------------------------------------------------------------------
  // An uncertainty stands beside what it is of.
  const figures = (parent, values) => {
    for (const [name, value] of Object.entries(values)) {
      if (name.endsWith("_uncertainty") || value === null || typeof value === "object") continue;
      const row = element("div", undefined, parent);
      element("span", readable(name), row);
      const off = values[`${name}_uncertainty`];
      element("b", off === undefined || off === null ? number(value) : `${number(value)} ± ${number(off)}`, row);
    }
  };
  const group = (parent, title, values) => {
    if (!values || !Object.keys(values).length) return;
    element("h3", title, parent);
    figures(parent, values);
    for (const [name, inner] of Object.entries(values)) {
      if (inner && typeof inner === "object" && !Array.isArray(inner)) group(parent, `${title}: ${readable(name)}`, inner);
    }
  };

  const summary = data.summary;
  by("state").textContent = data.state;
  if (summary) {
    if (summary.warnings && summary.warnings.length) {
      const list = show("warnings").querySelector("ul");
      for (const warning of summary.warnings) element("li", warning.text || warning.what || JSON.stringify(warning), list);
    }
    const outcome = by("outcome").querySelector(".figures");
    const parts = {
      outcome: "Outcome", remnants: "Bodies", intrusion: "Fall into dust", restitution: "Bounce", fragments: "Pieces", deposit: "Heap",
      rigid: "Rigid bodies", nbody: "Bodies for an N-body program", late_stage: "Late stage", errors: "Errors against the exact solution",
    };
    for (const [key, title] of Object.entries(parts)) group(outcome, title, summary[key]);
    if (summary.threshold) {
      const { impacts, uncertainty_parts, ...found } = summary.threshold;
      found.q_star_d_uncertainty = found.uncertainty;
      found.q_star_rd_uncertainty = found.uncertainty_of_q_star_rd;
      delete found.uncertainty;
      delete found.uncertainty_of_q_star_rd;
      group(outcome, "Threshold (J/kg)", found);
      group(outcome, "Uncertainty of Q*_D by its parts (J/kg)", uncertainty_parts);
    }
    if (outcome.children.length) show("outcome");
    const trust = {};
    for (const key of ["energy_drift", "energy_drift_over_left", "momentum_drift", "angular_momentum_drift", "density_drift"]) {
      if (summary[key] !== null && summary[key] !== undefined) trust[key] = summary[key];
    }
    figures(show("trust").querySelector(".figures"), trust);
    const cost = {};
    for (const key of ["particles", "steps", "time", "ranks", "threads_per_rank", "wall_seconds", "core_seconds", "mpi_wait_seconds",
      "updates_per_core_second", "bytes_per_particle", "list_builds", "refused_steps", "imbalance"]) cost[key] = summary[key];
    figures(show("cost").querySelector(".figures"), cost);
    const phases = Object.entries(summary.phases || {}).filter(([, share]) => share > 0.002).sort((a, b) => b[1] - a[1]);
    phases.forEach(([name, share], k) => {
      const part = element("div", undefined, by("cost").querySelector(".shares"));
      part.style.cssText = `flex: ${share}; background: ${HUES[k % HUES.length]}`;
      part.title = `${readable(name)} ${(100 * share).toFixed(1)} %`;
      const entry = element("li", undefined, by("cost").querySelector(".legend"));
      element("i", undefined, entry).style.background = HUES[k % HUES.length];
      entry.append(part.title);
    });
  }
  if (document.querySelector("#pictures img")) show("pictures");
  if (data.scene) show("scene").querySelector("pre").textContent = data.scene;

  // ---- plots ---------------------------------------------------------------------------------------------------------------------
  const plotWidth = (parent) => Math.max(320, parent.clientWidth);
  const axis = (label, log) => ({ label, values: (_, ticks) => ticks.map((x) => (x === null ? "" : log ? x.toExponential(0) : number(x))) });

  const history = data.history;
  if (history && history.columns.length > 1 && history.columns[0].length > 1) {
    const section = show("history");
    const select = by("quantity");
    const at = history.names.indexOf("time");
    const names = history.names.map((name, k) => [name, k]).filter(([name, k]) => k !== at && name !== "step" && history.columns[k].some((x) => x !== null));
    const usual = ["kinetic_energy", "internal_energy", "potential_energy"];
    for (const [name, k] of names) {
      const option = element("option", readable(name) + (history.units[k] ? ` [${history.units[k]}]` : ""), select);
      option.value = k;
      option.selected = usual.includes(name);
    }
    let plot = null;
    const draw = () => {
      const chosen = [...select.selectedOptions].map((option) => Number(option.value));
      if (plot) plot.destroy();
      const parent = section.querySelector(".plot");
      const log = by("logarithmic").checked;
      const line = (k, n) => ({ label: readable(history.names[k]), stroke: HUES[n % HUES.length], width: 1.5, value: (_, x) => withUnit(x, history.units[k]) });
      const values = chosen.map((k) => (log ? history.columns[k].map((x) => (x > 0 ? x : null)) : history.columns[k]));
      plot = new lib.uPlot({
        width: plotWidth(parent), height: 320,
        scales: { x: { time: false }, y: { distr: log ? 3 : 1 } },
        axes: [axis(`time [${history.units[at] || "s"}]`), axis(chosen.length === 1 ? history.units[chosen[0]] : "", log)],
        series: [{ label: "time", value: (_, x) => withUnit(x, "s") }, ...chosen.map(line)],
      }, [history.columns[at], ...values], parent);
    };
    select.addEventListener("change", draw);
    by("logarithmic").addEventListener("change", draw);
    window.addEventListener("resize", draw);
    draw();
  }

  if (summary && summary.threshold && summary.threshold.impacts.length) {
    const section = show("search");
    const impacts = summary.threshold.impacts.map((impact, k) => ({ ...impact, folder: data.impacts[k] })).sort((a, b) => a.q - b.q);
    const parent = section.querySelector(".plot");
    const open = (impact) => { if (impact && impact.folder) window.open(`${impact.folder}/report.html`); };
    const points = (label, stroke) => ({ label, stroke, width: 1, points: { show: true, size: 9, fill: stroke }, value: (_, x) => number(x) });
    const plot = new lib.uPlot({
      width: plotWidth(parent), height: 340,
      scales: { x: { time: false }, y: { range: [0, 1.02] } },
      axes: [axis("Q [J/kg]"), axis("M_lr / M_target")],
      series: [{ label: "Q", value: (_, x) => withUnit(x, "J/kg") }, points("largest remnant", HUES[0]), points("at twice the time", HUES[5])],
    }, [impacts.map((i) => i.q), impacts.map((i) => i.largest_remnant_fraction), impacts.map((i) => i.largest_remnant_fraction_later)], parent);
    plot.over.addEventListener("click", () => open(impacts[plot.cursor.idx]));
    section.querySelector(".hint").textContent = "A click on a point opens the report of its impact.";
    const table = element("table", undefined, section.querySelector(".impacts"));
    const head = element("tr", undefined, table);
    for (const title of ["impact", "Q [J/kg]", "size [m]", "M_lr / M_target", "core-seconds"]) element("th", title, head);
    for (const impact of impacts) {
      const row = element("tr", undefined, table);
      const link = element("a", impact.folder, element("td", undefined, row));
      link.href = `${impact.folder}/report.html`;
      for (const x of [impact.q, impact.length, impact.largest_remnant_fraction, impact.core_seconds]) element("td", number(x), row);
    }
  }

  // ---- particles -----------------------------------------------------------------------------------------------------------------
  const particles = data.particles;
  if (!particles || !particles.snapshots.length) return;
  const section = show("particles");
  const view = by("view");
  const renderer = (() => {
    try {
      return new lib.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    } catch {
      element("p", "This browser has no WebGL: particles cannot be shown.", view);
      return null;
    }
  })();
  if (!renderer) return;
  renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
  view.append(renderer.domElement);
  const bytes = (k) => {
    const text = atob(by(`snapshot-${k}`).textContent.trim());
    return Uint8Array.from(text, (c) => c.charCodeAt(0));
  };
  const cache = new Map();
  // Places as parts of the snapshot's box in 16 bits, then each column as part of its range in 8 bits.
  const load = (k) => {
    if (!cache.has(k)) {
      const raw = bytes(k);
      const n = particles.snapshots[k].count;
      const places = new Uint16Array(raw.buffer.slice(0, 6 * n));
      const { low, high } = particles.snapshots[k];
      const position = new Float32Array(3 * n);
      for (let i = 0; i < 3 * n; i += 1) position[i] = (low[i % 3] + (high[i % 3] - low[i % 3]) * (places[i] / 65535) - middle[i % 3]) / extent;
      cache.set(k, { n, position, column: (c) => raw.subarray(6 * n + c * n, 6 * n + (c + 1) * n) });
    }
    return cache.get(k);
  };
  // The first snapshot gives the scale: later ones may fill a space far larger.
  const first = particles.snapshots[0];
  const middle = first.low.map((low, k) => 0.5 * (low + first.high[k]));
  const extent = Math.max(...first.low.map((low, k) => first.high[k] - low)) || 1;
  const flat = first.high[2] - first.low[2] === 0;
  const colours = new Uint8Array(256 * 4);
  particles.colours.forEach((rgb, k) => colours.set([...rgb, 255], 4 * k));
  const map = new lib.DataTexture(colours, 256, 1, lib.RGBAFormat);
  map.magFilter = map.minFilter = lib.LinearFilter;
  map.needsUpdate = true;
  const material = new lib.ShaderMaterial({
    glslVersion: lib.GLSL3,
    uniforms: { map: { value: map }, size: { value: 1 }, height: { value: 1 }, cut: { value: [0, 0, 0, 0] } },
    vertexShader: `
      in float value;
      out float shade;
      out float away;
      uniform float size, height;
      uniform vec4 cut;
      void main() {
        vec4 seen = modelViewMatrix * vec4(position, 1.0);
        shade = value;
        away = dot(cut.xyz, position) - cut.w;
        gl_Position = projectionMatrix * seen;
        gl_PointSize = max(1.5, size * height * projectionMatrix[1][1] / gl_Position.w);
      }`,
    fragmentShader: `
      in float shade;
      in float away;
      uniform sampler2D map;
      out vec4 colour;
      void main() {
        if (away > 0.0) discard;
        vec2 p = 2.0 * gl_PointCoord - 1.0;
        float r2 = dot(p, p);
        if (r2 > 1.0) discard;
        float light = 0.72 + 0.28 * sqrt(1.0 - r2);
        colour = vec4(light * texture(map, vec2((255.0 * shade + 0.5) / 256.0, 0.5)).rgb, 1.0);
      }`,
  });
  const geometry = new lib.BufferGeometry();
  const space = new lib.Scene();
  space.background = new lib.Color(0x10141c);
  const cloud = new lib.Points(geometry, material);
  cloud.frustumCulled = false;
  space.add(cloud);
  const camera = new lib.PerspectiveCamera(35, 1, 0.01, 1000);
  // Faces of ground, heaps and gravity point along z. The controls turn about what is up when they are made.
  camera.up.set(...(flat ? [0, 1, 0] : [0, 0, 1]));
  const controls = new lib.OrbitControls(camera, renderer.domElement);
  const lookAgain = () => {
    camera.position.set(...(flat ? [0, 0, 2.1] : [0.7, -1.4, 1.4]));
    controls.target.set(0, 0, 0);
    controls.update();
  };
  let current = { snapshot: particles.snapshots.length - 1, column: particles.usual };
  const select = by("column");
  particles.columns.forEach((column, k) => {
    const option = element("option", readable(column.name) + (column.unit ? ` [${column.unit}]` : ""), select);
    option.value = k;
  });
  const slider = by("snapshot");
  slider.max = particles.snapshots.length - 1;
  const render = () => renderer.render(space, camera);
  const update = () => {
    const { snapshot, column } = current;
    const loaded = load(snapshot);
    geometry.dispose();
    geometry.setAttribute("position", new lib.BufferAttribute(loaded.position, 3));
    geometry.setAttribute("value", new lib.BufferAttribute(loaded.column(column), 1, true));
    geometry.setDrawRange(0, loaded.n);
    const about = particles.columns[column];
    by("low").textContent = withUnit(about.low, about.unit);
    by("high").textContent = withUnit(about.high, about.unit);
    const share = particles.total > loaded.n ? `${number(loaded.n)} of ${number(particles.total)} particles` : `${number(loaded.n)} particles`;
    by("about").textContent = `${about.about}${about.logarithmic ? " Logarithmic scale." : ""} ${share}; turned by the mouse, nearer by its wheel.`;
    by("moment").textContent = `t = ${withUnit(particles.snapshots[snapshot].time, "s")}`;
    slider.value = snapshot;
    select.value = column;
    render();
  };
  const cut = () => {
    const chosen = by("axis").value;
    by("offset").disabled = !chosen;
    const normal = ["x", "y", "z"].map((name) => (name === chosen ? 1 : 0));
    material.uniforms.cut.value = chosen ? [...normal, 1.1 * (Number(by("offset").value) - 0.5)] : [0, 0, 0, 0];
    render();
  };
  const fit = () => {
    const [width, height] = [view.clientWidth, view.clientHeight];
    renderer.setSize(width, height);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    material.uniforms.height.value = 0.5 * height * renderer.getPixelRatio();
    material.uniforms.size.value = (particles.size / extent) * Number(by("size").value);
    render();
  };
  select.addEventListener("change", () => { current.column = Number(select.value); update(); });
  slider.addEventListener("input", () => { current.snapshot = Number(slider.value); update(); });
  by("axis").addEventListener("change", cut);
  by("offset").addEventListener("input", cut);
  by("size").addEventListener("input", fit);
  by("reset").addEventListener("click", () => { lookAgain(); render(); });
  let playing = null;
  by("play").addEventListener("click", () => {
    if (playing) { clearInterval(playing); playing = null; by("play").textContent = "Play"; return; }
    by("play").textContent = "Stop";
    playing = setInterval(() => { current.snapshot = (current.snapshot + 1) % particles.snapshots.length; update(); }, 250);
  });
  by("play").disabled = slider.disabled = particles.snapshots.length < 2;
  controls.addEventListener("change", render);
  window.addEventListener("resize", fit);
  const canvas = by("bar").querySelector("canvas").getContext("2d");
  const strip = canvas.createImageData(256, 1);
  strip.data.set(colours);
  canvas.putImageData(strip, 0, 0);
  lookAgain();
  update();
  fit();

  // For tests: mean time of a frame, ms, each waited for.
  window.report = {
    renderer: () => {
      const gl = renderer.getContext();
      const named = gl.getExtension("WEBGL_debug_renderer_info");
      return named ? gl.getParameter(named.UNMASKED_RENDERER_WEBGL) : "unknown";
    },
    frameTime: (frames) => {
      const gl = renderer.getContext();
      const pixel = new Uint8Array(4);
      const start = performance.now();
      for (let k = 0; k < frames; k += 1) { render(); gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel); }
      return (performance.now() - start) / frames;
    },
    // Colours of the canvas, as [r, g, b, ...] from the bottom left.
    pixels: () => {
      render();
      const gl = renderer.getContext();
      const found = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
      gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, found);
      return { width: gl.drawingBufferWidth, height: gl.drawingBufferHeight, found };
    },
  };
})();
