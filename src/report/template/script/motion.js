
// The motion: body, polhode and path of an axis, a scheme beside the truth.

/** Sums of differences, in lists of `width` numbers. */
function summed(differences, width, scale) {
  const values = [];
  for (let at = 0; at < differences.length; at += width) {
    const last = values[values.length - 1];
    values.push(Array.from({ length: width }, (_, n) => differences[at + n] + (last ? last[n] : 0)));
  }
  return values.map(list => list.map(value => value * scale));
}

/** A vector turned by a quaternion (w, x, y, z). */
function turned([w, x, y, z], v) {
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const u = [x, y, z];
  const t = cross(u, v).map(value => 2 * value);
  const c = cross(u, t);
  return v.map((value, n) => value + w * t[n] + c[n]);
}

class Motion {
  constructor(figure, data) {
    const run = own => ({
      ...own, turn: summed(own.turn, 4, 1 / data.parts), spin: summed(own.spin, 3, data.largest / data.parts) });
    this.figure = figure;
    this.data = data;
    const runs = data.runs.map(run);
    this.truth = runs.find(own => own.name === "");
    this.runs = runs.filter(own => own.name !== "");
    this.frames = this.truth.turn.length - 1;
    // A run whose steps are the states has nothing between them.
    for (const own of this.runs) own.coarse = own.step > 0.99 * data.end / this.frames;
    // Seen from the side and above, z up.
    this.view = [0.9, 0.35];
    this.at = 0;
    this.playing = false;
    this.size = this.shape();
    this.build();
    this.choose();
    polhode.dark.addEventListener("change", () => this.draw());
    new ResizeObserver(() => this.draw()).observe(figure);
  }

  /** Half edges of the box that has the moments, the longest 1. */
  shape() {
    const moments = this.data.moments;
    const half = moments.reduce((sum, value) => sum + value, 0) / 2;
    const edges = moments.map(value => Math.sqrt(Math.max(half - value, 0)));
    const longest = Math.max(...edges) || 1;
    return edges.map(edge => Math.max(edge / longest, 0.04));
  }

  build() {
    const { make } = polhode;
    const schemes = [...new Set(this.runs.map(run => run.name))];
    const option = (value, words) => make("option", { value }, words);
    this.scheme = make("select", {}, ...schemes.map(name => option(name, name)));
    this.step = make("select");
    this.button = make("button", { type: "button", class: "key", "aria-pressed": "false" }, "Play");
    this.slider = make("input", { type: "range", min: 0, max: this.frames, value: 0, step: 1 });
    this.speed = make("select", {}, option(0.25, "slow"), option(1, "normal"), option(4, "fast"));
    this.speed.value = "1";
    const label = (words, field) => make("label", {}, words, field);
    const controls = make("div", { class: "controls" }, this.button, label("scheme", this.scheme), label("step", this.step),
      label("time", this.slider), label("speed", this.speed));
    const view = (words, description) => {
      const canvas = make("canvas", { role: "img", tabindex: 0, "aria-label": `${description}. Arrow keys turn the view.` });
      return [canvas, make("div", {}, canvas, make("p", {}, words))];
    };
    const views = [
      view("The body: filled the scheme, dashed the truth", "The body as a box"),
      view("Polhode on the inertia ellipsoid", "Path of the angular velocity on the inertia ellipsoid, in principal axes"),
      view("Path of the axis of the largest moment in space", "Path of a principal axis on the unit sphere"),
    ];
    this.canvases = views.map(([canvas]) => canvas);
    this.reading = make("p", { class: "reading" });
    this.figure.querySelector("figcaption").before(controls, make("div", { class: "views" }, ...views.map(([, box]) => box)), this.reading);
    this.listen(schemes);
  }

  listen() {
    this.scheme.addEventListener("change", () => this.choose());
    this.step.addEventListener("change", () => this.choose(true));
    this.slider.addEventListener("input", () => { this.at = Number(this.slider.value); this.draw(); });
    this.button.addEventListener("click", () => this.play(!this.playing));
    for (const canvas of this.canvases) {
      canvas.addEventListener("pointerdown", event => canvas.setPointerCapture(event.pointerId));
      canvas.addEventListener("pointermove", event => {
        if (event.buttons) this.look(0.01 * event.movementX, 0.01 * event.movementY);
      });
      canvas.addEventListener("keydown", event => {
        const move = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key];
        if (move) { event.preventDefault(); this.look(...move); }
      });
    }
  }

  look(sideways, up) {
    this.view = [this.view[0] - sideways, Math.max(-1.5, Math.min(1.5, this.view[1] + up))];
    this.draw();
  }

  /** Takes the run of the chosen scheme and step. */
  choose(keepStep = false) {
    const own = this.runs.filter(run => run.name === this.scheme.value);
    if (!keepStep) {
      const words = run => `h = ${polhode.number(run.step)} s`;
      this.step.replaceChildren(...own.map((run, n) => polhode.make("option", { value: n }, words(run))));
    }
    this.run = own[Number(this.step.value)] ?? own[0] ?? this.truth;
    this.draw();
  }

  play(on) {
    this.playing = on;
    this.button.setAttribute("aria-pressed", on);
    this.button.textContent = on ? "Pause" : "Play";
    if (!on) return;
    if (this.at >= this.frames) this.at = 0;
    let before = null;
    const frame = now => {
      if (!this.playing) return;
      // 20 states a second: a turn takes about a second.
      this.at += before === null ? 0 : (now - before) / 50 * Number(this.speed.value);
      before = now;
      if (this.at >= this.frames) { this.at = this.frames; this.play(false); }
      this.slider.value = Math.round(this.at);
      this.draw();
      if (this.playing) requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  /** The state that is shown: of a coarse run the last that was computed, and no mixture of two. */
  now() {
    return this.run.coarse ? Math.floor(this.at) : this.at;
  }

  /** The quaternion between two states. */
  turnAt(run) {
    const at = this.now();
    const from = Math.min(Math.floor(at), this.frames);
    const [a, b] = [run.turn[from], run.turn[Math.min(from + 1, this.frames)]];
    const sign = a.reduce((sum, value, n) => sum + value * b[n], 0) < 0 ? -1 : 1;
    const part = at - from;
    const mixed = a.map((value, n) => value + part * (sign * b[n] - value));
    const length = Math.hypot(...mixed);
    return mixed.map(value => value / length);
  }

  /** A canvas ready to be drawn on, and where a place in space falls: x, y and depth. */
  pen(canvas) {
    const size = Math.max(canvas.clientWidth, 120);
    const ratio = Math.min(devicePixelRatio || 1, 2);
    canvas.width = canvas.height = Math.round(size * ratio);
    const pen = canvas.getContext("2d");
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    const [a, b] = this.view;
    const place = ([x, y, z]) => {
      const [u, v] = [-Math.sin(a) * x + Math.cos(a) * y, Math.cos(a) * x + Math.sin(a) * y];
      return [size / 2 + 0.38 * size * u, size / 2 - 0.38 * size * (Math.cos(b) * z - Math.sin(b) * v), Math.cos(b) * v + Math.sin(b) * z];
    };
    return { pen, place, size };
  }

  inks() {
    const style = getComputedStyle(document.documentElement);
    return { ink: style.getPropertyValue("--ink").trim(), soft: style.getPropertyValue("--soft").trim(), rule: style.getPropertyValue("--rule").trim() };
  }

  draw() {
    this.body();
    this.polhode();
    this.axis();
    const time = this.data.end * this.now() / this.frames;
    const [a, b] = [this.turnAt(this.run), this.turnAt(this.truth)];
    const cosine = Math.abs(a.reduce((sum, value, n) => sum + value * b[n], 0));
    const angle = 2 * Math.acos(Math.min(cosine, 1));
    this.slider.setAttribute("aria-valuetext", `${polhode.number(time)} s`);
    this.reading.textContent = `t = ${polhode.number(time)} s of ${polhode.number(this.data.end)} s; `
      + `the scheme is ${angle < 1e-3 ? "less than 0.001" : polhode.number(angle)} rad off`;
  }

  body() {
    const { pen, place } = this.pen(this.canvases[0]);
    const corner = n => this.size.map((edge, axis) => (n >> axis & 1 ? edge : -edge) * 0.75);
    const faces = [[0, 2, 6, 4], [1, 3, 7, 5], [0, 1, 5, 4], [2, 3, 7, 6], [0, 1, 3, 2], [4, 5, 7, 6]];
    const outline = (turn, stroke) => faces.map(face => face.map(n => place(turned(turn, corner(n))))).forEach(stroke);
    const path = places => {
      pen.beginPath();
      places.forEach(([x, y], n) => n ? pen.lineTo(x, y) : pen.moveTo(x, y));
      pen.closePath();
    };
    const depth = places => places.reduce((sum, one) => sum + one[2], 0);
    const turn = this.turnAt(this.run);
    const sides = faces.map(face => face.map(n => place(turned(turn, corner(n))))).sort((a, b) => depth(a) - depth(b));
    const colour = polhode.shown(this.run.look);
    sides.forEach((side, n) => {
      path(side);
      pen.globalAlpha = 0.25 + 0.09 * n;
      pen.fillStyle = colour;
      pen.fill();
      pen.globalAlpha = 1;
      pen.strokeStyle = colour;
      pen.stroke();
    });
    pen.setLineDash([4, 3]);
    pen.strokeStyle = this.inks().ink;
    outline(this.turnAt(this.truth), places => { path(places); pen.stroke(); });
    pen.setLineDash([]);
  }

  /** A line through places in space; what lies behind is pale. */
  trace(pen, place, points, colour, width, dashed) {
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.setLineDash(dashed ? [4, 3] : []);
    const places = points.map(place);
    for (const behind of [true, false]) {
      pen.globalAlpha = behind ? 0.35 : 1;
      pen.beginPath();
      for (let n = 1; n < places.length; n++) {
        if ((places[n][2] < 0) !== behind) continue;
        pen.moveTo(places[n - 1][0], places[n - 1][1]);
        pen.lineTo(places[n][0], places[n][1]);
      }
      pen.stroke();
    }
    pen.globalAlpha = 1;
    pen.setLineDash([]);
  }

  dot(pen, [x, y, depth], colour, radius = 5) {
    pen.globalAlpha = depth < 0 ? 0.35 : 1;
    pen.fillStyle = colour;
    pen.beginPath();
    pen.arc(x, y, radius, 0, 2 * Math.PI);
    pen.fill();
    pen.globalAlpha = 1;
  }

  /** Circles of latitude and longitude on an ellipsoid of these half axes. */
  globe(pen, place, half) {
    const ring = point => Array.from({ length: 49 }, (_, n) => point(n * Math.PI / 24).map((value, axis) => value * half[axis]));
    const { rule } = this.inks();
    for (const level of [-0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75]) {
      const [c, s] = [Math.cos(level * Math.PI / 2), Math.sin(level * Math.PI / 2)];
      this.trace(pen, place, ring(t => [c * Math.cos(t), c * Math.sin(t), s]), rule, 1, false);
    }
    for (let n = 0; n < 6; n++) {
      const [c, s] = [Math.cos(n * Math.PI / 6), Math.sin(n * Math.PI / 6)];
      this.trace(pen, place, ring(t => [c * Math.cos(t), s * Math.cos(t), Math.sin(t)]), rule, 1, false);
    }
  }

  polhode() {
    const { pen, place } = this.pen(this.canvases[1]);
    const moments = this.data.moments;
    const start = this.truth.spin[0];
    const energy = moments.reduce((sum, moment, n) => sum + moment * start[n] ** 2, 0);
    const half = moments.map(moment => moment > 0 ? Math.sqrt(energy / moment) : 0);
    const most = Math.max(...half, ...this.truth.spin.flat().map(Math.abs)) || 1;
    const scaled = spin => spin.map(value => value / most);
    if (energy > 0) this.globe(pen, place, half.map(value => value / most));
    this.paths(pen, place, run => run.spin.map(scaled));
  }

  axis() {
    const { pen, place } = this.pen(this.canvases[2]);
    const largest = this.data.moments.indexOf(Math.max(...this.data.moments));
    const unit = [0, 1, 2].map(n => n === largest ? 1 : 0);
    this.globe(pen, place, [1, 1, 1]);
    this.paths(pen, place, run => run.turn.map(turn => turned(turn, unit)));
  }

  /** What was passed of the truth and of the run, and where they are. */
  paths(pen, place, points) {
    const { ink } = this.inks();
    const until = Math.ceil(this.now()) + 1;
    const colour = polhode.shown(this.run.look);
    const [truth, run] = [points(this.truth), points(this.run)];
    const shown = list => this.at > 0 ? list.slice(0, until) : list;
    this.trace(pen, place, shown(run), colour, this.run.coarse ? 1 : 2.5, false);
    if (this.run.coarse) for (const point of shown(run)) this.dot(pen, place(point), colour, 2);
    this.trace(pen, place, shown(truth), ink, 1.2, true);
    const now = Math.min(Math.round(this.now()), this.frames);
    this.dot(pen, place(truth[now]), ink);
    this.dot(pen, place(run[now]), colour);
  }
}
