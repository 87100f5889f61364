// Sets a displayed formula smaller where it is wider than the page; without this script it scrolls. A long formula within a
// line scrolls too. What is folded is looked at when it opens.
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
  document.fonts.ready.then(fit);
  window.addEventListener("resize", fit);
  document.addEventListener("toggle", fit, true);
})();
