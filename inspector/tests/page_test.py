# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""page_test.py GESTALT SCENE: layers, pointing, the slider and 3D of the page as it is committed, in Debian's Chromium.

Needs only packages of Debian; page.test.mjs looks closer."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.wait import WebDriverWait

LAYER_KEYS = "123456789e"
LARGEST_PAGE = 5e6  # bytes of a scene


def page_of(gestalt, scene, work):
    subprocess.run([gestalt, "segment", scene, "--output", work / "out"], check=True, stdout=subprocess.DEVNULL)
    page = work / "page.html"
    subprocess.run([gestalt, "inspect", work / "out" / scene.name, "--output", page], check=True, stdout=subprocess.DEVNULL)
    assert page.stat().st_size <= LARGEST_PAGE, page.stat().st_size
    return page


def launch():
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for flag in ("headless=new", "no-sandbox", "use-gl=angle", "use-angle=swiftshader", "enable-unsafe-swiftshader",
                 "window-size=1440,900", "disable-background-networking"):
        options.add_argument(f"--{flag}")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


class Page:
    def __init__(self, browser, file):
        self.browser = browser
        browser.get(file.as_uri())
        self.wait_for("html[data-ready]")
        self.scene = json.loads(re.search(r'id="scene-0">(.*?)</script>', file.read_text(), re.S)[1])

    def wait_for(self, selector):
        WebDriverWait(self.browser, 60).until(lambda b: b.find_elements(By.CSS_SELECTOR, selector))

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def press(self, *keys):
        ActionChains(self.browser).send_keys(*keys).perform()
        self.settle()

    def settle(self):
        self.browser.execute_async_script("const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done))")

    def picture(self):
        return self.find(".stage").screenshot_as_png

    def point_at(self, u, v):
        """Moves the mouse to a pixel of the scene, which fits itself into the stage."""
        stage, camera = self.find(".stage-2d"), self.scene["camera"]
        scale = min((stage.size["width"] - 24) / camera["width"], (stage.size["height"] - 24) / camera["height"])
        x = (u + 0.5 - camera["width"] / 2) * scale
        y = (v + 0.5 - camera["height"] / 2) * scale
        ActionChains(self.browser).move_to_element_with_offset(stage, round(x), round(y)).perform()
        self.settle()


def layers_differ(page):
    seen = []
    for key in LAYER_KEYS:
        ActionChains(page.browser).key_down(Keys.SHIFT).send_keys(key).key_up(Keys.SHIFT).perform()
        page.settle()
        picture = page.picture()
        assert picture not in seen, f"layer {key} looks like layer {LAYER_KEYS[seen.index(picture)]}"
        seen.append(picture)


def patches_are_told(page):
    told = 0
    for number, patch in enumerate(page.scene["patches"]):
        if patch["pixels"] < 1500:
            continue
        page.point_at(*patch["anchor"])
        text = page.find(".tooltip").text
        assert text.startswith(f"Patch {number}\n"), text
        assert f"{1000 * patch['rms']:.2f} mm RMS" in text, text
        told += 1
    assert told > 5


def edges_are_told_from_the_wrongest(page):
    error = lambda edge: -1 if edge[4] is None else abs(edge[3] - edge[4])
    a, b = max(page.scene["edges"], key=error)[:2]
    page.press(Keys.ARROW_DOWN)
    text = page.find(".panel").text
    assert f"Patch {a}" in text and f"Patch {b}" in text and "ground truth" in text, text
    assert re.search(r"^(One object|Two objects): .+", text, re.MULTILINE), text
    for value in page.scene["levels"][0]["values"][:1]:
        assert value["name"] in text or page.scene["levels"][1]["values"][0]["name"] in text, text


def slider_cuts(page):
    sweep = page.scene["solver"]["sweeps"][-1]  # the one that the slider has at first
    cuts = page.scene["solver"]["cuts"]
    slider = page.find(".solver input[type=range]")
    counts = set()
    for index in (0, len(sweep["values"]) - 1):
        page.browser.execute_script(
            "arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new Event('input'))", slider, index)
        page.settle()
        cut = cuts[sweep["cuts"][index]]
        objects = len(set(cut["labels"]) - {0} - set(cut["background"]))
        text = page.find(".solver").text
        assert f"{objects} object" in text, (objects, text)
        counts.add(objects)
    assert len(counts) == 2, counts


def turns_in_3d(page):
    flat = page.picture()
    page.press("v")
    page.browser.execute_script("arguments[0].focus()", page.find(".stage-3d"))
    first = page.picture()
    assert first != flat
    page.press(Keys.ARROW_LEFT)
    assert page.picture() != first


def follows_the_system_to_dark(page):
    colour = lambda: page.find("body").value_of_css_property("background-color")
    light = colour()
    page.browser.execute_cdp_cmd(
        "Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": "dark"}]})
    page.settle()
    assert colour() != light, light


def main():
    gestalt, scene = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as work:
        file = page_of(gestalt, scene, pathlib.Path(work))
        browser = launch()
        try:
            page = Page(browser, file)
            for test in (layers_differ, patches_are_told, edges_are_told_from_the_wrongest, slider_cuts,
                         follows_the_system_to_dark, turns_in_3d):
                test(page)
                print(f"{test.__name__.replace('_', ' ')}: passed", flush=True)
            wrong = [entry for entry in browser.get_log("browser") if entry["level"] == "SEVERE"]
            assert not wrong, wrong
        finally:
            browser.quit()


main()
