// Sets a displayed formula smaller where it is wider than the page; without this script it scrolls.
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
  }
  document.fonts.ready.then(fit);
  window.addEventListener("resize", fit);
})();
