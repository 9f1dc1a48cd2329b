// Bundles the report's pages: web/src and its two libraries into src/gapflow/output/assets.
//
//   node build.mjs [FOLDER]     writes report_2d.js, report_3d.js, report.css, report.html and LICENSES.txt into FOLDER
import { build } from "esbuild";
import { copyFile, mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2] ?? join(here, "../src/gapflow/output/assets");
await mkdir(folder, { recursive: true });

async function licence(name) {
  const about = JSON.parse(await readFile(join(here, "node_modules", name, "package.json"), "utf8"));
  const text = await readFile(join(here, "node_modules", name, "LICENSE"), "utf8");
  return `${about.name} ${about.version} (${about.license})\n\n${text.trim()}\n`;
}
const licences = { uplot: await licence("uplot"), three: await licence("three") };

async function bundle(entry, file, libraries) {
  const banner = `/*!\n${libraries.map((name) => licences[name]).join("\n")}*/`;
  await build({
    entryPoints: [join(here, "src", entry)], outfile: join(folder, file), bundle: true, minify: true, format: "iife", target: "es2022",
    legalComments: "none", charset: "ascii", banner: { js: banner }, logLevel: "warning",
  });
}
await bundle("main2d.js", "report_2d.js", ["uplot"]);
await bundle("main3d.js", "report_3d.js", ["uplot", "three"]);
await build({ entryPoints: [join(here, "src/style.css")], outfile: join(folder, "report.css"), minify: true, bundle: true, logLevel: "warning" });
await copyFile(join(here, "src/report.html"), join(folder, "report.html"));
await writeFile(join(folder, "LICENSES.txt"),
  `Libraries in report_2d.js (uPlot) and report_3d.js (uPlot, three.js).\n\n${Object.values(licences).join("\n" + "-".repeat(80) + "\n\n")}`);
