"use strict";

// What every page needs: the theme, the contents, the listings, the problems on paper, and the
// loading of the other scripts.

// The only variable that the scripts share. Each script adds members to this object. The file
// tests/browser/theme.d.ts describes all members.
/** @type {Book} */
const book = /** @type {any} */ ({ root: document.documentElement });
{
    const { root } = book;
    root.classList.add("js");

    // Under Trusted Types, this policy makes the page accept only HTML that these scripts write,
    // and load scripts only from the addresses in `ownAddresses`. If a server requires Trusted
    // Types but forbids the policy, no other script can be loaded, and the page says so.
    const ownAddresses = new Set();
    let isOwnHTML = false;
    try {
        window.trustedTypes?.createPolicy("default", {
            createHTML: text => isOwnHTML ? text : null,
            createScriptURL: address => ownAddresses.has(address) ? address : null,
        });
    } catch { /* The server forbids the policy. */ }

    book.trustAddress = address => { ownAddresses.add(address); };

    book.writeHTML = act => {
        isOwnHTML = true;
        try { act(); } finally { isOwnHTML = false; }
    };

    book.make = (tag, attributes, ...children) => {
        const element = document.createElement(tag);
        for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
        element.append(...children);
        return element;
    };

    book.setText = (element, text) => { if (element.textContent !== text) element.textContent = text; };

    book.makeRange = (element, from, length) => {
        const range = document.createRange();
        const texts = document.createTreeWalker(element, NodeFilter.SHOW_TEXT);
        range.selectNodeContents(element);
        let at = 0;
        for (let text = texts.nextNode(); text; text = texts.nextNode()) {
            const end = at + text.textContent.length;
            if (at <= from && from < end) range.setStart(text, from - at);
            if (at < from + length && from + length <= end) range.setEnd(text, from + length - at);
            at = end;
        }
        return range;
    };

    book.copyAndReport = async (button, text, words = "Copied") => {
        const label = button.dataset.label ??= button.textContent;
        const isCopied = await navigator.clipboard?.writeText(text).then(() => true, () => false);
        button.textContent = isCopied ? words : "Not copied";
        setTimeout(() => { button.textContent = label; }, 1500);
    };

    // What a reader does on a page is stored only in the browser. In a private window, a browser
    // may refuse to store anything.
    book.recall = name => {
        try { return JSON.parse(localStorage.getItem(name)) ?? {}; } catch { return {}; /* a private window */ }
    };

    book.store = (name, key, value) => {
        try { localStorage.setItem(name, JSON.stringify({ ...book.recall(name), [key]: value })); } catch { /* a private window */ }
    };

    book.readNumber = text => {
        const parts = text.replace(/[\s°]/g, "").replace(/−/g, "-").split("/").map(part => part.replace(",", "."));
        const numbers = parts.map(part => part ? Number(part) : NaN);
        return numbers.length < 3 ? numbers.reduce((numerator, denominator) => numerator / denominator) : NaN;
    };

    book.readUndoKey = ({ key, ctrlKey, metaKey, shiftKey }) => {
        const letter = ctrlKey || metaKey ? key.toLowerCase() : "";
        if (letter === "y" && ctrlKey) return 1;
        if (letter !== "z") return 0;
        return shiftKey ? 1 : -1;
    };

    book.whenNear = (elements, near) => {
        const observer = new IntersectionObserver(entries => {
            for (const { isIntersecting, target } of entries) {
                if (!isIntersecting) continue;
                observer.unobserve(target);
                near(/** @type {HTMLElement} */ (target));
            }
        }, { rootMargin: "400px" });
        elements.forEach(element => observer.observe(element));
    };

    /** @template State @implements {UndoHistory<State>} */
    class History {
        /** @param {State} state */
        constructor(state) {
            this.states = [state];
            this.current = 0;
        }

        /** @param {State} state */
        record(state) {
            if (JSON.stringify(state) === JSON.stringify(this.states[this.current])) return;
            this.current += 1;
            this.states.splice(this.current, Infinity, state);
        }

        /** @param {number} steps */
        has(steps) {
            return this.current + steps in this.states;
        }

        /** @param {number} steps */
        go(steps) {
            this.current += steps;
            return this.states[this.current];
        }
    }
    book.History = History;

    // The stylesheet lets a browser skip the layout of elements that are far from the viewport.
    // Once an element has come near the viewport, the element stays laid out.
    book.whenNear(document.querySelectorAll("main > *"), part => { part.style.contentVisibility = "visible"; });

    // The theme. While `auto` is chosen, the theme is the system's. From `auto`, the first click
    // chooses the theme that the system doesn't use, so that the page changes visibly. The second
    // click chooses the system's theme, and the third click returns to `auto`.
    {
        const others = matchMedia("(prefers-color-scheme: dark)").matches ? ["light", "dark"] : ["dark", "light"];
        const themes = ["auto", ...others];
        const button = document.getElementById("theme-toggle");
        /** @param {string} theme */
        const show = theme => {
            root.dataset.theme = theme;
            button.title = `Theme: ${theme}`;
            button.setAttribute("aria-label", button.title);
        };
        let kept = "auto";
        try { kept = localStorage.getItem("theme") ?? kept; } catch { /* a private window */ }
        show(themes.includes(kept) ? kept : "auto");
        button.addEventListener("click", () => {
            show(themes[(themes.indexOf(root.dataset.theme) + 1) % themes.length]);
            try { localStorage.setItem("theme", root.dataset.theme); } catch { /* a private window */ }
        });
    }

    // The table of contents: mark the current chapter, list the chapter's sections as links, and
    // mark the section that is being read.
    {
        const contents = document.getElementById("contents");
        // The section being read is the last one whose heading is above the middle of the window.
        // The observer's top margin is larger than any page, so that headings above the window
        // count, too.
        /** @param {Map<Element, HTMLAnchorElement>} sections each heading with its link */
        const markSection = sections => {
            /** @type {Set<Element>} */
            const begun = new Set();
            /** @type {HTMLAnchorElement | undefined} */
            let marked;
            const observer = new IntersectionObserver(entries => {
                for (const { isIntersecting, target } of entries) begun[isIntersecting ? "add" : "delete"](target);
                const link = sections.get([...sections.keys()].filter(heading => begun.has(heading)).at(-1));
                if (link === marked) return;
                marked?.removeAttribute("aria-current");
                link?.setAttribute("aria-current", "location");
                link?.scrollIntoView({ block: "nearest" });
                marked = link;
            }, { rootMargin: "1000000px 0px -50%" });
            for (const heading of sections.keys()) observer.observe(heading);
        };
        contents.addEventListener("click", event => {
            if (/** @type {Element} */ (event.target).closest("a")) contents.hidePopover();
        });
        const links = [...contents.querySelectorAll("a")];
        // Some servers leave out `.html` in the addresses of pages.
        /** @param {{ pathname: string }} url */
        const name = url => url.pathname.split("/").pop().replace(/\.html$/, "");
        // The table of contents shows a tick at a step once a check has found that the reader's
        // picture of this step is right.
        book.markRight = () => {
            const right = book.recall("right");
            for (const link of links) {
                if (!right[name(link)] || link.querySelector(".tick")) continue;
                link.append(book.make("span", { class: "tick", role: "img", "aria-label": "your picture was right", title: "Your picture was right" }, "✓"));
            }
        };
        book.markRight();
        const here = links.find(a => name(a) === name(location)) ?? (["", "index"].includes(name(location)) ? links[0] : null);
        if (here) {
            here.setAttribute("aria-current", "page");
            const list = book.make("ol", { class: "here" });
            /** @type {Map<Element, HTMLAnchorElement>} */
            const sections = new Map();
            for (const heading of document.querySelectorAll("main h2[id]")) {
                const copy = /** @type {Element} */ (heading.cloneNode(true));
                const words = copy.querySelector("a.header").childNodes;
                const link = book.make("a", { href: `#${heading.id}` }, ...words);
                sections.set(heading, link);
                list.append(book.make("li", {}, link));
            }
            if (sections.size) here.closest("li").append(list);
            markSection(sections);
            contents.addEventListener("toggle", () => {
                (list.querySelector("[aria-current]") ?? here).scrollIntoView({ block: "center" });
            });
            // Measure in the next frame, because the browser lays out the page for that frame
            // anyway.
            requestAnimationFrame(() => {
                if (contents.scrollHeight > contents.clientHeight) here.scrollIntoView({ block: "center" });
            });
        }
    }

    /** @type {Record<string, Promise<boolean>>} */
    const scripts = {};
    book.load = (file, isLarge = false) => scripts[file] ??= new Promise(done => {
        const script = document.createElement("script");
        const address = root.dataset.root + file;
        const onload = () => done(true);
        const onerror = () => {
            delete scripts[file];
            done(false);
        };
        book.trustAddress(address);
        try {
            document.head.append(Object.assign(script, { src: address, async: isLarge, onload, onerror }));
        } catch { // The server's policy forbids scripts from loading scripts.
            onerror();
        }
    });

    // Says on the page that a script is missing. Only the first missing script is reported.
    /** @param {string} file */
    function sayMissing(file) {
        if (document.querySelector(".missing")) return;
        const words = `A part of this page did not load (${file}), so some figures, forms or the search don't work here. `
            + "Perhaps the server's Content-Security-Policy forbids it.";
        document.querySelector("main").prepend(book.make("p", { class: "missing refused", role: "status" }, words));
    }

    // Code is coloured when it comes near the view, and each listing has a button that copies the
    // listing.
    const isWhole = document.body.matches(".whole");
    book.colourCode = code => {
        try { book.writeHTML(() => window.hljs?.highlightBlock(code)); } catch { /* The code stays without colours. */ }
    };
    book.colour = code => void book.load("highlight.js").then(isLoaded => isLoaded && setTimeout(() => {
        // Colouring replaces the elements of the listing's lines. So don't colour a listing that is
        // being edited. If a line has the focus, move the focus to the line's new element.
        if (code.querySelector("[data-book]")) return;
        const name = code.querySelector(":focus")?.dataset.line;
        book.colourCode(code);
        code.querySelector(`[data-line="${name}"]`)?.focus({ preventScroll: true });
    }));
    for (const code of document.querySelectorAll("pre > code[class^=language-]")) {
        const caption = code.closest(".listing")?.querySelector("figcaption");
        if (!caption) continue;
        const label = `Copy ${caption.querySelector(".path").textContent}`;
        const button = book.make("button", { type: "button", class: "copy", "aria-label": label }, "Copy");
        caption.append(button);
        button.addEventListener("click", () => {
            const copy = /** @type {Element} */ (code.cloneNode(true));
            const edited = copy.querySelectorAll("[data-book]");
            for (const line of edited) line.textContent = line.dataset.book;
            // A file may be shown in several listings, which the reader pastes one below the other.
            // A blank line between two listings is copied with the lower listing. If the blank line
            // were copied with the upper listing, the file would end with a blank line until the
            // reader pastes the lower listing. An editor that formats the file in the meantime
            // would delete the blank line.
            const start = caption.parentElement.matches("[data-below-blank]") ? "\n" : "";
            const text = `${start}${copy.textContent.trimEnd()}\n`;
            book.copyAndReport(button, text, edited.length ? "Copied, without your lines" : "Copied");
        });
    }

    // The commands of a console are copied without the prompt and without their output.
    for (const code of document.querySelectorAll(".console code")) {
        const button = book.make("button", { type: "button", class: "copy", "aria-label": "Copy the command" }, "Copy");
        code.closest("figure").append(button);
        button.addEventListener("click", () => {
            const lines = code.textContent.split("\n").filter(line => line.startsWith("$ "));
            book.copyAndReport(button, lines.map(line => line.slice(2)).join("\n"));
        });
    }

    // Problems on paper: an answer is right if its relative error is at most the tolerance.
    for (const problem of isWhole ? [] : document.querySelectorAll(".problem")) {
        const [answer, tolerance] = [problem.dataset.answer, problem.dataset.tolerance].map(Number);
        const number = problem.querySelector(".number").textContent;
        const form = problem.querySelector("form"), input = form.querySelector("input"), verdict = form.querySelector("output");
        // A comma may be a decimal point or a thousands separator, so try both.
        /** @param {string} text */
        const judge = text => {
            const errors = [text, text.replace(/,(?=\d{3})/g, "")].map(one => book.readNumber(one) - answer).filter(Number.isFinite);
            const [error] = errors.sort((one, other) => Math.abs(one) - Math.abs(other));
            const isRight = Math.abs(error) <= tolerance * Math.abs(answer);
            if (error === undefined) return { isRight, words: "not a number" };
            if (isRight) return { isRight, words: "right" };
            return { isRight, words: `${Math.abs(error) <= 0.05 * Math.abs(answer) ? "close, but " : ""}too ${error < 0 ? "small" : "large"}` };
        };
        const check = () => {
            const { isRight, words } = judge(input.value);
            verdict.textContent = words;
            verdict.classList.toggle("right", isRight);
        };
        form.addEventListener("submit", event => {
            event.preventDefault();
            check();
            book.store("answers", number, input.value);
        });
        input.value = book.recall("answers")[number] ?? "";
        if (input.value) check();
        input.addEventListener("input", () => { verdict.textContent = ""; });
        form.hidden = false;
    }

    // Some elements may scroll sideways. Make these elements focusable, so that readers can scroll
    // them with the keyboard.
    document.querySelectorAll("main :is(pre, .table-wrapper)").forEach(part => { part.tabIndex = 0; });

    // Not all browsers take a figure's accessible name from its caption, so refer each figure to
    // its caption. The accessible name of a listing is the path of its file.
    document.querySelectorAll("figure:not([aria-label]) > figcaption").forEach((caption, k) => {
        const label = caption.querySelector(".path") ?? caption;
        label.id ||= `caption-${k}`;
        caption.parentElement.setAttribute("aria-labelledby", label.id);
    });

    // Tell translation programs to leave code, formulas and labels alone.
    document.querySelectorAll("code, math, svg, .symbol, .path").forEach(part => part.setAttribute("translate", "no"));

    // The scripts that only some pages need. The selector of a script matches the elements that
    // need the script. The scripts run in the order of this list.
    const SCRIPTS = {
        wasm: "[data-live], .woken, [data-check], [data-places]", handle: "figure:is([data-live], .woken)",
        own_scene: "figure:is([data-live=own_scene], [data-preview=own_scene].woken)",
        figure: "figure:is([data-live], .woken)", check_form: "form[data-check]", line_editor: "[data-places]",
    };
    const loadScripts = () => {
        for (const [name, selector] of Object.entries(isWhole ? {} : SCRIPTS)) {
            if (document.querySelector(selector)) loadOrSay(`theme/${name}.js`);
        }
    };

    /** @param {string} file */
    const loadOrSay = file => book.load(file).then(isLoaded => isLoaded || sayMissing(file));

    // A page can be read without colours, interactive parts and search, so these are loaded after
    // the page is shown.
    requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(() => {
        book.whenNear(document.querySelectorAll("pre > code:is(.language-rust, .language-toml)"), book.colour);
        loadScripts();
        loadOrSay("theme/search.js");
    })));

    // A preview loads its scripts and its module only when a reader first points at the preview,
    // presses it or focuses it. The last press is kept until the preview is ready.
    book.presses = new Map();
    for (const root of isWhole ? [] : document.querySelectorAll("figure[data-preview]")) {
        root.tabIndex = 0;
        const wake = () => {
            if (root.matches(".woken")) return;
            root.classList.add("woken");
            loadScripts();
            book.activateFigure?.(root);
        };
        for (const kind of ["pointerenter", "pointerdown", "focusin"]) root.addEventListener(kind, wake);
        for (const kind of ["pointerdown", "click"]) {
            root.addEventListener(kind, event => {
                if (/** @type {Element} */ (event.target).matches("img")) book.presses.set(root, /** @type {PointerEvent} */ (event));
            });
        }
        root.addEventListener("pointercancel", () => book.presses.delete(root));
    }
}
