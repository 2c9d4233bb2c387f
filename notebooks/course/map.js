// A map of styles, drawn by Plotly, with a ring to drag. Traits: figure, place, and Plotly's code.
const LOOK = {
  position: "absolute", width: "22px", height: "22px", margin: "-14px 0 0 -14px", borderRadius: "50%", cursor: "grab",
  border: "3px solid #2b323b", background: "rgba(43, 50, 59, 0.12)", boxShadow: "0 0 0 2px white", touchAction: "none",
};

async function render({ model, el }) {
  if (!globalThis.Plotly) {
    const url = URL.createObjectURL(new Blob([model.get("plotly")], { type: "text/javascript" }));
    await import(url);
    URL.revokeObjectURL(url);
  }
  const { data, layout } = JSON.parse(model.get("figure"));
  const frame = el.appendChild(document.createElement("div"));
  const plot = frame.appendChild(document.createElement("div"));
  const ring = frame.appendChild(document.createElement("div"));
  frame.className = "tk-style-map";
  Object.assign(frame.style, { position: "relative", width: `${layout.width}px` });
  Object.assign(ring.style, LOOK);
  ring.title = "Drag: blend of the styles around";
  let grabbed = false;

  const axes = () => [plot._fullLayout.xaxis, plot._fullLayout.yaxis];
  const put = ([x, y]) => {
    const [across, up] = axes();
    ring.style.left = `${across._offset + across.d2p(x)}px`;
    ring.style.top = `${up._offset + up.d2p(y)}px`;
  };
  const settle = () => grabbed || put(model.get("place"));
  const drag = (event) => {
    if (!grabbed) return;
    const [across, up] = axes(), box = plot.getBoundingClientRect();
    const place = [across.p2d(event.clientX - box.left - across._offset), up.p2d(event.clientY - box.top - up._offset)];
    put(place);
    model.set("place", place);
    model.save_changes();
  };
  ring.addEventListener("pointerdown", (event) => {
    grabbed = true;
    ring.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  ring.addEventListener("pointermove", drag);
  for (const end of ["pointerup", "pointercancel"]) {
    ring.addEventListener(end, () => {
      grabbed = false;
      settle();
    });
  }

  globalThis.Plotly.newPlot(plot, data, layout, { displaylogo: false, scrollZoom: true }).then(() => {
    plot.on("plotly_click", ({ points }) => model.send({ style: points[0].text }));
    plot.on("plotly_afterplot", settle);
    settle();
  });
  model.on("change:place", settle);
  return () => {
    model.off("change:place", settle);
    globalThis.Plotly.purge(plot);
  };
}

export default { render };
