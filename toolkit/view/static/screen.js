// A picture that the kernel replaces, as JPEG; the page answers with its number once it is shown, so that the kernel keeps pace.
function render({ model, el }) {
  const image = document.createElement("img");
  image.className = "tk-screen";
  Object.assign(image, { width: model.get("size")[0], height: model.get("size")[1] });
  const show = () => {
    const number = model.get("number"), url = URL.createObjectURL(new Blob([model.get("value")], { type: "image/jpeg" }));
    image.onload = () => {
      URL.revokeObjectURL(url);
      model.send({ kind: "seen", number });
    };
    image.src = url;
  };
  model.on("change:number", show);
  el.append(image);
  show();
  return () => model.off("change:number", show);
}
export default { render };
