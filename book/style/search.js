// Looks up words in the index beside the pages; works from files, since the index is a script. `?search=WORDS` in the
// address opens it, so does the key "/".
(function () {
  "use strict";
  const bar = document.querySelector(".left-buttons");
  if (!bar) return;
  const most = 40;
  const button = document.createElement("button");
  button.className = "icon-button search-open";
  button.type = "button";
  button.title = "Look up words (/)";
  button.setAttribute("aria-label", "Look up words");
  button.setAttribute("aria-expanded", "false");
  button.innerHTML =
    '<svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true"><g fill="none" stroke="currentColor" ' +
    'stroke-width="2"><circle cx="8.5" cy="8.5" r="5.5"/><path d="M12.5 12.5 18 18"/></g></svg>';
  bar.append(button);
  const panel = document.createElement("div");
  panel.className = "search-panel";
  panel.hidden = true;
  const input = document.createElement("input");
  input.type = "search";
  input.placeholder = "Gagliardo, dual norm, Theorem 3.1";
  input.setAttribute("aria-label", "Words to look up");
  const said = document.createElement("p");
  said.className = "search-said";
  said.setAttribute("aria-live", "polite");
  const list = document.createElement("ol");
  panel.append(input, said, list);
  document.querySelector("main").before(panel);

  const plain = (text) => text.toLowerCase().normalize("NFD").replace(/[\u0300-\u036f]/g, "");
  let index = null;
  function load(then) {
    if (index) return then();
    const script = document.createElement("script");
    script.src = "search-index.js";
    script.onload = () => {
      index = window.bookIndex.map(([page, anchor, chapter, title, text]) => {
        return { page, anchor, chapter, title, text, words: plain(title + " " + text), heading: plain(title) };
      });
      then();
    };
    script.onerror = () => (said.textContent = "The index is not there.");
    document.head.append(script);
  }

  // The whole phrase counts most, in a heading more; else all words must occur.
  function rank(entry, phrase, words) {
    if (!words.every((word) => entry.words.includes(word))) return 0;
    let value = 1;
    if (entry.words.includes(phrase)) value += 10;
    if (entry.heading.includes(phrase)) value += 100;
    for (const word of words) value += Math.min(entry.words.split(word).length - 1, 5) / 10;
    return value;
  }

  function around(entry, phrase, words) {
    const text = entry.text;
    const low = plain(text);
    const whole = low.length === text.length ? low : text.toLowerCase();
    let at = whole.indexOf(phrase);
    if (at < 0) at = Math.max(0, whole.indexOf(words[0]));
    const from = Math.max(0, at - 60);
    return (from > 0 ? "…" : "") + text.slice(from, at + 120) + (at + 120 < text.length ? "…" : "");
  }

  function look() {
    const phrase = plain(input.value.trim());
    list.replaceChildren();
    said.textContent = "";
    if (phrase.length < 2) return;
    load(() => {
      const words = phrase.split(/\s+/);
      const found = index.map((entry) => [rank(entry, phrase, words), entry]).filter(([value]) => value > 0);
      found.sort((a, b) => b[0] - a[0]);
      said.textContent = found.length === 1 ? "1 section" : found.length + " sections";
      list.replaceChildren();
      for (const [, entry] of found.slice(0, most)) {
        const link = document.createElement("a");
        link.href = entry.page + "#" + entry.anchor;
        link.textContent = entry.title === entry.chapter ? entry.title : entry.chapter + " › " + entry.title;
        link.addEventListener("click", () => show(false));
        const words_around = document.createElement("span");
        words_around.textContent = around(entry, phrase, words);
        const item = document.createElement("li");
        item.append(link, words_around);
        list.append(item);
      }
    });
  }

  function show(isShown) {
    panel.hidden = !isShown;
    button.setAttribute("aria-expanded", String(isShown));
    if (isShown) {
      window.scrollTo({ top: 0 });
      input.focus();
      look();
    }
  }
  button.addEventListener("click", () => show(panel.hidden));
  input.addEventListener("input", look);
  // Letters and arrows belong to the field here; elsewhere they are shortcuts of the book.
  panel.addEventListener("keydown", (event) => {
    event.stopPropagation();
    if (event.key === "Escape") show(false);
  });
  document.addEventListener("keydown", (event) => {
    const isField = /^(input|select|textarea)$/i.test(event.target.tagName || "");
    if (event.key === "/" && !isField && !event.ctrlKey && !event.metaKey && !event.altKey) {
      event.preventDefault();
      show(true);
    }
  });
  const asked = new URLSearchParams(location.search).get("search");
  if (asked) {
    input.value = asked;
    show(true);
  }
})();
