// Files from the page: plots as SVG and CSV, the view as PNG and as animated PNG.
import { animated } from "./apng.js";
import { css, element, short } from "./data.js";

/** Offers a file for download. */
export function download(name, content, type) {
  const link = element("a", { href: URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type })), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** A title as the name of a file. */
export const fileName = (title, ending) => `${title.toLowerCase().replace(/[^a-z0-9]+/g, "_").replace(/^_|_$/g, "")}.${ending}`;

const cell = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

/** Columns with a header line; what is no number is left empty. */
export function csvOf(names, columns) {
  const rows = columns[0].map((_, i) => columns.map((c) => (Number.isFinite(c[i]) ? String(c[i]) : "")).join(","));
  return [names.map(cell).join(","), ...rows, ""].join("\n");
}

const plain = (text) => String(text).replaceAll("&", "&amp;").replaceAll("<", "&lt;");

/** What a plot of uPlot shows, as a picture of lines. Lines: [{ label, colour, dash }] for its series but the first. */
export function svgOf(plot, title, labels, lines) {
  const left = 74, top = 34, { clientWidth: width, clientHeight: height } = plot.over;
  const high = top + height + 52 + 16 * Math.ceil(lines.length / 3), wide = left + width + 20;
  const out = [`<svg xmlns="http://www.w3.org/2000/svg" width="${wide}" height="${high}" font-family="sans-serif" font-size="12">`,
    `<rect width="100%" height="100%" fill="white"/><text x="${left}" y="20" font-size="14" font-weight="600">${plain(title)}</text>`];
  const ticks = (axis) => (plot.axes[axis]._splits ?? []).map((value, i) => [value, plot.axes[axis]._values[i] ?? ""]);
  for (const [value, text] of ticks(0)) {
    const x = left + plot.valToPos(value, "x");
    if (x < left - 1 || x > left + width + 1) continue;
    out.push(`<path d="M${x} ${top}V${top + height}" stroke="#e4e8ee"/><text x="${x}" y="${top + height + 16}" text-anchor="middle">${plain(text)}</text>`);
  }
  for (const [value, text] of ticks(1)) {
    const y = top + plot.valToPos(value, "y");
    if (y < top - 1 || y > top + height + 1) continue;
    out.push(`<path d="M${left} ${y}h${width}" stroke="#e4e8ee"/><text x="${left - 6}" y="${y + 4}" text-anchor="end">${plain(text)}</text>`);
  }
  out.push(`<text x="${left + 0.5 * width}" y="${top + height + 34}" text-anchor="middle">${plain(labels[0])}</text>`,
    `<text transform="translate(14 ${top + 0.5 * height}) rotate(-90)" text-anchor="middle">${plain(labels[1])}</text>`,
    `<clipPath id="area"><rect x="${left}" y="${top}" width="${width}" height="${height}"/></clipPath><g clip-path="url(#area)" fill="none" stroke-width="1.6">`);
  lines.forEach(({ colour, dash }, s) => {
    let path = "", pen = false;
    plot.data[0].forEach((x, i) => {
      const y = plot.data[s + 1][i];
      if (y === undefined) return; // another curve's time
      if (y === null) return void (pen = false);
      path += `${pen ? "L" : "M"}${(left + plot.valToPos(x, "x")).toFixed(2)} ${(top + plot.valToPos(y, "y")).toFixed(2)}`;
      pen = true;
    });
    out.push(`<path d="${path}" stroke="${colour}"${dash ? ` stroke-dasharray="${dash.join(" ")}"` : ""}/>`);
  });
  out.push(`</g><rect x="${left}" y="${top}" width="${width}" height="${height}" fill="none" stroke="#5b6675"/>`);
  lines.forEach(({ label, colour, dash }, s) => {
    const x = left + (s % 3) * (width / 3), y = top + height + 54 + 16 * Math.floor(s / 3);
    out.push(`<path d="M${x} ${y - 4}h22" stroke="${colour}" stroke-width="2"${dash ? ` stroke-dasharray="${dash.join(" ")}"` : ""}/>` +
      `<text x="${x + 28}" y="${y}">${plain(label)}</text>`);
  });
  return out.join("\n") + "\n</svg>\n";
}

// The views beside each other with their names, the time, and the colour scales below. At most `most` pixels wide.
function composed(views, time, most) {
  const columns = Math.min(views.length, Math.ceil(Math.sqrt(views.length))), each = views[0].canvas;
  const scale = Math.min(1, most / (columns * each.width)), w = Math.round(each.width * scale), h = Math.round(each.height * scale);
  const dots = Math.max(1, w / (each.clientWidth || w)), line = Math.round(22 * dots), head = views.length > 1 ? line : 0;
  const rows = Math.ceil(views.length / columns), scales = views[0].scales();
  const board = element("canvas", { width: columns * w, height: line + rows * (h + head) + (scales.length ? Math.round(2.1 * line) : 0) });
  const brush = board.getContext("2d");
  brush.fillStyle = css("--card");
  brush.fillRect(0, 0, board.width, board.height);
  brush.fillStyle = css("--text");
  brush.textBaseline = "middle";
  brush.font = `600 ${Math.round(13 * dots)}px system-ui, sans-serif`;
  brush.fillText(time, 8 * dots, 0.5 * line);
  views.forEach((view, i) => {
    const x = (i % columns) * w, y = line + Math.floor(i / columns) * (h + head);
    if (head) brush.fillText(view.name, x + 8 * dots, y + 0.5 * head, w - 16 * dots);
    brush.drawImage(view.canvas, x, y + head, w, h);
  });
  brush.font = `${Math.round(12 * dots)}px system-ui, sans-serif`;
  scales.forEach(([title, map], i) => {
    const x = 8 * dots + (i * board.width) / scales.length, wide = board.width / scales.length - 16 * dots;
    const y = board.height - 1.9 * line, bar = Math.round(0.5 * line);
    brush.fillStyle = css("--text");
    brush.fillText(title, x, y + 0.3 * line);
    for (let k = 0; k < wide; ++k) {
      brush.fillStyle = map.css(map.value(k / wide));
      brush.fillRect(x + k, y + 0.65 * line, 1.5, bar);
    }
    brush.fillStyle = css("--soft");
    brush.textAlign = "left";
    brush.fillText(short(Number(map.low.toPrecision(3))), x, y + 1.55 * line);
    brush.textAlign = "right";
    brush.fillText(short(Number(map.high.toPrecision(3))), x + wide, y + 1.55 * line);
    brush.textAlign = "left";
  });
  return board;
}

const png = (board) => new Promise((done) => board.toBlob(done, "image/png"));

/** Buttons for pictures of the views of this moment and of all output times. views(): { canvas, name, scales() } each. */
export function pictureButtons(title, views, transport) {
  const picture = element("button", { type: "button", title: "This picture as a file" }, "PNG");
  const film = element("button", { type: "button", title: "All output times as an animated PNG, which browsers show" }, "Animation");
  picture.onclick = async () => download(fileName(title, "png"), await png(composed(views(), transport.text(), 4096)));
  film.onclick = async () => {
    const at = transport.index(), pictures = [];
    film.disabled = true;
    for (let i = 0; i < transport.count; ++i) {
      transport.go(i);
      film.textContent = `${i + 1} of ${transport.count}`;
      pictures.push(new Uint8Array(await (await png(composed(views(), transport.text(), 1000))).arrayBuffer()));
    }
    transport.go(at);
    film.textContent = "Animation";
    film.disabled = false;
    download(fileName(`${title} animation`, "png"), animated(pictures, transport.wait));
  };
  return [picture, film];
}
