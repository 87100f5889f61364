// Sets a displayed formula smaller where it is wider than the page; without this script it scrolls. A long formula within a
// line scrolls too. What scrolls is marked. What is folded is looked at when it opens.
(function () {
  "use strict";
  const smallest = 0.7;
  function fit() {
    for (const formula of document.querySelectorAll(".display-formula")) {
      const math = formula.querySelector("math");
      if (!math) continue;
      math.style.fontSize = "";
      const share = formula.clientWidth / formula.scrollWidth;
      if (share >= 1) continue;
      const size = parseFloat(getComputedStyle(math).fontSize);
      math.style.fontSize = Math.max(0.98 * share, smallest) * size + "px";
    }
    // A formula within a line that is longer than the line gets one of its own and scrolls.
    for (const formula of document.querySelectorAll("main .inline-formula")) {
      formula.classList.remove("long");
      const line = formula.closest("p, li, td, blockquote, main");
      if (line && formula.offsetWidth > line.clientWidth) formula.classList.add("long");
    }
  }
  // Cells with many words keep a width in which these can be read, on a phone too.
  for (const cell of document.querySelectorAll("main td")) cell.classList.toggle("words", cell.textContent.length > 40);
  // What is still wider is marked, and where its end is in sight.
  function mark(box) {
    const hidden = box.scrollWidth - box.clientWidth;
    box.classList.toggle("scrolls", hidden > 1);
    box.classList.toggle("at-end", hidden - box.scrollLeft <= 2);
  }
  const boxes = "main .table-wrapper, main .display-formula";
  function all() {
    fit();
    document.querySelectorAll(boxes).forEach(mark);
  }
  function scrolled(event) {
    if (event.target instanceof Element && event.target.matches(boxes)) mark(event.target);
  }
  // On paper nothing scrolls: before printing formulas and tables are fitted to the width of the text on A4, in the letters
  // that the style has for paper.
  const paper = { width: "628px", fontSize: "0.88em" };
  function fitTables() {
    for (const box of document.querySelectorAll("main .table-wrapper")) {
      const share = box.clientWidth / box.scrollWidth;
      if (share < 1) box.style.fontSize = Math.max(0.97 * share, 0.5) * parseFloat(getComputedStyle(box).fontSize) + "px";
    }
  }
  window.addEventListener("beforeprint", () => {
    const main = document.querySelector("main");
    Object.assign(main.style, paper);
    fit();
    fitTables();
    Object.assign(main.style, { width: "", fontSize: "" });
  });
  window.addEventListener("afterprint", () => {
    for (const box of document.querySelectorAll("main .table-wrapper")) box.style.fontSize = "";
    all();
  });
  // On a phone a tap on a picture enlarges it, and shrinks it again.
  document.addEventListener("click", (event) => {
    const picture = event.target instanceof Element && event.target.closest("main figure.chart svg");
    if (picture && window.matchMedia("(max-width: 600px)").matches) picture.closest("figure.chart").classList.toggle("large");
  });
  document.addEventListener("scroll", scrolled, { capture: true, passive: true });
  document.fonts.ready.then(all);
  window.addEventListener("resize", all);
  document.addEventListener("toggle", all, true);
  // The page that holds all pages begins with a title and the contents; both show on paper only (book.css).
  const main = document.querySelector("main");
  const pages = main ? main.querySelectorAll("h1") : [];
  if (pages.length > 1) {
    const title = document.createElement("section");
    title.className = "title-page";
    const book = document.createElement("p");
    book.className = "title";
    book.textContent = document.title;
    title.append(book);
    const contents = document.createElement("nav");
    contents.className = "print-contents";
    const list = document.createElement("ol");
    for (const page of pages) {
      const link = document.createElement("a");
      link.href = "#" + page.id;
      link.textContent = page.textContent;
      const item = document.createElement("li");
      item.append(link);
      list.append(item);
    }
    contents.append(list);
    main.prepend(title, contents);
  }
})();
