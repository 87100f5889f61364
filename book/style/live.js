// "Try it": fields from the description of an example; on a page of `cargo book serve`, Compute replaces what stands for
// that example. Opened as a file, the page keeps what was computed once and says how to start the server.
(function () {
  "use strict";
  const isServed = location.protocol === "http:" && ["127.0.0.1", "localhost"].includes(location.hostname);
  const page = location.pathname.split("/").pop() || "index.html";
  const isOnce = document.querySelectorAll("main h1").length > 1; // the page for printing
  if (isOnce) return;

  function element(name, properties, ...children) {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
  }
  // A slider's position in [0, 1000] and the value there.
  function scale(option) {
    const [low, high] = option.slider;
    const isWhole = option.kind === "integer";
    const rounded = function (x) {
      if (isWhole) return String(Math.round(x));
      if (option.scale === "factors") return String(Number(x.toPrecision(2)));
      return String(Number(x.toFixed(3)));
    };
    if (option.scale === "factors") {
      const span = Math.log(high / low);
      return {
        value: (at) => rounded(low * Math.exp((span * at) / 1000)),
        at: (x) => (1000 * Math.log(Math.max(x, low) / low)) / span,
      };
    }
    return {
      value: (at) => rounded(low + ((high - low) * at) / 1000),
      at: (x) => (1000 * (x - low)) / (high - low),
    };
  }

  class Panel {
    constructor(details) {
      this.details = details;
      this.example = details.dataset.example;
      this.description = JSON.parse(details.querySelector(".try-options").textContent);
      this.fields = new Map();
      this.known = new Map(); // what the page showed first
      this.running = null;
      this.build();
      this.fromAddress();
    }

    build() {
      const form = element("form", { className: "try-form" });
      for (const option of this.description.options) form.append(this.field(option));
      this.go = element("button", { type: "submit", textContent: "Compute" });
      this.stop = element("button", { type: "button", textContent: "Stop", hidden: true });
      this.back = element("button", { type: "button", textContent: "Back to the book", hidden: true });
      this.said = element("output", { className: "try-said" });
      const words = { quick: "answers at once", seconds: "takes some seconds", long: "may take a minute" };
      this.said.textContent = words[this.description.cost] || "";
      this.stop.addEventListener("click", () => this.end());
      this.back.addEventListener("click", () => this.restore());
      form.append(element("div", { className: "try-buttons" }, this.go, this.stop, this.back, this.said));
      form.addEventListener("submit", (event) => {
        event.preventDefault();
        this.compute();
      });
      // The arrow keys belong to the fields here; elsewhere they turn the pages of the book.
      form.addEventListener("keydown", (event) => event.stopPropagation());
      this.more = element("div", { className: "try-more" });
      this.details.append(form, this.more);
      if (!isServed) {
        for (const control of form.elements) control.disabled = true;
      } else {
        this.details.querySelector(".try-help").hidden = true;
      }
    }

    field(option) {
      const name = element("span", { className: "try-name", textContent: option.name, title: option.help });
      const row = element("label", { className: "try-field" }, name);
      let input;
      if (option.kind === "flag") {
        input = element("input", { type: "checkbox" });
      } else if (option.kind === "choice") {
        input = element("select", {});
        const words = option.default ? option.choices : ["", ...option.choices];
        for (const word of words) input.append(element("option", { value: word, textContent: word || "unless given" }));
        input.value = option.default;
      } else {
        input = element("input", { type: "text", value: option.default, spellcheck: false, autocomplete: "off" });
        input.maxLength = 200;
      }
      row.append(input);
      if (option.choices && option.kind !== "choice") this.offer(option, input, row);
      if (option.slider) this.slide(option, input, row);
      row.append(element("span", { className: "try-what", textContent: option.help }));
      if (option.kind === "flag" || option.kind === "choice") {
        input.addEventListener("change", () => this.compute());
      }
      this.fields.set(option.name, { option, input });
      return row;
    }

    // Words that may be completed by numbers: cantor:0.3:20.
    offer(option, input, row) {
      const id = "try-" + this.example + "-" + option.name;
      const list = element("datalist", { id });
      for (const word of option.choices) list.append(element("option", { value: word }));
      input.setAttribute("list", id);
      row.append(list);
    }

    slide(option, input, row) {
      const by = scale(option);
      const range = element("input", { type: "range", min: 0, max: 1000, step: option.kind === "integer" ? 1 : 5 });
      range.setAttribute("aria-label", option.name);
      const follow = () => {
        const first = parseFloat(input.value.split(",")[0]);
        if (Number.isFinite(first)) range.value = by.at(first);
      };
      follow();
      input.addEventListener("input", follow);
      range.addEventListener("input", () => {
        input.value = by.value(Number(range.value));
        range.setAttribute("aria-valuetext", input.value);
        if (this.description.cost === "quick") this.soon();
      });
      range.addEventListener("change", () => this.compute());
      row.append(range);
    }

    asked() {
      const options = {};
      for (const [name, { option, input }] of this.fields) {
        const value = option.kind === "flag" ? (input.checked ? "true" : "") : input.value.trim();
        if (value !== "" && value !== option.default) options[name] = value;
      }
      return options;
    }

    // A link to this page with these parameters.
    toAddress(options) {
      const words = new URLSearchParams(options ? { try: this.example, ...options } : {});
      const query = words.toString();
      history.replaceState(null, "", location.pathname + (query ? "?" + query : "") + location.hash);
    }

    fromAddress() {
      const words = new URLSearchParams(location.search);
      if (words.get("try") !== this.example) return;
      for (const [name, { option, input }] of this.fields) {
        if (!words.has(name)) continue;
        if (option.kind === "flag") input.checked = words.get(name) === "true";
        else input.value = words.get(name);
        input.dispatchEvent(new Event("input"));
      }
      this.details.open = true;
      this.compute();
    }

    soon() {
      if (this.running) {
        this.again = true;
        return;
      }
      this.compute();
    }

    async compute() {
      if (!isServed) return;
      this.end();
      const options = this.asked();
      this.toAddress(options);
      const run = new AbortController();
      this.running = run;
      this.again = false;
      this.stop.hidden = false;
      const start = performance.now();
      const seconds = () => ((performance.now() - start) / 1000).toFixed(1);
      const clock = setInterval(() => (this.said.textContent = "computing, " + seconds() + " s"), 100);
      try {
        const answer = await fetch("run", {
          method: "POST",
          headers: { "Content-Type": "application/json" },
          body: JSON.stringify({ example: this.example, page, options }),
          signal: run.signal,
        });
        const found = await answer.json();
        if (run !== this.running) return;
        if (answer.ok) this.show(found, performance.now() - start);
        else this.said.textContent = found.error;
        this.said.classList.toggle("refused", !answer.ok);
      } catch (error) {
        if (run !== this.running && this.running) return;
        this.said.textContent = run.signal.aborted ? "stopped" : "the server does not answer: cargo book serve";
      } finally {
        clearInterval(clock);
        if (run === this.running || !this.running) {
          this.running = null;
          this.stop.hidden = true;
          if (this.again) this.compute();
        }
      }
    }

    end() {
      if (this.running) this.running.abort();
      this.running = null;
    }

    places() {
      return document.querySelectorAll("main [data-live]");
    }

    show(found, milliseconds) {
      for (const place of this.places()) {
        const text = place.dataset.live;
        if (!(text in found.blocks)) continue;
        if (!this.known.has(place)) this.known.set(place, place.innerHTML);
        // At the start of a sentence words begin with a capital.
        const begins = "begins" in place.dataset && text in found.begins;
        const html = begins ? found.begins[text] : found.blocks[text];
        const slider = place.querySelector("figure-slider input");
        const at = slider && slider.value;
        // Where these parameters have no such entry, what the book says stays and is dimmed.
        place.innerHTML = html === null ? this.known.get(place) : html;
        place.classList.toggle("not-computed", html === null);
        place.classList.toggle("computed", html !== null);
        const moved = place.querySelector("figure-slider input");
        if (at && moved && Number(at) <= Number(moved.max)) {
          moved.value = at;
          moved.dispatchEvent(new Event("input"));
        }
      }
      this.more.innerHTML = found.more.join("");
      window.dispatchEvent(new Event("resize")); // new tables are looked at
      this.back.hidden = false;
      this.said.textContent = found.verdict + " (" + Math.round(milliseconds) + " ms)";
      this.said.dataset.milliseconds = Math.round(milliseconds);
    }

    restore() {
      this.end();
      for (const [place, html] of this.known) {
        place.innerHTML = html;
        place.classList.remove("computed", "not-computed");
      }
      this.more.replaceChildren();
      this.back.hidden = true;
      this.said.textContent = "";
      for (const { option, input } of this.fields.values()) {
        if (option.kind === "flag") input.checked = false;
        else input.value = option.default;
        input.dispatchEvent(new Event("input"));
      }
      this.toAddress(null);
    }
  }

  const panels = Array.from(document.querySelectorAll("details.try-it"), (details) => new Panel(details));
  window.addEventListener("pagehide", () => panels.forEach((panel) => panel.end()));
})();
