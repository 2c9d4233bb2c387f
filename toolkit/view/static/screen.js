// A picture that the kernel replaces, as JPEG. The page answers with the picture's number once it is shown, so that the kernel
// keeps pace; every other one, for an answer takes the kernel as long as a tenth of a picture.
const WAITING = 3; // a network may bring several at once: each is shown in its turn

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
