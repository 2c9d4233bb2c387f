// A barycentric triangle with a marker to drag. Traits: names [3], weights [3], which sum to one.
const CORNERS = [[110, 26], [196, 172], [24, 172]], COLORS = ["#7b68c4", "#2fa596", "#d6598b"];
const CSS = `.tk-triangle{width:220px;color:#2b323b;font:13px system-ui,sans-serif;touch-action:none;user-select:none}
.tk-triangle svg{display:block;cursor:pointer;overflow:visible}.tk-triangle svg:focus{outline:none}.tk-triangle svg:focus-visible .marker{stroke:#7b68c4}
.tk-triangle text{font:600 12px system-ui,sans-serif;fill:#2b323b}.tk-triangle .share{font-weight:400;fill:#6d7580}`;

// weights of a point; outside of the triangle, negative ones become zero and the others are scaled to sum to one
function weightsAt([x, y]) {
  const [[ax, ay], [bx, by], [cx, cy]] = CORNERS, d = (by - cy) * (ax - cx) + (cx - bx) * (ay - cy);
  const a = ((by - cy) * (x - cx) + (cx - bx) * (y - cy)) / d, b = ((cy - ay) * (x - cx) + (ax - cx) * (y - cy)) / d;
  const clamped = [a, b, 1 - a - b].map((w) => Math.max(w, 0)), sum = clamped.reduce((p, q) => p + q);
  return clamped.map((w) => w / sum);
}

function render({ model, el }) {
  const anchors = ["middle", "end", "start"], labels = [[110, 12], [216, 194], [4, 194]];
  el.innerHTML = `<style>${CSS}</style><div class="tk-triangle"><svg viewBox="0 0 220 212" width="220" height="212" tabindex="0"
    role="application" aria-label="Style blend: drag, or use the arrow keys"><polygon points="${CORNERS.map((c) => c.join()).join(" ")}"
    fill="#f7f6f3" stroke="#cfc8bb" stroke-width="2" stroke-linejoin="round"/>
    ${CORNERS.map(([x, y], i) => `<line x1="${x}" y1="${y}" x2="110" y2="123.3" stroke="#e4dfd5"/><circle cx="${x}" cy="${y}" r="6"
    fill="${COLORS[i]}"/><text x="${labels[i][0]}" y="${labels[i][1]}" text-anchor="${anchors[i]}"></text>`).join("")}
    <circle class="marker" r="9" fill="#2b323b" stroke="#fff" stroke-width="3"/></svg></div>`;
  const svg = el.querySelector("svg"), marker = el.querySelector(".marker"), texts = [...el.querySelectorAll("text")];
  let point = [110, 123];

  function show() {
    const weights = model.get("weights");
    point = [0, 1].map((k) => weights.reduce((sum, w, i) => sum + w * CORNERS[i][k], 0));
    marker.setAttribute("cx", point[0]);
    marker.setAttribute("cy", point[1]);
    const names = model.get("names");
    names.forEach((name, i) => (texts[i].textContent = `${name}  ${Math.round(100 * weights[i])} %`));
    texts[2].setAttribute("y", labels[2][1] + 14 * (names[1].length + names[2].length > 19)); // side by side they would overlap
  }
  function set(next) {
    model.set("weights", weightsAt(next));
    model.save_changes();
    show();
  }
  function pick(event) {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    set([at.x, at.y]);
  }
  svg.addEventListener("pointerdown", (event) => { svg.setPointerCapture(event.pointerId); pick(event); });
  svg.addEventListener("pointermove", (event) => svg.hasPointerCapture(event.pointerId) && pick(event));
  svg.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [-6, 0], ArrowRight: [6, 0], ArrowUp: [0, -6], ArrowDown: [0, 6] }[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    set([point[0] + step[0], point[1] + step[1]]);
  });
  model.on("change:weights", show);
  model.on("change:names", show);
  show();
  return () => { model.off("change:weights", show); model.off("change:names", show); };
}
export default { render };
