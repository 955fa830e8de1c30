
// Tables: sorted by a click on the head of a column, filtered by a field over them.

/** Rows from which a table has a field to filter it. */
const FILTERED = 12;

/** What a cell is sorted by: its first number with its power of ten, or its text. */
function keyOf(cell) {
  const text = cell.textContent.trim();
  const digits = { "⁰": 0, "¹": 1, "²": 2, "³": 3, "⁴": 4, "⁵": 5, "⁶": 6, "⁷": 7, "⁸": 8, "⁹": 9, "⁻": "-" };
  const plain = text.replaceAll("−", "-").replace(/(\d),(?=\d{3})/g, "$1");
  const found = plain.match(/^[^\p{L}\d-]*\(?(-?\d+(?:\.\d+)?)/u);
  if (!found) return text.toLowerCase();
  const power = plain.match(/×10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)/);
  const raised = power ? Number([...power[1]].map(c => digits[c]).join("")) : 0;
  return Number(found[1]) * 10 ** raised;
}

function sortable(table) {
  const body = table.tBodies[0];
  const box = table.parentElement;
  const scrolls = () => box.classList.contains("wide") && (box.scrollWidth > box.clientWidth || box.scrollHeight > box.clientHeight);
  if (scrolls()) {
    box.tabIndex = 0;
    box.setAttribute("role", "region");
    box.setAttribute("aria-label", "Table, scrolls");
  }
  if (!body || body.rows.length < 2) return;
  [...table.tHead.rows[0].cells].forEach((head, column) => {
    const button = polhode.make("button", { type: "button" }, ...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const falling = head.getAttribute("aria-sort") === "ascending";
      for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", falling ? "descending" : "ascending");
      const rows = [...body.rows].map(row => [keyOf(row.cells[column]), row]);
      const rank = key => typeof key === "number" ? 0 : key === "–" || key === "" ? 2 : 1;
      rows.sort(([a], [b]) => {
        if (rank(a) !== rank(b)) return rank(a) - rank(b);
        const order = typeof a === "number" ? a - b : a < b ? -1 : a > b ? 1 : 0;
        return falling ? -order : order;
      });
      body.append(...rows.map(([, row]) => row));
    });
  });
  if (body.rows.length >= FILTERED) filter(table, body);
}

function filter(table, body) {
  const field = polhode.make("input", { type: "search" });
  const count = polhode.make("span", { role: "status" });
  field.addEventListener("input", () => {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const row of body.rows) {
      const text = row.textContent.toLowerCase();
      row.hidden = !words.every(word => text.includes(word));
      shown += row.hidden ? 0 : 1;
    }
    count.textContent = words.length ? ` ${shown} of ${body.rows.length} rows` : "";
  });
  table.parentElement.before(polhode.make("label", { class: "filter" }, "Filter rows ", field, count));
}

/** A table from data: drawn when the part that folds it is opened, or on paper. */
function folded(part) {
  const box = part.querySelector(".table");
  let drawn = null;
  const draw = () => drawn ??= polhode.unpacked(box).then(rows => {
    const { make } = polhode;
    const heads = ["verdict", "scheme", "claim", "quantity", "measured", "detail"];
    const cell = (text, attributes = {}) => make("td", attributes, text);
    const body = rows.map(row => make("tr", {}, cell(row.outcome, { class: `badge ${row.class}` }), cell(row.scheme), cell(row.claim),
      cell(row.quantity), cell(row.measured, { class: "n" }), cell(row.known ? `${row.detail} Known: ${row.known}` : row.detail)));
    const table = make("table", { class: "data" }, make("thead", {}, make("tr", {}, ...heads.map(head => make("th", { scope: "col" }, head)))),
      make("tbody", {}, ...body));
    box.replaceChildren(make("div", { class: "wide" }, table));
    sortable(table);
  });
  part.addEventListener("toggle", () => { if (part.open) draw(); });
  // A page of one scene is ready to be printed; the page of everything draws what is asked for.
  if (!document.body.classList.contains("single")) requestIdleCallback(draw, { timeout: 2000 });
}
