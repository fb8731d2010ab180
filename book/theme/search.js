"use strict";

// The search: all sections that have every word, those in whose titles they stand first. A word is
// found as it is typed, in names such as `normalize_and_length`, too.
{
    const [box, toggle, field, status, list] = ["search", "search-toggle", "search-field", "search-status", "search-results"]
        .map(id => document.getElementById(id));
    const LIMIT = 20;
    const lower = text => text.toLocaleLowerCase("en");
    // The plural finds the singular.
    const parts = query => lower(query).split(/\s+/).filter(Boolean).map(word => word.length < 4 ? word : word.replace(/s$/, ""));
    const letter = /[\p{L}\p{N}_]/u;

    // How well a section answers: 0 where one of the words is not in it.
    function score({ title, text }, words) {
        const scores = words.map(word => {
            const [inTitle, at] = [lower(title).includes(word), text.indexOf(word)];
            const isWhole = 0 <= at && !letter.test(text[at - 1] ?? " ") && !letter.test(text[at + word.length] ?? " ");
            return (inTitle ? 20 : 0) + (isWhole ? 3 : 0) + Math.min(text.split(word).length - 1, 9);
        });
        return scores.includes(0) ? 0 : scores.reduce((sum, one) => sum + one, 0);
    }

    // The words around the first one that is found, which is marked.
    function teaser(section, [word]) {
        const at = Math.max(0, section.text.indexOf(word));
        const begin = at < 60 ? 0 : section.body.indexOf(" ", at - 60) + 1;
        const [before, found, after] = [[begin, at], [at, at + word.length], [at + word.length, at + 120]]
            .map(([from, to]) => section.body.slice(from, to));
        const line = document.createElement("span");
        line.className = "teaser";
        line.append(begin ? "… " : "", before, Object.assign(document.createElement("em"), { textContent: found }), after, " …");
        return line;
    }

    function result(section, words) {
        const link = document.createElement("a");
        // Browsers that can mark the word on the page do so.
        link.href = `${path_to_root}${section.address}:~:text=${encodeURIComponent(words[0])}`;
        link.textContent = section.title;
        const item = document.createElement("li");
        item.append(link, teaser(section, words));
        return item;
    }

    function show() {
        if (!sections.length) return status.textContent = "There is no index here: cargo run makes it.";
        const words = parts(field.value);
        const found = words.length === 0 ? [] : sections.map(section => [score(section, words), section])
            .filter(([points]) => points).sort(([a], [b]) => b - a);
        const count = found.length === 1 ? "1 section has" : `${found.length} sections have`;
        status.textContent = words.length ? `${count} ${field.value.trim()}${LIMIT < found.length ? `; here are ${LIMIT}` : ""}` : "";
        list.replaceChildren(...found.slice(0, LIMIT).map(([, section]) => result(section, words)));
    }

    const sections = [];
    const open = async isOpen => {
        box.classList.toggle("hidden", !isOpen);
        toggle.setAttribute("aria-expanded", isOpen);
        if (!isOpen) return toggle.focus();
        field.focus();
        field.select();
        if (sections.length) return;
        await load("search-index.js");
        // Lower case has the same length, but for a few letters that the book does not use.
        for (const [address, title, body] of window.searchIndex ?? []) sections.push({ address, title, body, text: lower(body) });
        show();
    };
    toggle.addEventListener("click", () => open(box.classList.contains("hidden")));
    field.form.addEventListener("submit", event => event.preventDefault());
    field.addEventListener("input", show);
    addEventListener("keydown", event => {
        const isTyping = /^(input|select|textarea)$/i.test(event.target.nodeName) || event.target.isContentEditable;
        if (event.altKey || event.ctrlKey || event.metaKey) return;
        if (event.key === "Escape" && box.contains(event.target)) open(false);
        else if (["/", "s"].includes(event.key) && !isTyping) open(true);
        else return;
        event.preventDefault();
    });
    // Up and down go through the results.
    box.addEventListener("keydown", event => {
        const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
        if (!step) return;
        event.preventDefault();
        const stops = [field, ...list.querySelectorAll("a")];
        stops[stops.indexOf(document.activeElement) + step]?.focus();
    });
    const asked = new URLSearchParams(location.search).get("search");
    if (asked) {
        field.value = asked;
        open(true);
    }
}
