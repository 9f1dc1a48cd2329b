// The pages of gapflow report in a real browser, without a network: they load without an error, the slider, the keys and the play
// button change the picture, hovering tells values, zoom works, light and dark.
//
//   node browser_test.mjs PAGE_2D.html PAGE_3D.html COMPARISON_2D.html CROWD.html MEASURED.html SWEEP.html STEADY_SWEEP.html [OTHER.html ...]     others need only load
//
// GAPFLOW_SCREENSHOTS=FOLDER leaves screenshots there.
//
// Exit status 77: playwright-core or the browser is not there, skipped.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

function skip(why) {
  console.log(`skipped: ${why}; web/test installs what is missing`);
  process.exit(77);
}
const playwright = await import("playwright-core").catch(() => skip("no playwright-core in web/node_modules"));
const executablePath = ["/usr/bin/chromium-headless-shell", "/usr/bin/chromium"].find(existsSync) ?? skip("no chromium-headless-shell");
const [page2d, page3d, comparison, crowd, measured, sweep, steady, ...others] = process.argv.slice(2), shots = process.env.GAPFLOW_SCREENSHOTS;

const browser = await playwright.chromium.launch({ executablePath, args: ["--no-sandbox", "--enable-unsafe-swiftshader"] });

async function open(file, options = {}) {
  const context = await browser.newContext({ offline: true, viewport: { width: 1280, height: 900 }, ...options });
  const page = await context.newPage();
  page.problems = [];
  page.on("console", (message) => message.type() === "error" && page.problems.push(message.text()));
  page.on("pageerror", (error) => page.problems.push(error.message));
  page.on("request", (request) => /^https?:/.test(request.url()) && page.problems.push(`asked for ${request.url()}`));
  await page.goto(pathToFileURL(resolve(file)).href);
  await page.waitForFunction(() => document.documentElement.dataset.ready === "yes", null, { timeout: 30000 });
  return page;
}
const canvas = "#picture > canvas";
const pixels = (page) => page.evaluate((name) => document.querySelector(name).toDataURL(), canvas);
const text = (page, name) => page.locator(name).innerText();
const frame = (page) => page.locator("#slider").inputValue();
async function slide(page, to) {
  await page.locator("#slider").evaluate((slider, value) => {
    slider.value = value;
    slider.dispatchEvent(new Event("input"));
  }, String(to));
}
// A place of the canvas in shares of its size where hovering says what is looked for.
async function hoverUntil(page, wanted) {
  const box = await page.locator(canvas).boundingBox();
  const seen = [];
  for (let j = 1; j < 24; ++j)
    for (let i = 1; i < 16; ++i) {
      await page.mouse.move(box.x + (i / 16) * box.width, box.y + (j / 24) * box.height);
      const tip = await page.locator(".tip").evaluate((element) => (element.hidden ? "" : element.textContent));
      if (wanted.test(tip)) return tip;
      if (tip) seen.push(tip);
    }
  assert.fail(`hovering never said ${wanted}; it said ${JSON.stringify([...new Set(seen)].slice(0, 5))}`);
}

async function checkPlayer(page) {
  const last = Number(await page.locator("#slider").getAttribute("max"));
  assert.ok(last >= 2, "a run of three frames or more");
  await slide(page, 0);
  const first = await pixels(page);
  assert.match(await text(page, "#now"), /^t = 0\.0+ · 1 of/);
  await slide(page, last);
  const end = await pixels(page);
  assert.notEqual(first, end, "the slider changes the picture");
  await slide(page, 0);
  assert.equal(await pixels(page), first, "and back to the same picture");
  await page.locator("body").click({ position: { x: 4, y: 4 } });
  await page.keyboard.press("ArrowRight");
  assert.equal(await frame(page), "1");
  await page.keyboard.press("End");
  assert.equal(await frame(page), String(last));
  await page.keyboard.press("Home");
  await page.keyboard.press("Space");
  await page.waitForFunction((n) => Number(document.getElementById("slider").value) === n, last, { timeout: 20000 });
  await page.locator("#play").click();
  await page.waitForFunction((n) => Number(document.getElementById("slider").value) % n >= 1, last);
  await page.locator("#play").click(); // stops
  const at = await frame(page);
  await page.waitForTimeout(700);
  assert.equal(await frame(page), at, "paused");
}

async function checkPlots(page) {
  const plots = await page.locator(".plot h3").allInnerTexts();
  for (const title of ["Position (change since the start)", "Velocity", "Force of the fluid", "Film pressure, smallest and largest", "Kinetic energy", "Iterations of the solver"])
    assert.ok(plots.includes(title), `${title} is among ${plots}`);
  assert.ok(plots.some((title) => title.startsWith("Gap thickness")) && plots.some((title) => title.startsWith("Step size")));
  const card = page.locator(".plot", { has: page.getByText("Velocity", { exact: true }) });
  const over = card.locator(".u-over");
  await over.scrollIntoViewIfNeeded();
  const legend = () => card.locator(".u-legend").innerText();
  await over.hover({ position: { x: 20, y: 40 } });
  const left = await legend();
  const width = (await over.boundingBox()).width;
  await over.hover({ position: { x: width - 10, y: 40 } });
  const right = await legend();
  assert.notEqual(left, right, "the legend follows the pointer");
  assert.match(right, /\d/);
  // Drag to zoom: the last time of the axis moves in; a double click brings it back.
  const ticks = () => card.locator("canvas").first().evaluate((c) => c.toDataURL());
  const whole = await ticks();
  const box = await over.boundingBox();
  await page.mouse.move(box.x + 30, box.y + 50);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 60, { steps: 4 });
  await page.mouse.up();
  await page.waitForTimeout(100);
  assert.notEqual(await ticks(), whole, "dragging zooms");
  await over.dblclick({ position: { x: 60, y: 60 } });
  await page.waitForTimeout(100);
  assert.equal(await ticks(), whole, "a double click shows all again");
  // A click shows that time above.
  await over.click({ position: { x: width - 2, y: 40 } });
  assert.equal(await frame(page), await page.locator("#slider").getAttribute("max"));
}

// The file that an action makes the page offer.
async function saved(page, action) {
  const [file] = await Promise.all([page.waitForEvent("download"), action()]);
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

async function checkFiles(page) {
  const frames = Number(await page.locator("#slider").getAttribute("max")) + 1, at = await frame(page);
  const picture = await saved(page, () => page.getByRole("button", { name: "PNG", exact: true }).click());
  assert.ok(picture.name.endsWith(".png") && picture.bytes.subarray(1, 4).toString() === "PNG", picture.name);
  const film = await saved(page, () => page.getByRole("button", { name: "Animation", exact: true }).click());
  const control = film.bytes.indexOf("acTL");
  assert.ok(control > 0 && film.bytes.readUInt32BE(control + 4) === frames, "an animated PNG with all output times");
  assert.equal(film.bytes.toString("latin1").split("fcTL").length - 1, frames);
  if (shots) {
    const shown = await page.context().newPage(); // a browser that can read it shows its size
    await shown.setContent(`<img src="data:image/png;base64,${film.bytes.toString("base64")}">`);
    const size = await shown.locator("img").evaluate((image) => image.decode().then(() => [image.naturalWidth, image.naturalHeight]));
    assert.ok(size[0] > 200 && size[1] > 200, size);
    await shown.close();
  }
  assert.equal(await frame(page), at, "and back to the time");
  const card = page.locator(".plot", { has: page.getByRole("heading", { name: /^Kinetic energy/ }) }).first();
  const table = await saved(page, () => card.getByRole("button", { name: "CSV" }).click());
  const rows = table.bytes.toString().trim().split("\n");
  assert.match(rows[0], /^time,/);
  assert.ok(rows.length > 4 && rows.slice(1).every((row) => /^[\d.e-]+(,[\d.e-]*)+$/.test(row)), rows[1]);
  const lines = await saved(page, () => card.getByRole("button", { name: "SVG" }).click());
  assert.match(lines.bytes.toString(), /<svg[\s\S]*Kinetic energy[\s\S]*>time<[\s\S]*energy \/ length|<svg[\s\S]*Kinetic energy[\s\S]*>time<[\s\S]*>energy</);
  const svg = await page.evaluate((text) => new DOMParser().parseFromString(text, "image/svg+xml").querySelectorAll("path[stroke-width]").length, lines.bytes.toString());
  assert.ok(svg > 0, "which is valid XML with curves");
  const before = await card.locator("canvas").first().evaluate((c) => c.toDataURL());
  await card.getByRole("button", { name: "log", exact: true }).click();
  assert.match(await card.locator("h3").innerText(), /logarithmic/);
  assert.notEqual(await card.locator("canvas").first().evaluate((c) => c.toDataURL()), before);
  await card.getByRole("button", { name: "log", exact: true }).click();
  await card.getByRole("button", { name: "clip" }).click();
  await card.getByRole("button", { name: "clip" }).click();
  // The ends of a colour scale
  const coloured = await pixels(page), scale = page.locator(".scale").first();
  await scale.locator("summary").click();
  await scale.getByLabel("High end").fill(String(Number(await scale.getByLabel("High end").inputValue()) * 3));
  await scale.getByLabel("High end").blur();
  assert.notEqual(await pixels(page), coloured, "another range, other colours");
  await scale.getByLabel("logarithmic").check();
  await scale.getByRole("button", { name: "as at first" }).click();
  assert.equal(await pixels(page), coloured, "and back");
}

async function checkPage(file, name, more) {
  for (const colorScheme of ["light", "dark"]) {
    const page = await open(file, { colorScheme });
    assert.equal(await page.locator("html").getAttribute("data-theme"), colorScheme);
    assert.equal(await page.locator("#problem").isHidden(), true);
    if (shots) await page.screenshot({ path: join(shots, `${name}_${colorScheme}.png`), fullPage: true });
    if (colorScheme === "light") {
      await checkPlayer(page);
      await more(page);
      await checkPlots(page);
      await checkFiles(page);
      const before = await pixels(page);
      await page.getByRole("button", { name: "Speed", exact: true }).click();
      assert.notEqual(await pixels(page), before, "speed looks different from pressure");
      await page.locator("#theme").click();
      assert.equal(await page.locator("html").getAttribute("data-theme"), "dark");
      for (const word of ["domain", "fluid", "solver"]) assert.match(await text(page, "#scene"), new RegExp(word));
      assert.match(await text(page, "#machine"), /processor[\s\S]*solve/);
    }
    assert.deepEqual(page.problems, []);
    await page.context().close();
  }
  const phone = await open(file, { viewport: { width: 390, height: 844 } });
  assert.ok(await phone.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), "fits a narrow window");
  if (shots) await phone.screenshot({ path: join(shots, `${name}_narrow.png`) });
  assert.deepEqual(phone.problems, []);
  await phone.context().close();
}

try {
  await checkPage(page2d, "2d", async (page) => {
    await slide(page, 1);
    await hoverUntil(page, /^x .* y .*\npressure −?\d.*\nspeed −?\d/);
    await page.getByRole("button", { name: "Zoom to gap" }).click();
    await hoverUntil(page, /film pressure −?\d.*\nthickness \d/);
    const zoomed = await pixels(page);
    await page.locator(canvas).dblclick();
    assert.notEqual(await pixels(page), zoomed, "a double click shows all");
    assert.match(await text(page, "#beside"), /Along the gaps[\s\S]*Gaps at this time[\s\S]*thickness/);
  });
  await checkPage(page3d, "3d", async (page) => {
    await slide(page, 1);
    await hoverUntil(page, /z .*\npressure −?\d.*\nspeed −?\d/);
    await hoverUntil(page, /film pressure −?\d/);
    const before = await pixels(page), box = await page.locator(canvas).boundingBox();
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.7 * box.width, box.y + 0.5 * box.height, { steps: 5 });
    await page.mouse.up();
    assert.notEqual(await pixels(page), before, "dragging turns the view");
    await page.getByRole("button", { name: "Reset view" }).click();
    await page.getByRole("button", { name: "none", exact: true }).click();
    assert.notEqual(await pixels(page), before, "the slice can be hidden");
    await page.getByRole("button", { name: "y", exact: true }).click();
    const own = await pixels(page);
    const drag = (name, value) => page.getByLabel(name).evaluate((input, to) => { input.value = to; input.dispatchEvent(new Event("input")); }, value);
    await drag("Opacity of the slice", "30");
    const faint = await pixels(page);
    assert.notEqual(faint, own, "the slice can be made transparent");
    await drag("Place of the slice", "200");
    assert.notEqual(await pixels(page), faint, "and moved");
    await drag("Opacity of the slice", "100");
    await page.getByRole("button", { name: "Reset view" }).click();
    assert.equal(await pixels(page), own, "and put back");
  });
  {
    const page = await open(comparison);
    const panes = page.locator(".pane"), count = await panes.count();
    assert.ok(count >= 2, "views beside each other");
    assert.match(await text(page, ".runs"), /body\.upper\.density = 2[\s\S]*done/);
    const seen = () => page.locator(".pane canvas").evaluateAll((all) => all.map((c) => c.toDataURL()));
    await slide(page, 0);
    const first = await seen();
    await slide(page, Number(await page.locator("#slider").getAttribute("max")));
    const end = await seen();
    assert.ok(first.every((picture, i) => picture !== end[i]), "one slider moves all");
    const titles = await page.locator(".plot h3").allInnerTexts();
    assert.ok(titles.includes("Time of a step (seconds)"), `a title says a thing once: ${titles}`);
    assert.ok(titles.includes("Smallest film pressure: upper – lower") && !titles.some((title) => title.includes("smallest and")), `one of the two: ${titles}`);
    assert.ok(titles.includes("upper.vy, mean over time") && !titles.some((title) => /torque|omega|angle|vx/.test(title)), `no round-off: ${titles}`);
    assert.ok(titles.includes("Velocity: upper vy") && !titles.includes("Velocity: upper vx"), `no round-off: ${titles}`);
    const legend = await page.locator(".plot", { has: page.getByText("Velocity: upper vy", { exact: true }) }).locator(".u-legend").innerText();
    assert.match(legend, /body\.upper\.density = 2:? ?0\.\d+[\s\S]*body\.upper\.density = 8:? ?0\.\d+/);
    await page.locator("#runs button").first().click();
    assert.equal(await panes.count(), count - 1, "a run can be left out");
    await page.locator("#runs button").first().click();
    const picture = await saved(page, () => page.getByRole("button", { name: "PNG", exact: true }).click());
    assert.ok(picture.bytes.length > 1000);
    if (shots) await page.screenshot({ path: join(shots, "comparison.png"), fullPage: true });
    assert.deepEqual(page.problems, []);
    await page.context().close();
  }
  {
    const page = await open(crowd);
    assert.ok(await page.locator("#chips button").count() < 20, "no button for each of many bodies");
    assert.match(await text(page, "#chips"), /sand: mean of 60/);
    await page.getByLabel("Bodies that moved furthest").selectOption("5");
    assert.equal(await page.locator("#chips .chooser").first().locator("button").count(), 5);
    await page.getByLabel("Add to Bodies").fill("sand_0007");
    await page.getByLabel("Add to Bodies").press("Enter");
    await page.getByLabel("Add to Bodies").blur();
    assert.match(await text(page, "#chips"), /sand_0007/);
    if (shots) await page.screenshot({ path: join(shots, "crowd.png"), fullPage: true });
    assert.deepEqual(page.problems, []);
    await page.context().close();
  }
  {
    const page = await open(measured);
    const titles = await page.locator(".plot h3").allInnerTexts();
    for (const title of ["Flux", "Inflow and outflow", "Pressure at probes", "Velocity at probes", "Parts of the force fx on disk"])
      assert.ok(titles.includes(title), `${title} is among ${titles}`);
    const card = (title) => page.locator(".plot", { has: page.getByRole("heading", { name: title, exact: true }) });
    const table = async (title) => (await saved(page, () => card(title).getByRole("button", { name: "CSV" }).click())).bytes.toString().trim().split("\n");
    const flux = await table("Flux");
    assert.equal(flux[0], "time,outlet,above");
    assert.equal(flux.length, 32);
    assert.ok(Math.abs(Number(flux[10].split(",")[1]) - 1) < 1e-5, flux[10]);
    const wake = await table("Velocity at probes");
    assert.match(wake[0], /^time,"wake \(0\.95, 0\.5\) u"/);
    assert.equal(wake.length, 13); // the first step at or behind every 0.05
    assert.deepEqual((await table("Parts of the force fx on disk"))[0].split(","), ["time", "pressure", "shear"]); // no film, no contact
    await page.getByRole("button", { name: "above", exact: true }).click();
    assert.equal((await table("Flux"))[0], "time,outlet");
    if (shots) await page.screenshot({ path: join(shots, "measured.png"), fullPage: true });
    assert.deepEqual(page.problems, []);
    await page.context().close();
  }
  {
    const page = await open(sweep);
    const part = page.locator("#sweep"), titles = () => part.locator(".plot h3").allInnerTexts();
    assert.ok((await titles()).includes("disk.fx, mean over time"), `${await titles()}`);
    const card = (title) => part.locator(".plot", { has: page.getByRole("heading", { name: title, exact: true }) });
    const table = async (title) => (await saved(page, () => card(title).getByRole("button", { name: "CSV" }).click())).bytes.toString().trim().split("\n");
    const drag = await table("disk.fx, mean over time");
    assert.equal(drag[0], 'fluid.viscosity,"body.disk.position = [0.7,0.5]","body.disk.position = [0.7,0.4]"');
    assert.deepEqual(drag.slice(1).map((row) => Number(row.split(",")[0])), [0.01, 0.0316227766016838, 0.1]);
    assert.ok(drag.slice(1).every((row) => row.split(",").slice(1).every((cell) => Number(cell) > 0)), drag.join("\n"));
    await part.getByRole("button", { name: "largest" }).click();
    assert.ok((await titles()).includes("disk.fx, largest"));
    await part.getByRole("button", { name: "body.disk.position" }).click();
    assert.match((await table("disk.fx, largest"))[0], /^"body.disk.position, y",fluid.viscosity = 0.01,/);
    if (shots) await page.screenshot({ path: join(shots, "sweep.png"), fullPage: true });
    assert.deepEqual(page.problems, []);
    await page.context().close();
  }
  {
    const page = await open(steady);
    const titles = await page.locator("#sweep .plot h3").allInnerTexts();
    assert.ok(titles.includes("disk.fx, last") && !titles.some((title) => title.includes("mean")), `of steady runs the last value: ${titles}`);
    assert.deepEqual(page.problems, []);
    await page.context().close();
  }
  for (const file of others) {
    const page = await open(file);
    assert.match(await text(page, "#plots"), /\S/);
    assert.match(await text(page, "#scene"), /domain/);
    if (shots) await page.screenshot({ path: join(shots, `other_${others.indexOf(file)}.png`), fullPage: true });
    assert.equal(await page.locator("#problem").isHidden(), true);
    assert.deepEqual(page.problems, [], file);
    await page.context().close();
  }
  console.log(`pages in 2D and 3D, of several runs, of a crowd and ${others.length} others: ok`);
} finally {
  await browser.close();
}
