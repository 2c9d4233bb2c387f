// Entry of the bundle. A widget uses `render`, an importing module the exports, a page with the code inline `globalThis`.
import { Kernel, Model } from "./character.js";
import { render as controller } from "./controller.js";
import { render as director } from "./director.js";
import { Crowd } from "./crowd.js";
import { make, player } from "./player.js";
import { Scene } from "./scene.js";

// A character in an element of a page without a notebook, from the data of view/live_page.py.
function character(element, data) {
  const kernel = new Kernel(data);
  kernel.download = (text) => { // a recording
    const link = make("a", "", null, { download: "walk.bvh", href: URL.createObjectURL(new Blob([text])) });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
  };
  kernel.run();
  controller({ model: kernel, el: element });
  return { kernel, ...element.toolkit };
}

// A desk for shots, from the data of view/director.py.
function desk(element, { scene, ...data }) {
  director({ model: new Model({ data, scene, height: null }), el: element });
  return element.toolkit;
}

const render = ({ model, el }) => (model.get("data") ? director : controller)({ model, el });

globalThis.toolkitScene = { Crowd, Scene, character, director: desk, player };
export { Scene, character, desk as director, player };
export default { render };
