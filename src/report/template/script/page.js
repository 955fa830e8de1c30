"use strict";
// Every page works without this script; it adds search, sorting, charts and motion.
const polhode = {
  /** An element with attributes and children. */
  make(tag, attributes = {}, ...children) {
    const svg = ["svg", "g", "path", "line", "rect", "text", "circle"].includes(tag);
    const made = svg ? document.createElementNS("http://www.w3.org/2000/svg", tag) : document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
      if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
      else if (value !== false && value !== null) made.setAttribute(name, value === true ? "" : value);
    }
    made.append(...children);
    return made;
  },

  /** The data that a figure holds: zlib in base 64. */
  async unpacked(figure) {
    const text = figure.querySelector(".packed").textContent.trim();
    const bytes = Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return JSON.parse(await new Response(stream).text());
  },

  dark: matchMedia("(prefers-color-scheme: dark)"),

  /** The colour of a look on the ground of the page. */
  shown(look) {
    return look.split(" ")[this.dark.matches ? 1 : 0];
  },

  /** A number in a few digits. */
  number(value, digits = 3) {
    if (value === null || !Number.isFinite(value)) return "–";
    if (value === 0) return "0";
    const size = Math.abs(value);
    const text = size >= 1e-3 && size < 1e5 ? String(Number(value.toPrecision(digits))) : value.toExponential(digits - 1);
    const raised = power => [...power].map(c => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]).join("");
    return text.replace(/e\+?(-?)(\d+)/, (_, sign, power) => "×10" + raised(sign + power)).replace(/^-/, "−");
  },
};

/** Links of the contents that hold what is typed; Enter opens the first. */
function search(contents) {
  const field = contents.querySelector("#search");
  const found = contents.querySelector("#found");
  const items = [...contents.querySelectorAll("li")];
  const groups = [...contents.querySelectorAll("details")];
  const opened = groups.map(group => group.open);
  const update = () => {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    const fits = item => words.every(word => item.textContent.toLowerCase().includes(word));
    for (const item of items) item.hidden = !fits(item);
    groups.forEach((group, index) => { group.open = words.length > 0 || opened[index]; });
    const count = items.filter(item => !item.hidden).length;
    found.textContent = words.length ? `${count} found` : "";
  };
  field.addEventListener("input", update);
  field.addEventListener("keydown", event => {
    if (event.key === "Escape") { field.value = ""; update(); }
    if (event.key === "Enter") items.find(item => !item.hidden)?.querySelector("a").click();
  });
}

/** Folded parts are open on paper. */
function unfold() {
  let folded = [];
  addEventListener("beforeprint", () => {
    folded = [...document.querySelectorAll("main details:not([open])")];
    for (const part of folded) part.open = true;
  });
  addEventListener("afterprint", () => { for (const part of folded) part.open = false; });
}

document.addEventListener("DOMContentLoaded", () => {
  document.documentElement.classList.add("live");
  const contents = document.querySelector("#contents");
  if (contents) search(contents);
  unfold();
  for (const table of document.querySelectorAll("table.data")) sortable(table);
  for (const part of document.querySelectorAll("details.verdicts")) folded(part);
  const kinds = { chart: Chart, motion: Motion };
  const seen = new IntersectionObserver(entries => {
    for (const entry of entries.filter(entry => entry.isIntersecting)) {
      seen.unobserve(entry.target);
      const figure = entry.target;
      polhode.unpacked(figure).then(data => {
        figure.polhode = new kinds[figure.dataset.kind](figure, data);
        figure.classList.add("drawn");
      });
    }
  }, { rootMargin: "300px" });
  for (const figure of document.querySelectorAll("figure.chart")) {
    if (figure.querySelector(".packed")) seen.observe(figure);
  }
});
