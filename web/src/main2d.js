import { page } from "./page.js";
import { problem } from "./texts.js";
import { view2d } from "./view2d.js";

page(view2d).catch((error) => problem(`The page cannot be shown: ${error.message}`));
