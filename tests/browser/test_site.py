"""The site that `make docs` built.

Links lead to files and anchors, pages fit a phone, pictures and scripts load.
"""

import html
import os
import re
from pathlib import Path
from urllib.parse import unquote

import pytest

SITE = Path(os.environ.get("TOOLKIT_SITE", Path(__file__).parents[2] / "out" / "docs"))
PAGES = sorted(path.relative_to(SITE).as_posix() for path in SITE.rglob("*.html")
               if "_static" not in path.parts)
WIDTHS = (1280, 390)

pytestmark = pytest.mark.skipif(not PAGES, reason="the site is not built: make docs")


def test_links_within_the_site_lead_to_files_and_anchors():
    script = re.compile(r"<script.*?</script>", re.DOTALL)  # no link is in the data of a figure
    texts = {page: script.sub("", (SITE / page).read_text(encoding="utf-8")) for page in PAGES}
    anchors = {page: {*map(html.unescape, re.findall(r'\sid="([^"]+)"', text))}
               for page, text in texts.items()}
    wrong = []
    for page, text in texts.items():
        links = re.findall(r'<(?:a|img|iframe|link)\s[^>]*?(?:href|src)="([^"]*)"', text)
        for link in map(html.unescape, {*links}):
            if re.match(r"[a-z]+:", link):
                continue
            file, _, anchor = link.partition("#")
            target = (SITE / page).parent / unquote(file.partition("?")[0]) if file else SITE / page
            known = anchors.get(Path(os.path.relpath(target, SITE)).as_posix())
            lost = anchor and known is not None and unquote(anchor) not in known
            if not target.is_file() or lost:
                wrong.append(f"{page}: {link}")
    assert not wrong, wrong[:20]


@pytest.mark.parametrize("width", WIDTHS)
def test_pages_fit_their_window_and_load_whole(browser, width):
    """All pages but those of the source code and of the single modules, which have one form."""
    tab, said, wrong = browser.new_page(viewport={"width": width, "height": 900}), [], []
    tab.on("console", lambda m: said.append(m.text) if m.type == "error" else None)
    tab.on("pageerror", lambda error: said.append(str(error)))
    tab.on("requestfailed", lambda request: said.append(request.url))
    for page in PAGES:
        if page.startswith(("_modules", "api/")):
            continue
        said.clear()
        tab.goto((SITE / page).as_uri(), timeout=120_000)
        found = tab.evaluate("""async () => {
            for (const image of document.images) image.loading = "eager";
            const images = [...document.images];
            await Promise.all(images.map((one) => one.complete || one.decode().catch(() => 0)));
            const broken = images.filter((one) => !one.naturalWidth);
            const part = document.querySelector(".content") ?? document.body;  // scrolls on phones
            return { wide: document.documentElement.scrollWidth,
                     beyond: part.scrollWidth - part.clientWidth,
                     broken: broken.map(({ src }) => src.slice(0, 200)) };
        }""")
        wrong += [f"{page}: {what}" for what in (*said, *found["broken"])]
        if found["wide"] > width or found["beyond"] > 0:
            wrong.append(f"{page}: {found['wide']} pixels wide, contents {found['beyond']} beyond "
                         "their column")
    tab.close()
    assert not wrong, wrong
