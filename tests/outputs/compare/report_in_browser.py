#!/usr/bin/env python3
"""The page of `poinsot compare --report`, used as a reader would in a headless Chromium: list, views, keys, slider, blinking.

Exit code 1 with what was wrong. Usage: report_in_browser.py POINSOT NODE
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import urllib.parse

REPOSITORY = pathlib.Path(__file__).resolve().parents[3]

# Runs in the page after its own script. Each claim is a name and its result.
DRIVER = r"""
<pre id="claims"></pre>
<script>
"use strict";
const claims = [];
const claim = (name, holds) => claims.push([name, Boolean(holds)]);
const failures = [];
window.addEventListener("error", event => failures.push(event.message));
const press = key => document.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
const names = () => [...document.querySelectorAll("#list .name")].map(item => item.textContent);
const outcomes = () => [...document.querySelectorAll('#list li[role="option"]')].map(item => item.dataset.outcome);
const chosen = () => document.querySelector('#list li[aria-selected="true"] .name').textContent;
const cut = () => document.getElementById("above").style.clipPath;
const wait = ms => new Promise(done => setTimeout(done, ms));
const pictures = () => Promise.all([...document.images].map(image => image.decode()));

async function drive() {
    claim("what differs is listed, worst first",
          outcomes().join() === "missing,size,pixels,pixels,unexpected");
    press("a");
    claim("a shows the same ones, too", outcomes().length === 6 && outcomes()[5] === "same");
    press("a");
    claim("a hides them again", outcomes().length === 5);
    claim("the first is chosen", chosen() === names()[0]);
    press("j"); press("j");
    claim("j goes on", chosen() === names()[2] && document.getElementById("name").textContent === names()[2]);
    press("k"); press("ArrowDown");
    claim("k goes back", chosen() === names()[2]);
    for (let i = 0; i < 9; ++i) press("j");
    claim("j stops at the last", chosen() === names()[4]);
    document.querySelectorAll('#list li[role="option"]')[2].click();
    claim("a click chooses", chosen() === names()[2]);

    await pictures();
    claim("side by side shows expected, the difference over actual, actual",
          document.images.length === 4 && [...document.images].every(image => image.naturalWidth > 0));
    const captions = [...document.querySelectorAll("figcaption")].map(caption => caption.textContent);
    claim("the picture is seen below the difference",
          getComputedStyle(document.querySelectorAll("#stage .pair img")[1]).backgroundImage === "none");
    claim("they are named", captions.map(caption => caption.split(/[ ,(:;]/)[0]).join() === "expected,difference,actual");
    const width = parseFloat(document.images[0].style.width);
    press("+");
    await pictures();
    const is_doubled = () => parseFloat(document.images[0].style.width) === 2 * width;
    for (let i = 0; i < 200 && !is_doubled(); ++i) await wait(25);
    claim("+ doubles the size", is_doubled());
    press("-");

    press("2");
    await pictures();
    claim("2 is swap", document.body.dataset.mode === "swap" && cut() === "inset(0px 0px 0px 100%)");
    press(" ");
    claim("space swaps", cut() === "inset(0px)" || cut() === "inset(0px 0px 0px 0%)");
    claim("what is shown is said", document.getElementById("showing").textContent === "actual");
    press(" ");
    claim("and back", document.getElementById("showing").textContent === "expected");

    press("3");
    const seen = new Set();
    for (let i = 0; i < 12; ++i) { await wait(125); seen.add(document.getElementById("showing").textContent); }
    claim("3 blinks between both", seen.has("expected") && seen.has("actual"));
    press("2");
    const still = document.getElementById("showing").textContent;
    await wait(1200);
    claim("blinking ends with its view", document.getElementById("showing").textContent === still);

    press("4");
    const slider = document.getElementById("slider");
    claim("4 shows the slider", !slider.hidden);
    slider.value = 250;
    slider.dispatchEvent(new Event("input"));
    claim("the slider cuts", cut() === "inset(0px 0px 0px 25%)");
    press("ArrowRight");
    claim("the right arrow moves it", cut() === "inset(0px 0px 0px 27%)" && Number(slider.value) === 270);
    press("ArrowLeft");
    claim("the left arrow moves it back", cut() === "inset(0px 0px 0px 25%)");

    press("5");
    await pictures();
    claim("5 shows the difference alone", document.images.length === 1 && slider.hidden);
    press("6");
    await pictures();
    claim("6 lays the difference over the picture",
          document.images.length === 2 && document.querySelector(".pair.laid") && !document.getElementById("above"));
    press("1");
    document.dispatchEvent(new KeyboardEvent("keydown", { key: "5", ctrlKey: true }));
    claim("keys of the browser are left alone", document.body.dataset.mode === "side by side");

    press("k");
    claim("sizes that differ are shown side by side", names()[1] === chosen() && document.images.length === 4);
    press("k"); press("2");
    claim("a missing picture has one to show", document.images.length === 1);
    claim("what cannot be approved has no command", getComputedStyle(document.getElementById("approve")).display === "none");

    press("j"); press("j"); press("j"); press("1");
    const changes = [...document.querySelectorAll("#changes li")].map(item => item.textContent);
    claim("what changed is said first: " + changes.join(), changes.some(line => line.includes("→")));
    claim("a change is one line", changes[0].endsWith(" → one; two"));
    const approve = document.querySelector("#approve code").textContent;
    claim("the command that approves is quoted: " + approve,
          approve.startsWith("poinsot approve 'turned<b>' --results ") && approve.includes(" --baselines "));
    claim("the reason names the changes", approve.endsWith(" --why '" + changes.join("; ") + "'"));
    claim("like changes are one group",
          [...document.querySelectorAll("#list .group")].map(item => item.firstChild.textContent).join() === GROUPS);
    const after = [...document.querySelectorAll("#list .member")].pop().nextElementSibling;
    claim("what follows a group is set apart", after.matches(".apart:not(.member)"));

    // The window: expected, difference and actual are in one row, or one above the other, but never cut.
    document.querySelectorAll('#list li[role="option"]')[2].click();
    await pictures();
    for (let i = 0; i < 200 && [...document.images].some(image => !image.style.width); ++i) await wait(25);
    const boxes = [...document.querySelectorAll("#stage figure")].map(figure => figure.getBoundingClientRect());
    const stage = document.getElementById("stage").getBoundingClientRect();
    claim("pictures lie in one row: " + boxes.map(box => [box.top, box.width]).join(" "),
          boxes.length === 3 && boxes.every(box => box.top === boxes[0].top) === IN_A_ROW);
    claim("no picture is cut", boxes.every(box => box.right <= stage.right + 0.5));
    const list = document.querySelector("nav").getBoundingClientRect();
    claim("the list takes at most a third: " + list.width + " × " + list.height,
          Math.min(list.width / innerWidth, list.height / innerHeight) <= 0.34);

    claim("a name is text, not a part of the page", !document.querySelector("main b, nav b"));
    claim("nothing is fetched",
          performance.getEntriesByType("resource").every(entry => /^(data|file):/.test(entry.name)));
    claim("nothing went wrong: " + failures.join(), failures.length === 0);
}
drive().catch(error => claim("the driver ran to its end: " + error, false)).finally(() => {
    document.getElementById("claims").textContent = JSON.stringify(claims);
});
</script>
"""


def make_pictures(program, expected, actual):
    """Pairs of every kind of outcome; one name would be markup if it were not escaped."""
    def draw(path, *options):
        subprocess.run([program, "still", str(REPOSITORY / "scenes" / "sphere.toml"), "--portable", "-q", "-o", str(path),
                        *options], check=True)
    small = ["--size", "640x360"]
    draw(expected / "same.png", *small)
    shutil.copy(expected / "same.png", actual)
    shutil.copy(expected / "same.png", expected / "gone.png")
    shutil.copy(expected / "same.png", expected / "turned<b>.png")
    draw(actual / "turned<b>.png", *small, "--time", "0.7", "--set", "caption=one; two")
    shutil.copy(expected / "same.png", expected / "also turned.png")
    shutil.copy(actual / "turned<b>.png", actual / "also turned.png")
    shutil.copy(expected / "same.png", expected / "wide.png")
    draw(actual / "wide.png", "--size", "700x360")
    shutil.copy(expected / "same.png", actual / "new.png")


def main():
    program, node = sys.argv[1:]
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        (folder / "expected").mkdir()
        (folder / "actual").mkdir()
        make_pictures(program, folder / "expected", folder / "actual")
        opened = []
        for options in ([], ["--single-file"]):
            page = folder / f"report #{len(options)}.html"
            compared = subprocess.run([program, "compare", str(folder / "expected"), str(folder / "actual"),
                                       "--report", str(page), *options], capture_output=True)
            if compared.returncode != 1:
                print(f"compare: exit {compared.returncode}, not 1: {compared.stderr.decode()}")
                return 1
            driver = DRIVER.replace("GROUPS", '"2 pictures: pixels"')
            text = page.read_text()
            for width, in_a_row in ((1300, "true"), (700, "true"), (460, "false")) if not options else ((1920, "true"),):
                driven = page.with_name(f"{width} {page.name}")
                driven.write_text(text.replace("</body>", driver.replace("IN_A_ROW", in_a_row) + "</body>"))
                opened += [urllib.parse.quote(str(driven)), str(width)]
        return subprocess.run([node, str(pathlib.Path(__file__).with_suffix(".js")), *opened]).returncode


if __name__ == "__main__":
    sys.exit(main())
