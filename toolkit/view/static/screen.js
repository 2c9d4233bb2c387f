// A JPEG picture that the kernel replaces. The page sends back the number of every other picture that it shows, so that the
// kernel knows how fast the page is; an answer takes the kernel a tenth of the time of a picture.
const WAITING = 3; // a network may deliver several at once: each is shown in turn

function render({ model, el }) {
  const [width, height] = model.get("size"), canvas = Object.assign(document.createElement("canvas"), { width, height });
  canvas.className = "tk-screen";
  canvas.style.maxWidth = "100%";
  el.append(canvas);
  const context = canvas.getContext("bitmaprenderer"), waiting = [];
  let handle = 0;
  async function receive() {
    const number = model.get("number");
    waiting.push([number, await createImageBitmap(new Blob([model.get("value")], { type: "image/jpeg" }))]);
    if (waiting.length > WAITING) waiting.shift()[1].close();
    handle ||= requestAnimationFrame(show);
  }
  function show() {
    const [number, picture] = waiting.shift();
    handle = waiting.length && requestAnimationFrame(show);
    context.transferFromImageBitmap(picture);
    canvas.dispatchEvent(new Event("load"));
    if (number % 2 === 0) model.send({ kind: "seen", number });
  }
  model.on("change:number", receive);
  receive();
  return () => {
    cancelAnimationFrame(handle);
    model.off("change:number", receive);
  };
}
export default { render };
