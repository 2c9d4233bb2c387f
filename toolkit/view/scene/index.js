// Entry of the bundle. A widget uses `render`, an importing module the exports, a page with the code inline `globalThis`.
import { Kernel, Model } from "./character.js";
import { render as controller } from "./controller.js";
import { render as director } from "./director.js";
import { Crowd } from "./crowd.js";
import { download, player, render as clips } from "./player.js";
import { Scene } from "./scene.js";

// A character in an element of a page without a notebook, from the data of view/pages/live_page.py.
function character(element, data) {
  const kernel = new Kernel(data);
  kernel.download = (text) => download("walk.bvh", text); // a recording
  kernel.run();
  controller({ model: kernel, el: element });
  return { kernel, ...element.toolkit };
}

// A desk for shots, from the data of shots/director.py.
function desk(element, { scene, ...data }) {
  director({ model: new Model({ data, scene, height: null }), el: element });
  return element.toolkit;
}

// A widget that lives needs no picture beside it, which is for pages without a kernel.
function hideStill(el, tries = 600) {
  if (!el.isConnected && tries) return requestAnimationFrame(() => hideStill(el, tries - 1));
  for (const still of el.closest(".jp-OutputArea, .output")?.querySelectorAll(".tk-still") ?? []) still.hidden = true;
}

// The widget of the traits that a model has.
function render({ model, el }) {
  hideStill(el);
  return (model.get("data") ? director : model.get("clips") ? clips : controller)({ model, el });
}

globalThis.toolkitScene = { Crowd, Scene, character, director: desk, player };
export { Scene, character, desk as director, player };
export default { render };
