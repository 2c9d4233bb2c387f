// Entry of the bundle. A widget uses `render`, an importing module the exports, a page with the code inline `globalThis`.
import { Kernel } from "./character.js";
import { render } from "./controller.js";
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
  render({ model: kernel, el: element });
  return { kernel, ...element.toolkit };
}

globalThis.toolkitScene = { Crowd, Scene, character, player };
export { Scene, character, player };
export default { render };
