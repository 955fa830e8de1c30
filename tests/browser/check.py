"""Opens every kind of page of a report and uses it. Usage: check.py BROWSER FOLDER SINGLE_FOLDER [PICTURE_FOLDER]"""

import gzip
import pathlib
import sys

from devtools import Browser

NARROW, WIDE = 390, 1400
MOST_NODES = 3000
# Bytes: of a page, of the index compressed, of the one page with everything in it, of the records, of the Markdown, of the whole folder.
PAGE, PACKED_INDEX, SINGLE, RECORDS, MARKDOWN, FOLDER = 1_000_000, 300_000, 8_000_000, 20_000_000, 200_000, 35_000_000

# Every figure with data is scrolled to, so that it is drawn.
DRAWN = """(async () => {
  const figures = [...document.querySelectorAll('figure.chart')].filter(one => one.querySelector('.packed'));
  for (const figure of figures) {
    for (let n = 0; n < 500 && !figure.polhode; n++) {
      // Once is not enough: charts that are drawn above move it out of view.
      figure.scrollIntoView();
      await new Promise(done => setTimeout(done, 20));
    }
  }
  scrollTo(0, 0);
  return figures.map(one => !!one.polhode);
})()"""

# The least contrast of any text with what lies behind it, and the smallest letters.
READABLE = """(() => {
  const rgb = text => (text.match(/[\\d.]+/g) || []).map(Number);
  const light = c => { const f = v => (v /= 255) <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
    return 0.2126 * f(c[0]) + 0.7152 * f(c[1]) + 0.0722 * f(c[2]); };
  const ground = element => { for (let e = element; e; e = e.parentElement) {
    const c = rgb(getComputedStyle(e).backgroundColor); if (c.length && c[3] !== 0) return c; } return [255, 255, 255]; };
  let least = 99, smallest = 99, where = '';
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const element = walker.currentNode.parentElement;
    if (!walker.currentNode.textContent.trim() || !element.checkVisibility() || element.closest('script, option')) continue;
    const style = getComputedStyle(element);
    const colour = rgb(element instanceof SVGElement ? style.fill : style.color);
    const [a, b] = [light(colour), light(ground(element))].sort((a, b) => b - a);
    const contrast = (a + 0.05) / (b + 0.05);
    if (contrast < least) { least = contrast; where = element.outerHTML.slice(0, 120); }
    smallest = Math.min(smallest, parseFloat(style.fontSize));
  }
  return { least, smallest, where };
})()"""


# The least height of small letters of the pictures that are shown: 14 pixels of a PNG.
LETTERS_OF_PICTURES = """(async () => {
  const shown = [...document.images].filter(one => one.checkVisibility());
  shown.forEach(one => { one.loading = 'eager'; });
  await Promise.all(shown.map(one => one.decode()));
  return Math.min(99, ...shown.map(one => 14 * one.getBoundingClientRect().width / one.naturalWidth));
})()"""


class Check:
    def __init__(self, browser, folder, single, pictures):
        self.page, self.folder, self.single, self.pictures = browser.page(), folder, single, pictures
        self.faults = []
        self.count = 0

    def holds(self, what, value):
        self.count += 1
        if not value:
            self.faults.append(what)

    def open(self, path, width, dark=False, scripts=True):
        self.page.look(width, dark=dark, scripts=scripts)
        self.page.open(path.resolve().as_uri())
        where = f"{path.name} at {width}{' dark' if dark else ''}{'' if scripts else ' without scripts'}"
        if scripts:
            drawn = self.page.run(DRAWN)
            self.holds(f"{where}: a chart is not drawn: {drawn}", all(drawn))
        self.holds(f"{where}: scrolls sideways", self.page.run("document.documentElement.scrollWidth <= innerWidth"))
        look = self.page.run(READABLE)
        self.holds(f"{where}: contrast {look['least']:.2f} of {look['where']}", look["least"] >= 4.5)
        self.holds(f"{where}: letters of {look['smallest']} px", look["smallest"] >= 10)
        if scripts:
            letters = self.page.run(LETTERS_OF_PICTURES)
            self.holds(f"{where}: letters of {letters:.1f} px in a picture", letters >= 10)
        self.holds(f"{where}: says {self.page.messages}", not self.page.messages)
        # The page of everything is taller than a picture may be.
        if self.pictures and path.parent != self.single:
            mode = ("dark" if dark else "light") + ("" if scripts else "-still")
            self.page.picture(self.pictures / f"{path.stem}-{width}-{mode}.png", whole=True)
        return where

    def structure(self, where):
        run = self.page.run
        self.holds(f"{where}: no main part", run("document.querySelectorAll('main#main').length") == 1)
        self.holds(f"{where}: no link past the contents", run("document.querySelector('a.skip').hash") == "#main")
        self.holds(f"{where}: a head without scope", run("document.querySelectorAll('th:not([scope])').length") == 0)
        self.holds(f"{where}: a picture without words", run("document.querySelectorAll('img:not([alt])').length") == 0)

    def charts(self, where):
        """Series, switches, axes, pointer and keys of each chart."""
        run = self.page.run
        charts = "[...document.querySelectorAll('figure.chart')].filter(one => one.polhode && one.polhode.svg)"
        for n in range(run(f"{charts}.length")):
            one = f"{charts}[{n}]"
            lines = f"{one}.querySelectorAll('path.line').length"
            shown = run(f"{one}.polhode.lines.length")
            self.holds(f"{where}: chart {n} has no line", shown > 0 and run(lines) == shown)
            names = run(f"{one}.polhode.names.length")
            if names > 1:
                key = f"{one}.querySelector('button.key')"
                run(f"{key}.click()")
                self.holds(f"{where}: chart {n} does not switch a line off", run(lines) < shown)
                self.holds(f"{where}: chart {n} does not say so", run(f"{key}.getAttribute('aria-pressed')") == "false")
                run(f"{key}.dispatchEvent(new MouseEvent('click', {{shiftKey: true}}))")
                self.holds(f"{where}: chart {n} does not show one alone", run(f"{one}.polhode.on.size") == 1)
                run(f"[...{one}.querySelectorAll('button.key')].at(-1).click()")
            for axis in run(f"{one}.polhode.data.x.map(([key]) => key)"):
                run(f"{one}.polhode.x = '{axis}', {one}.polhode.draw()")
                self.holds(f"{where}: chart {n} has no line over {axis}", run(lines) > 0)
            run(f"{one}.scrollIntoView(), {one}.polhode.svg.focus()")
            self.page.press("ArrowRight")
            said = run(f"{one}.querySelector('.reading').textContent")
            self.holds(f"{where}: chart {n} does not answer to keys", len(said) > 10)
            place = run(f"(() => {{ const c = {one}.polhode, b = c.svg.getBoundingClientRect();"
                        " const [x, y] = c.place(c.lines[0].points.at(-1)); return [b.left + x, b.top + y]; })()")
            run(f"{one}.polhode.choose(null)")
            self.page.move(*place)
            self.holds(f"{where}: chart {n} does not answer to the pointer",
                       len(run(f"{one}.querySelector('.reading').textContent")) > 10)
            parts = run(f"{one}.polhode.data.parts")
            for part in ["truncation", "rounding"] if parts else []:
                run(f"{one}.polhode.part = '{part}', {one}.polhode.draw()")
                self.holds(f"{where}: chart {n} has no {part}", run(lines) > 0)

    def tables(self, where):
        run = self.page.run
        table = "[...document.querySelectorAll('table.data')].find(one => one.tBodies[0].rows.length > 2)"
        if not run(f"!!{table}"):
            return
        column = "[...%s.tBodies[0].rows].map(row => row.cells[0].textContent)" % table
        run(f"{table}.closest('details')?.setAttribute('open', '')")
        head = f"{table}.tHead.rows[0].cells[0]"
        run(f"{head}.querySelector('button').click()")
        once = run(column)
        run(f"{head}.querySelector('button').click()")
        self.holds(f"{where}: a table is not sorted", run(column)[0] == once[-1] or len(set(once)) == 1)
        self.holds(f"{where}: a table does not say so", run(f"{head}.getAttribute('aria-sort')") == "descending")

    def filters(self, where):
        run = self.page.run
        if not run("!!document.querySelector('.filter input')"):
            return
        seen = "[...document.querySelector('.filter').nextElementSibling.querySelectorAll('tbody tr')].filter(row => !row.hidden)"
        every = run(f"{seen}.length")
        run("(() => { const f = document.querySelector('.filter input'); f.value = 'euler'; f.dispatchEvent(new Event('input')); })()")
        found = run(f"{seen}.map(row => row.textContent.toLowerCase())")
        self.holds(f"{where}: a table is not filtered", all("euler" in row for row in found) and len(found) < every)

    def search(self, where):
        run = self.page.run
        run("document.querySelector('#search').focus()")
        self.page.call("Input.insertText", text="euler")
        seen = "[...document.querySelectorAll('#contents li')].filter(one => !one.hidden).map(one => one.textContent.trim())"
        found = run(seen)
        self.holds(f"{where}: the search finds {found}", found and all("euler" in one for one in found))
        self.page.press("Escape")
        self.holds(f"{where}: the search does not end", len(run(seen)) > len(found))

    def motion(self, where):
        run = self.page.run
        one = "[...document.querySelectorAll('figure.chart')].find(one => one.dataset.kind === 'motion')"
        self.holds(f"{where}: no motion", run(f"!!{one}"))
        if not run(f"!!{one}?.polhode"):
            return
        steps = run(f"{one}.polhode.step.options.length")
        self.holds(f"{where}: {steps} steps of the motion", steps == 3)
        image = f"{one}.querySelector('canvas').toDataURL()"
        before = run(image)
        run(f"{one}.polhode.button.focus()")
        run(f"{one}.polhode.button.click()")
        run("new Promise(done => setTimeout(done, 400))")
        self.holds(f"{where}: the motion does not play", run(f"{one}.polhode.at") > 0 and run(image) != before)
        run(f"{one}.polhode.button.click()")
        still = run(f"{one}.polhode.at")
        run("new Promise(done => setTimeout(done, 100))")
        self.holds(f"{where}: the motion does not pause", run(f"{one}.polhode.at") == still)
        run(f"{one}.querySelectorAll('canvas')[1].focus()")
        view = run(f"{one}.polhode.view[0]")
        self.page.press("ArrowRight")
        self.holds(f"{where}: the view does not turn", run(f"{one}.polhode.view[0]") != view)
        between = run(f"(() => {{ const m = {one}.polhode; m.choose(); m.at = 3.6; return [m.run.coarse, m.now()]; }})()")
        self.holds(f"{where}: a coarse run is drawn between its steps: {between}", between == [True, 3])
        ends = run(f"(() => {{ const m = {one}.polhode; m.at = m.frames; m.draw(); return m.runs.map(run => run.turn.at(-1).length); }})()")
        self.holds(f"{where}: a run is not whole", ends and all(length == 4 for length in ends))

    def verdicts(self, where):
        """The table that is folded is drawn when it is opened."""
        run = self.page.run
        part = "document.querySelector('details.verdicts')"
        run(f"{part}.open = true")
        run(f"(async () => {{ for (let n = 0; n < 100 && !{part}.querySelector('table'); n++) await new Promise(done => setTimeout(done, 20)); }})()")
        rows = run(f"{part}.querySelectorAll('tbody tr').length")
        self.holds(f"{where}: {rows} verdicts", f"({rows})" in run(f"{part}.querySelector('summary').textContent"))

    def paper(self, where):
        """On paper what is folded is open."""
        run = self.page.run
        run("document.querySelectorAll('main details').forEach(part => { part.open = false; })")
        run("addEventListener('beforeprint', () => { window.folded = document.querySelectorAll('main details:not([open])').length; })")
        self.page.call("Page.printToPDF")
        self.holds(f"{where}: {run('window.folded')} parts are folded on paper", run("window.folded") == 0)

    def still(self, path, least=1):
        """Without scripts the pictures stand there."""
        where = self.open(path, WIDE, scripts=False)
        self.page.look(WIDE)
        missing = self.page.run("[...document.images].filter(one => one.complete && !one.naturalWidth).length")
        self.holds(f"{where}: {missing} pictures are missing", missing == 0)
        images = self.page.run("document.images.length")
        self.holds(f"{where}: {images} pictures", images >= least)


def sizes(check, folder, single):
    """Whether every file keeps its budget."""
    pages = [folder / "index.html", *(folder / "pages").glob("*.html")]
    largest = max(pages, key=lambda page: page.stat().st_size)
    check.holds(f"{largest.name} has {largest.stat().st_size} bytes", largest.stat().st_size <= PAGE)
    packed = len(gzip.compress((folder / "index.html").read_bytes()))
    check.holds(f"the index has {packed} bytes compressed", packed <= PACKED_INDEX)
    limits = [(single / "index.html", SINGLE), (folder / "records.json", RECORDS), (folder / "report.md", MARKDOWN)]
    for path, most in limits:
        check.holds(f"{path} has {path.stat().st_size} bytes", path.stat().st_size <= most)
    whole = sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())
    check.holds(f"the folder has {whole} bytes", whole <= FOLDER)
    sizes = ", ".join(f"{path.name} {path.stat().st_size}" for path, _ in limits[1:])
    return f"largest page {largest.stat().st_size}, index compressed {packed}, single {(single / 'index.html').stat().st_size}, {sizes}, folder {whole} bytes"


def main():
    program, folder, single = sys.argv[1], *map(pathlib.Path, sys.argv[2:4])
    pictures = pathlib.Path(sys.argv[4]) if len(sys.argv) > 4 else None
    if pictures:
        pictures.mkdir(parents=True, exist_ok=True)
    browser = Browser(program)
    try:
        check = Check(browser, folder, single, pictures)
        index = folder / "index.html"
        pages = sorted((folder / "pages").glob("*.html"))
        first = [next(page for page in pages if page.name.startswith(kind)) for kind in ["scene-", "scheme-"]]
        kinds = [index, *first, *(page for page in pages if not page.name.startswith(("scene-", "scheme-")))]
        for path in kinds:
            for width in [NARROW, WIDE]:
                where = check.open(path, width)
                check.structure(where)
                check.charts(where)
                check.tables(where)
                check.filters(where)
                if path == index:
                    check.search(where)
                if path.stem == "verdicts":
                    check.paper(where)
                if path == first[0]:
                    check.motion(where)
                    check.verdicts(where)
            check.open(path, NARROW, dark=True)
            check.open(path, WIDE, dark=True)
        for path in [index, first[0]]:
            check.still(path)
        check.open(index, WIDE)
        nodes = check.page.run("document.querySelectorAll('*').length")
        check.holds(f"the index has {nodes} nodes", nodes <= MOST_NODES)
        took = check.page.run("(entry => entry.loadEventEnd - entry.startTime)(performance.getEntriesByType('navigation')[0])")
        links = {link for path in kinds for link in linked(check, path)}
        check.holds(f"links lead nowhere: {sorted(link for link in links if not pathlib.Path(link).exists())[:5]}",
                    all(pathlib.Path(link).exists() for link in links))
        said = sizes(check, folder, single)
        where = check.open(single / "index.html", WIDE)
        check.structure(where)
        check.motion(where)
        check.still(single / "index.html", least=len(list((folder / "plots").glob("*-convergence.png"))))
    finally:
        browser.close()
    print(f"browser: {check.count} checks of {len(kinds) + 1} pages, {len(check.faults)} failed; index {nodes} nodes, loaded in {took:.0f} ms; {said}")
    for fault in check.faults:
        print(f"  {fault}")
    return 1 if check.faults else 0


def linked(check, path):
    check.page.look(WIDE)
    check.page.open(path.resolve().as_uri())
    return check.page.run("[...document.links].filter(a => a.protocol === 'file:').map(a => decodeURIComponent(a.pathname))")


if __name__ == "__main__":
    sys.exit(main())
