
// Charts: lines over axes that the reader chooses, drawn as SVG.

class Chart {
  constructor(figure, data) {
    Object.assign(this, { figure, data, x: data.x[0][0], y: data.y[0][0], part: "total", log: [...data.log], point: null });
    this.names = [...new Set(data.lines.map(line => line.name))];
    this.on = new Set(this.names);
    this.dashes = new Map(data.lines.map(line => [line.name, line.look.split(" ")[2]]));
    // Many lines are too many: the first dozen is shown at first.
    if (this.names.length > 24) this.on = new Set(this.names.slice(0, 12));
    this.reading = polhode.make("p", { class: "reading", role: "status" });
    this.svg = polhode.make("svg", { tabindex: 0, role: "img", "aria-label": `${data.title}. Arrow keys go along and between lines.` });
    figure.querySelector("figcaption").before(this.controls(), this.legend(), this.svg, this.reading);
    this.svg.addEventListener("pointermove", event => this.near(event));
    this.svg.addEventListener("pointerleave", () => this.choose(null));
    this.svg.addEventListener("keydown", event => this.key(event));
    new ResizeObserver(() => this.draw()).observe(figure);
    polhode.dark.addEventListener("change", () => { this.paint(); this.draw(); });
    this.draw();
  }

  select(label, choices, current, change) {
    const options = choices.map(([key, words]) => polhode.make("option", { value: key, selected: key === current }, words));
    const field = polhode.make("select", {}, ...options);
    field.addEventListener("change", () => { change(field.value); this.point = null; this.draw(); });
    return polhode.make("label", {}, label, field);
  }

  controls() {
    const { data } = this;
    const box = polhode.make("div", { class: "controls" });
    box.append(this.select("y", data.y, this.y, value => { this.y = value; }));
    if (data.parts) {
      const parts = [["total", "total error"], ["truncation", "truncation"], ["rounding", "rounding"]];
      box.append(this.select("of it", parts, this.part, value => { this.part = value; }));
    }
    if (data.x.length > 1) box.append(this.select("x", data.x, this.x, value => { this.x = value; }));
    ["log x", "log y"].forEach((words, axis) => {
      const field = polhode.make("input", { type: "checkbox", checked: this.log[axis] });
      field.addEventListener("change", () => { this.log[axis] = field.checked; this.draw(); });
      box.append(polhode.make("label", {}, field, words));
    });
    return box;
  }

  legend() {
    this.keys = new Map();
    const list = polhode.make("ul", { class: "legend", "aria-label": "Lines: press to switch, with Shift to show one alone" });
    for (const name of this.names) {
      const swatch = polhode.make("i");
      const button = polhode.make("button", { type: "button", class: "key", title: "Shift: this one alone" }, swatch, name);
      button.addEventListener("click", event => this.toggle(name, event.shiftKey));
      button.addEventListener("dblclick", () => this.toggle(name, true));
      this.keys.set(name, { button, swatch });
      list.append(polhode.make("li", {}, button));
    }
    const all = polhode.make("button", { type: "button", class: "key" }, "all");
    all.addEventListener("click", () => { this.on = new Set(this.names); this.draw(); });
    list.append(polhode.make("li", {}, all));
    this.paint();
    return list;
  }

  paint() {
    for (const line of this.data.lines) {
      const colour = polhode.shown(line.look);
      const gap = `repeating-linear-gradient(90deg, ${colour} 0 4px, transparent 4px 6px)`;
      this.keys.get(line.name).swatch.style.background = this.dashes.get(line.name) ? gap : colour;
    }
  }

  toggle(name, alone) {
    if (alone) this.on = new Set([name]);
    else if (!this.on.delete(name)) this.on.add(name);
    this.point = null;
    this.draw();
  }

  /** The points of a line on the chosen axes. */
  points(line) {
    const xs = line.x[this.x] ?? [];
    const ys = line.y[this.y] ?? [];
    const floors = line.f?.[this.y] ?? [];
    const value = at => {
      if (this.part === "rounding") return floors[at];
      return this.part === "truncation" && !(ys[at] > 10 * floors[at]) ? null : ys[at];
    };
    const able = (number, log) => Number.isFinite(number) && number !== null && (!log || Math.abs(number) > 0);
    const points = xs.map((x, at) => [x, value(at)]);
    return points.filter(([x, y]) => able(x, this.log[0]) && able(y, this.log[1]));
  }

  /** A place along an axis from a number. */
  along(number, axis) {
    return this.log[axis] ? Math.log10(Math.abs(number)) : number;
  }

  range(axis) {
    let [low, high] = [Infinity, -Infinity];
    for (const { points } of this.lines) {
      for (const point of points) {
        const place = this.along(point[axis], axis);
        low = Math.min(low, place);
        high = Math.max(high, place);
      }
    }
    if (low > high) return [0, 1];
    const margin = low === high ? 0.5 * (Math.abs(low) || 1) : 0.04 * (high - low);
    return [low - margin, high + margin];
  }

  ticks([low, high], axis, room) {
    const most = Math.max(2, Math.floor(room / (axis ? 34 : 64)));
    if (this.log[axis] && high - low > 1) {
      const every = Math.ceil((high - low) / most);
      const first = Math.ceil(low / every) * every;
      return Array.from({ length: Math.floor((high - first) / every) + 1 }, (_, n) => [first + n * every, 10 ** (first + n * every)]);
    }
    const rough = (high - low) / most;
    const power = 10 ** Math.floor(Math.log10(rough));
    const every = power * [1, 2, 5, 10].find(factor => factor * power >= rough);
    const count = Math.floor(high / every) - Math.ceil(low / every) + 1;
    const place = n => (Math.ceil(low / every) + n) * every;
    return Array.from({ length: Math.max(count, 0) }, (_, n) => [place(n), this.log[axis] ? 10 ** place(n) : place(n)]);
  }

  draw() {
    const width = Math.max(this.svg.clientWidth || this.figure.clientWidth - 24, 260);
    const height = Math.round(Math.min(460, Math.max(280, 0.6 * width)));
    const frame = { left: 70, top: 12, right: width - 12, bottom: height - 44 };
    this.lines = this.data.lines.filter(line => this.on.has(line.name))
      .map(line => ({ line, points: this.points(line) })).filter(({ points }) => points.length > 0);
    for (const [name, { button }] of this.keys) button.setAttribute("aria-pressed", this.on.has(name));
    const ranges = [this.range(0), this.range(1)];
    const at = (number, axis) => (this.along(number, axis) - ranges[axis][0]) / (ranges[axis][1] - ranges[axis][0]);
    this.place = ([x, y]) => [
      frame.left + at(x, 0) * (frame.right - frame.left), frame.bottom - at(y, 1) * (frame.bottom - frame.top)];
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.svg.style.height = `${height}px`;
    this.size = [width, height];
    this.svg.replaceChildren(...this.axes(frame, ranges), ...this.curves());
    this.mark = polhode.make("circle", { r: 6, fill: "none", "stroke-width": 2, visibility: "hidden" });
    this.svg.append(this.mark);
    this.choose(this.point);
  }

  axes(frame, ranges) {
    const shapes = [];
    const { make } = polhode;
    const label = (number, axis) => this.log[axis] && Math.abs(Math.log10(number) % 1) < 1e-9 && !(number >= 0.01 && number <= 100)
      ? polhode.number(number, 1).replace("1×", "") : polhode.number(number);
    for (const [place, number] of this.ticks(ranges[0], 0, frame.right - frame.left)) {
      const x = frame.left + (place - ranges[0][0]) / (ranges[0][1] - ranges[0][0]) * (frame.right - frame.left);
      shapes.push(make("line", { class: "grid", x1: x, x2: x, y1: frame.top, y2: frame.bottom }));
      shapes.push(make("text", { x, y: frame.bottom + 16, "text-anchor": "middle" }, label(number, 0)));
    }
    for (const [place, number] of this.ticks(ranges[1], 1, frame.bottom - frame.top)) {
      const y = frame.bottom - (place - ranges[1][0]) / (ranges[1][1] - ranges[1][0]) * (frame.bottom - frame.top);
      shapes.push(make("line", { class: "grid", x1: frame.left, x2: frame.right, y1: y, y2: y }));
      shapes.push(make("text", { x: frame.left - 6, y: y + 4, "text-anchor": "end" }, label(number, 1)));
    }
    shapes.push(make("rect", { class: "frame", x: frame.left, y: frame.top, width: frame.right - frame.left, height: frame.bottom - frame.top }));
    const words = this.data.x.find(([key]) => key === this.x)[1];
    shapes.push(make("text", { x: (frame.left + frame.right) / 2, y: frame.bottom + 36, "text-anchor": "middle" }, words));
    if (!this.lines.length) {
      shapes.push(make("text", { x: (frame.left + frame.right) / 2, y: (frame.top + frame.bottom) / 2, "text-anchor": "middle" }, "nothing to show"));
    }
    return shapes;
  }

  /** A path for each line, with a dot at each point where these are few. */
  curves() {
    return this.lines.map(({ line, points }) => {
      const places = points.map(point => this.place(point).map(value => value.toFixed(1)));
      const dot = ([x, y]) => `M${x} ${y}m-2.5 0a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0`;
      const path = "M" + places.map(place => place.join(" ")).join("L");
      const dots = places.length <= 40 && this.lines.length <= 80 ? places.map(dot).join("") : "";
      const look = { fill: "none", stroke: polhode.shown(line.look), "stroke-width": 1.6, "stroke-dasharray": this.dashes.get(line.name) || null };
      return polhode.make("path", { class: "line", d: path + dots, "data-name": line.name, ...look });
    });
  }

  /** The point next to the pointer. */
  near(event) {
    const box = this.svg.getBoundingClientRect();
    const scale = this.size[0] / box.width;
    const [x, y] = [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
    let best = null;
    let least = 60 ** 2;
    this.lines.forEach(({ points }, line) => points.forEach((point, at) => {
      const [px, py] = this.place(point);
      const distance = (px - x) ** 2 + (py - y) ** 2;
      if (distance < least) { least = distance; best = [line, at]; }
    }));
    this.choose(best);
  }

  key(event) {
    const moves = { ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowUp: [-1, 0], ArrowDown: [1, 0] };
    const move = moves[event.key];
    if (!move || !this.lines.length) return;
    event.preventDefault();
    const [line, at] = this.point ?? [0, -1];
    const next = (line + move[0] + this.lines.length) % this.lines.length;
    const last = this.lines[next].points.length - 1;
    this.choose([next, Math.max(0, Math.min(at + move[1], last))]);
  }

  /** Says and marks a point. */
  choose(point) {
    this.point = point;
    const own = point && this.lines[point[0]];
    const [x, y] = own?.points[point[1]] ?? [];
    if (x === undefined) {
      this.mark.setAttribute("visibility", "hidden");
      this.reading.textContent = "";
      return;
    }
    const [cx, cy] = this.place([x, y]);
    for (const [name, value] of Object.entries({ cx, cy, stroke: polhode.shown(own.line.look), visibility: "visible" })) {
      this.mark.setAttribute(name, value);
    }
    const words = (list, key) => list.find(([own]) => own === key)[1];
    const note = own.line.note ? ` (${own.line.note})` : "";
    this.reading.textContent = `${own.line.name}${note}: ${words(this.data.x, this.x)} ${polhode.number(x)}, `
      + `${words(this.data.y, this.y)} ${polhode.number(y)}`;
  }
}
