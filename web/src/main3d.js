import { page } from "./page.js";
import { problem } from "./texts.js";
import { view3d } from "./view3d.js";

page(view3d).catch((error) => problem(`The page cannot be shown: ${error.message}`));
