// Moves between the frames of a figure. Without this script the frame that is not hidden stays.
(function () {
  "use strict";
  const powers = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };
  // "1e-3" is read as a power of ten.
  function written(label) {
    const power = /^1e(-?\d+)$/.exec(label);
    return power ? "10" + Array.from(power[1], (c) => powers[c]).join("") : label;
  }
  customElements.define(
    "figure-slider",
    class extends HTMLElement {
      connectedCallback() {
        // The script runs at the end of the page, so the frames are there; a copy of a slider holds a dead control.
        const frames = Array.from(this.querySelectorAll(".frame"));
        if (frames.length < 2) return;
        this.querySelector(".slider-control")?.remove();
        const control = document.createElement("label");
        const range = document.createElement("input");
        const value = document.createElement("output");
        range.type = "range";
        range.min = 0;
        range.max = frames.length - 1;
        range.value = this.dataset.shown;
        control.className = "slider-control";
        control.append(this.dataset.parameter + " ", range, value);
        const show = function () {
          frames.forEach((frame, k) => (frame.hidden = k !== Number(range.value)));
          value.textContent = written(frames[range.value].dataset.label);
          range.setAttribute("aria-valuetext", value.textContent);
        };
        range.addEventListener("input", show);
        // The arrow keys move the slider here; elsewhere they turn the pages of the book.
        range.addEventListener("keydown", (event) => event.stopPropagation());
        this.prepend(control);
        show();
      }
    },
  );
})();
