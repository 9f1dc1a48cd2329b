// Sets the formulas of a page with KaTeX: Sphinx marks them \(...\) and \[...\] in elements of class math.
document.addEventListener("DOMContentLoaded", () => {
  for (const element of document.querySelectorAll(".math")) {
    const text = element.textContent.trim();
    const display = text.startsWith("\\[");
    if (!display && !text.startsWith("\\(")) continue;
    katex.render(text.slice(2, -2), element, { displayMode: display, throwOnError: false });
  }
});
