// Entry of the bundle. A widget gets `render`, a module importer the exports; a page that inlines the text finds them on globalThis.
import { render } from "./controller.js";
import { player } from "./player.js";
import { Scene } from "./scene.js";

globalThis.toolkitScene = { Scene, player };
export { Scene, player };
export default { render };
