"""Opens a report in a browser without a window: report.py REPORT PICTURE. The script of the page must not complain, particles turn with the
mouse, have the colours of their column, and are cut off beyond a plane. Leaves a picture; prints the time of a frame."""

import math
import sys
from pathlib import Path

from selenium import webdriver
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import Select

report, picture = Path(sys.argv[1]).resolve(), sys.argv[2]
options = webdriver.ChromeOptions()
options.binary_location = "/usr/bin/chromium"
# Without a graphics processor, in a container, and without a network.
for argument in ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--enable-unsafe-swiftshader", "--host-resolver-rules=MAP * ~NOTFOUND",
                 "--window-size=1180,2600", "--hide-scrollbars"]:
    options.add_argument(argument)
options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
browser = webdriver.Chrome(options=options, service=webdriver.ChromeService("/usr/bin/chromedriver"))


def seen():
    """Colours of the canvas that are not its background, as a set of what many pixels share, and how many there are."""
    found = browser.execute_script("""
        const { found } = report.pixels();
        const back = [found[0], found[1], found[2]], shades = {};
        let count = 0;
        for (let i = 0; i < found.length; i += 4) {
            const rgb = [found[i], found[i + 1], found[i + 2]];
            if (rgb.every((x, k) => Math.abs(x - [16, 20, 28][k]) < 12)) continue;
            count += 1;
            const most = Math.max(...rgb);
            const hue = rgb.map((x) => Math.round(20 * x / most)).join(",");
            shades[hue] = (shades[hue] || 0) + 1;
        }
        return [count, shades, back];""")
    return found[0], {hue: n / found[0] for hue, n in found[1].items() if n > 0.005 * found[0]}


def hue(rgb):
    return [20 * x / max(rgb) for x in rgb]


def distance(name, rgb):
    return math.dist([float(x) for x in name.split(",")], hue(rgb))


browser.get(report.as_uri())
data = browser.execute_script("return JSON.parse(document.getElementById('data').textContent)")
shown = browser.find_elements(By.CSS_SELECTOR, "section:not([hidden])")
assert {"particles", "history", "cost", "trust", "scene"} <= {section.get_attribute("id") for section in shown}, shown
particles = data["particles"]
names = [column["name"] for column in particles["columns"]]

# The bodies have the colours of both ends of the map, and no others.
Select(browser.find_element(By.ID, "column")).select_by_index(names.index("body"))
count, shades = seen()
ends = particles["colours"][0], particles["colours"][-1]
assert count > 10_000, count
for name, share in shades.items():
    assert min(distance(name, end) for end in ends) < 3, (name, share, shades)
assert all(any(distance(name, end) < 3 for name in shades) for end in ends), shades
# Of the target alone there is one colour.
browser.execute_script("""document.getElementById('snapshot').value = 0; document.getElementById('snapshot').dispatchEvent(new Event('input'))""")
first = browser.execute_script("return document.getElementById('moment').textContent")
assert first.startswith("t = 0"), first

canvas = browser.find_element(By.CSS_SELECTOR, "#view canvas")
take = "const { found } = report.pixels(); let sum = 0; for (let i = 0; i < found.length; i += 1) sum = (sum * 31 + found[i]) % 2147483647; return sum"
before = browser.execute_script(take)
assert before == browser.execute_script(take)
ActionChains(browser).move_to_element(canvas).click_and_hold().move_by_offset(120, 60).release().perform()
turned = browser.execute_script(take)
assert before != turned, "the mouse turns the particles"
browser.find_element(By.ID, "reset").click()

whole, _ = seen()
Select(browser.find_element(By.ID, "axis")).select_by_visible_text("z")
cut, _ = seen()
assert browser.execute_script(take) != turned and cut < whole, (cut, whole)
browser.execute_script("""document.getElementById('offset').value = 0; document.getElementById('offset').dispatchEvent(new Event('input'))""")
nothing, _ = seen() if browser.execute_script("return report.pixels().found.some((x, i) => i % 4 === 1 && Math.abs(x - 20) > 12)") else (0, {})
assert nothing < 0.05 * whole, (nothing, whole)
Select(browser.find_element(By.ID, "axis")).select_by_visible_text("none")

for name in ["damage", "pressure"]:
    Select(browser.find_element(By.ID, "column")).select_by_index(names.index(name))
browser.find_element(By.ID, "play").click()
browser.find_element(By.ID, "play").click()
browser.execute_script("""const s = document.getElementById('snapshot'); s.value = s.max; s.dispatchEvent(new Event('input'))""")
Select(browser.find_element(By.ID, "column")).select_by_index(names.index("damage"))
complaints = [entry for entry in browser.get_log("browser") if entry["level"] == "SEVERE"]
assert not complaints, complaints
frame, renderer = browser.execute_script("return [report.frameTime(10), report.renderer()]")
browser.save_screenshot(picture)
browser.quit()
shown = particles["snapshots"][-1]["count"]
print(f"{shown} particles in {frame:.1f} ms per frame by {renderer}; {report.stat().st_size / 1e6:.1f} MB")
