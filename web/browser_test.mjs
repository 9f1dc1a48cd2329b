// The pages of gapflow report in a real browser, without a network: they load without an error, the slider, the keys and the play
// button change the picture, hovering tells values, zoom works, light and dark.
//
//   node browser_test.mjs PAGE_2D.html PAGE_3D.html [OTHER.html ...]     others need only load
//
// GAPFLOW_SCREENSHOTS=FOLDER leaves screenshots there.
//
// Exit status 77: playwright-core or the browser is not there, skipped.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

function skip(why) {
  console.log(`skipped: ${why}; web/test installs what is missing`);
  process.exit(77);
}
const playwright = await import("playwright-core").catch(() => skip("no playwright-core in web/node_modules"));
const executablePath = ["/usr/bin/chromium-headless-shell", "/usr/bin/chromium"].find(existsSync) ?? skip("no chromium-headless-shell");
const [page2d, page3d, ...others] = process.argv.slice(2), shots = process.env.GAPFLOW_SCREENSHOTS;

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
      const tip = await page.locator("#tip").evaluate((element) => (element.hidden ? "" : element.textContent));
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
  });
  for (const file of others) {
    const page = await open(file);
    assert.match(await text(page, "#plots"), /\S/);
    assert.match(await text(page, "#scene"), /domain/);
    if (shots) await page.screenshot({ path: join(shots, `other_${others.indexOf(file)}.png`), fullPage: true });
    assert.equal(await page.locator("#problem").isHidden(), true);
    assert.deepEqual(page.problems, [], file);
    await page.context().close();
  }
  console.log(`pages in 2D and 3D and ${others.length} others: ok`);
} finally {
  await browser.close();
}
