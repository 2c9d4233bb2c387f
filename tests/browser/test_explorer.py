"""The map of styles in a real browser: a click plays a style, a drag of the ring plays a blend."""

START = """
import torch
import toolkit as tk
model, bank = tk.pretrained()
some = bank.select(["Neutral", "Zombie", "Crouch", "Aeroplane"])
explorer = tk.view.explore(model, some, points=torch.tensor([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [4.0, 4.5]]))
explorer
"""


TITLE = "document.querySelector('.jp-OutputArea-output b').textContent"  # of the player: what it plays


def test_a_click_and_a_drag_play_styles(open_notebook):
    notebook = open_notebook("explore.ipynb", [START])
    page = notebook.page
    notebook.run_all()
    points = page.locator(".tk-style-map .scatterlayer .points path")
    points.first.wait_for(timeout=60_000)
    assert points.count() == 4
    page.wait_for_function(f"{TITLE}.includes('100% Neutral')")
    boxes = [point.bounding_box() for point in points.all()]
    where = [(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2) for box in boxes]
    page.mouse.move(where[1][0] - 9, where[1][1])
    page.mouse.move(*where[1])
    page.wait_for_function("document.querySelector('.tk-style-map .hoverlayer').textContent.includes('Zombie')")
    page.mouse.down()
    page.mouse.up()
    page.wait_for_function(f"{TITLE}.includes('100% Zombie')")
    ring = page.locator(".tk-style-map > div").nth(1)
    page.wait_for_function("""(x) => {
        const box = document.querySelectorAll('.tk-style-map > div')[1].getBoundingClientRect();
        return Math.abs(box.x + box.width / 2 - x) < 2;
    }""", arg=where[1][0])
    box = ring.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move((where[0][0] + where[1][0]) / 2, where[0][1], steps=8)
    page.mouse.up()
    page.wait_for_function(f"/5\\d% Neutral/.test({TITLE}) || /5\\d% Zombie/.test({TITLE})")
    assert not [error for error in notebook.errors if "favicon" not in error]

