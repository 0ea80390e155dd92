#!/usr/bin/python3
# SPDX-FileCopyrightText: racebeam contributors
# SPDX-License-Identifier: Apache-2.0
"""Looks at reports in headless Chromium: console, requests, marks, tooltips, keyboard, tables without
a script, axe, and how much is drawn.

  report_page.py RACEBEAM [SHOTS]    SHOTS: where screenshots are kept; default: nowhere
"""
import base64
import pathlib
import struct
import subprocess
import sys
import tempfile
import time
import zlib

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

HERE = pathlib.Path(__file__).resolve().parent
WIDTH = 1300
SMALL = 0.25  # of screenshots that are measured
CHARTS = ["front", "parallel", "effects", "heat", "slack", "causes"]

GRID = """name = "grid"
[frames]
sample = 16
guard = 0
[knobs]
interval_stack_depth = [2, 4, 8]
fifo_entries = [6, 10]
[search]
race = false
[goals]
picture_error = "min"
starved = "min"
[measure]
causes = true
pictures = [7223]
"""
NAMES = """name = "</script><b>\\"q\\" & \U0001F642"
[frames]
sample = 4
guard = 0
[[point]]
name = "</script><img src=x onerror=alert(1)> \\"q\\" 'a' \U0001F642"
knobs = { fifo_entries = 4 }
"""
ONE = "[frames]\nsample = 4\nguard = 0\n"
SOBOL = """name = "spread"
[frames]
sample = 4
guard = 0
[search]
method = "sobol"
points = 24
race = false
[knobs]
hurry_threshold = { from = 0, to = 128 }
fifo_entries = { from = 4, to = 16 }
bisection = ["pow2", "midpoint"]
[goals]
picture_error = "min"
busy = "min"
"""

faults = []


def expect(good, words):
    if not good:
        faults.append(words)
        print("FAULT:", words)


class Browser:
    def __init__(self, script=True, dark=False):
        options = Options()
        for word in ["--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                     "--force-device-scale-factor=1", f"--window-size={WIDTH},900"]:
            options.add_argument(word)
        if not script:
            options.add_experimental_option("prefs", {"profile.managed_default_content_settings.javascript": 2})
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=Service("/usr/bin/chromedriver"))
        if dark:
            self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia",
                                        {"features": [{"name": "prefers-color-scheme", "value": "dark"}]})

    def __enter__(self):
        return self

    def __exit__(self, *what):
        self.driver.quit()

    def open(self, page, drawn=True):
        self.driver.get(page.as_uri())
        end = time.monotonic() + 60
        while drawn and not self.driver.execute_script("return document.documentElement.dataset.drawn"):
            if time.monotonic() > end:
                expect(False, f"{page.name} is not drawn")
                break
            time.sleep(0.05)
        return self

    def find(self, css):
        return self.driver.find_elements(By.CSS_SELECTOR, css)

    def quiet(self, page):
        """Nothing on the console, and no request but for the page and what is in it."""
        for entry in self.driver.get_log("browser"):
            expect(False, f"{page.name}: console: {entry['message']}")
        for entry in self.driver.get_log("performance"):
            if '"Network.requestWillBeSent"' not in entry["message"]:
                continue
            url = entry["message"].split('"url":"')[1].split('"')[0]
            expect(url == page.as_uri() or url.startswith("data:"), f"{page.name}: asks for {url}")

    def accessible(self, page):
        self.driver.execute_script((HERE / "axe/axe.min.js").read_text())
        result = self.driver.execute_async_script(
            "const done = arguments[0]; axe.run(document).then(done)")
        for violation in result["violations"]:
            where = violation["nodes"][0]["target"]
            expect(False, f"{page.name}: axe: {violation['id']}: {violation['help']}, at {where}")
        expect(len(result["passes"]) > 10, f"{page.name}: axe has looked at too little")

    def shot(self, scale):
        """The whole page as PNG."""
        height = self.driver.execute_script("return document.documentElement.scrollHeight")
        clip = {"x": 0, "y": 0, "width": WIDTH, "height": height, "scale": scale}
        return base64.b64decode(self.driver.execute_cdp_cmd(
            "Page.captureScreenshot", {"clip": clip, "captureBeyondViewport": True})["data"])


def rows_of(png):
    """Width and rows of a PNG of 8 bits a channel, not interlaced."""
    at, data = 8, b""
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at:at + 8])
        part = png[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", part[:10])
        if kind == b"IDAT":
            data += part
        at += 12 + size
    step = {2: 3, 6: 4}[colour]
    expect(depth == 8, "a screenshot of another depth")
    data, stride, rows, before = zlib.decompress(data), width * step, [], bytes(width * step)
    for y in range(height):
        kind, line = data[y * (stride + 1)], bytearray(data[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride if kind else 0):
            left = line[x - step] if x >= step else 0
            up, corner = before[x], before[x - step] if x >= step else 0
            if kind == 1:
                more = left
            elif kind == 2:
                more = up
            elif kind == 3:
                more = (left + up) // 2
            else:
                p = left + up - corner
                near = min((abs(p - left), 0, left), (abs(p - up), 1, up), (abs(p - corner), 2, corner))
                more = near[2]
            line[x] = (line[x] + more) & 255
        rows.append(bytes(line))
        before = line
    return width, step, rows


def drawn_share(png):
    """The share of pixels that are not paper, whose colour the corner has."""
    width, step, rows = rows_of(png)
    paper = rows[0][:3]
    drawn = sum(row[x:x + 3] != paper for row in rows for x in range(0, width * step, step))
    return width, len(rows), drawn / (len(rows) * width)


def look_at_charts(browser, page):
    for chart in CHARTS:
        marks = browser.find(f"#{chart}-chart svg .role-mark path, #{chart}-chart svg .role-mark rect, "
                             f"#{chart}-chart svg .role-mark line")
        expect(len(marks) >= 2, f"{page.name}: {chart} has {len(marks)} marks")
    # A point under the mouse
    points = browser.find("#front-chart svg .mark-symbol.role-mark path")
    expect(len(points) == 6, f"{page.name}: {len(points)} points in the front's chart instead of 6")
    ActionChains(browser.driver).move_to_element(points[-1]).perform()
    time.sleep(0.3)
    tip = browser.driver.find_element(By.ID, "tip")
    image = browser.find("#tip img")
    expect(tip.is_displayed() and image, f"{page.name}: no tip with a picture under the mouse")
    if image:
        expect(0 < image[0].size["width"] <= 320, f"{page.name}: the tip's picture is not 320 wide at most")
        expect(browser.driver.execute_script("return arguments[0].naturalWidth", image[0]) == 640,
               f"{page.name}: the tip's picture is broken")
    expect("picture_error" in tip.text and "+/-" in tip.text, f"{page.name}: the tip says '{tip.text}'")


def look_at_keyboard(browser, page):
    driver = browser.driver
    names = browser.find("#points-table tbody th button")
    expect(len(names) == 6, f"{page.name}: {len(names)} names can be reached by Tab")
    names[1].send_keys(Keys.ENTER)
    time.sleep(0.5)
    look = driver.find_element(By.ID, "look")
    expect(look.text.startswith(names[1].text) and len(look.find_elements(By.TAG_NAME, "canvas")) == 1,
           f"{page.name}: Enter on a name does not put it beside the base")
    # The table sorts by any column, and says so
    head = browser.find("#points-table thead th")[4]
    for order in ["ascending", "descending"]:
        head.find_element(By.TAG_NAME, "button").send_keys(Keys.ENTER)
        expect(head.get_attribute("aria-sort") == order, f"{page.name}: the table does not sort {order}")
        values = [int(cell.text) for cell in browser.find("#points-table tbody td:nth-child(5)")]
        expect(values == sorted(values, reverse=order == "descending"), f"{page.name}: sorted as {values}")
    # Words above the table pick points, in all charts
    only = driver.find_element(By.ID, "only")
    only.send_keys("fifo_entries=6")
    time.sleep(0.3)
    shown = [row for row in browser.find("#points-table tbody tr") if row.is_displayed()]
    expect(len(shown) == 3, f"{page.name}: {len(shown)} rows have fifo_entries=6 instead of 3")
    expect(driver.find_element(By.ID, "picked").text == "3 of 6 points", f"{page.name}: picked")
    driver.find_element(By.ID, "all-points").click()
    time.sleep(0.3)
    # Dragging along an axis does so, too
    box = browser.find("#parallel-chart svg .background")[0]
    size = box.size
    driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", box)
    ActionChains(driver).move_to_element_with_offset(box, -size["width"] // 2 + 20, size["height"] // 4) \
        .click_and_hold().move_by_offset(130, size["height"] // 4 - 4).release().perform()
    time.sleep(0.5)
    expect(driver.find_element(By.ID, "picked").text == "2 of 6 points",
           f"{page.name}: the brush over a stack of 2 picks {driver.find_element(By.ID, 'picked').text}")


def main():
    racebeam, shots = sys.argv[1], pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        pages = {}
        for name, text in {"grid": GRID, "names": NAMES, "one": ONE, "sobol": SOBOL}.items():
            (work / f"{name}.toml").write_text(text)
            subprocess.run([racebeam, "sweep", "run", f"{name}.toml", "-o", name], cwd=work, check=True,
                           capture_output=True)
            pages[name] = work / f"{name}.html"
            subprocess.run([racebeam, "report", name, "-o", pages[name].name], cwd=work, check=True,
                           capture_output=True)
        with Browser() as browser:
            page = pages["grid"]
            browser.open(page)
            look_at_charts(browser, page)
            look_at_keyboard(browser, page)
            browser.accessible(page)
            browser.quiet(page)
            for name in ["names", "one", "sobol"]:
                browser.open(pages[name])
                browser.accessible(pages[name])
                browser.quiet(pages[name])
                expect(not browser.find("main b, main img[onerror]"), f"{name}: a name has become a tag")
        for dark in [False, True]:
            with Browser(dark=dark) as browser:
                browser.open(page)
                if dark:
                    browser.accessible(page)
                if shots:
                    (shots / f"report_{'dark' if dark else 'light'}.png").write_bytes(browser.shot(1))
                width, height, share = drawn_share(browser.shot(SMALL))
                expect(width == WIDTH * SMALL and 4000 < height / SMALL < 12000,
                       f"a page of {width}x{height} pixels")
                expect(0.1 < share < 0.6, f"{share:.2f} of the page is drawn")
        with Browser(script=False) as browser:
            browser.open(page, drawn=False)
            tables = [table.get_attribute("id") for table in browser.find("table") if table.is_displayed()]
            expect(tables == ["front-table", "effects-table", "slack-table", "causes-table", "points-table",
                              "runs-table"], f"without a script there are {tables}")
            expect(len(browser.find("#points-table tbody tr")) == 6, "six rows without a script")
            expect(not [one for one in browser.find(".scripted") if one.is_displayed()],
                   "without a script something is left that needs one")
            expect(browser.find("noscript p")[0].size["height"] > 10, "nobody says why there are no charts")
    print(f"{len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
