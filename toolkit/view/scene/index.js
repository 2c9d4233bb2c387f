// Entry of the bundle. A module importer gets the exports; a page that inlines the text finds them on globalThis.
import { Scene } from "./scene.js";
import { player } from "./player.js";

globalThis.toolkitScene = { Scene, player };
export { Scene, player };
