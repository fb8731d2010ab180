"use strict";

// Lines of the listings that the reader edits. A press on one makes it a text to write in, and a
// panel below the listing shows what it draws: the module `expressions` is the five steps, with
// what is written in those places. One line at a time is in hand; what others have stays.
{
    const SMALL = 320, LARGE = 640; // Columns while one types, and at rest.
    const REST = 300; // Milliseconds after the last key.
    const EDIT = /^(\w+)(?::|%3A)(.*)$/i;

    // Colours make other elements of the lines, unless they are edited.
    const find = name => document.querySelector(`[data-line="${name}"]`);
    const books = new Map(); // What the book has there, as HTML, of those that are edited or in hand.
    let hand = null;
    // All that was written, as the texts of the edited lines by name, and which of these the page has.
    let [states, current] = [[{}], 0];
    let [frame, restTimer, isDrawn] = [0, 0, false];

    const button = (words, act, label = words) => {
        const one = make("button", { type: "button", "class": "reset", "aria-label": label, title: label }, words);
        one.addEventListener("click", act);
        return one;
    };
    const canvas = make("canvas", { role: "img", "aria-label": "the picture with your lines", width: LARGE, height: LARGE * 9 / 16 });
    const status = make("p", { role: "status", id: "line-status" });
    const undo = button("↶", () => show(-1), "Undo");
    const redo = button("↷", () => show(1), "Redo");
    const reset = button("Reset", () => { setText(hand, hand.dataset.book); hand.focus(); draw(LARGE); });
    const resetAll = button("Reset all", () => {
        for (const line of findEdited()) setText(line, line.dataset.book);
        hand.focus();
        draw(LARGE);
    });
    const diff = button("Copy as a diff", () => copy(makeDiff(hand), "The line is copied as a diff. In your folder: git apply, and paste."));
    const copies = make("details", { "class": "copies" }, make("summary", {}, "Copy …"), make("div", {},
        button("Copy line", () => copy(readText(hand), "The line is copied, as you wrote it.")),
        button("Copy link", () => { record(); copy(location.href, "The link to this page with your lines is copied."); }), diff));
    const panel = make("div", { "class": "panel" }, canvas, make("div", {}, status,
        make("div", {}, undo, redo, reset, resetAll, button("✕", () => { const line = hand; release(); line.focus(); }, "Close"), copies)));

    async function copy(text, words) {
        const isCopied = await copyText(text);
        copies.open = false;
        tell(isCopied ? words : "This browser doesn't let a page copy here.");
    }

    // So many letters of an element, from one on.
    function makeRange(element, from, length) {
        const range = document.createRange();
        const texts = document.createTreeWalker(element, NodeFilter.SHOW_TEXT);
        range.selectNodeContents(element);
        let at = 0, text;
        while ((text = texts.nextNode())) {
            const end = at + text.length;
            if (at <= from && from < end) range.setStart(text, from - at);
            if (at < from + length && from + length <= end) range.setEnd(text, from + length - at);
            at = end;
        }
        return range;
    }

    // Makes the places of a listing buttons.
    function makeEditable(listing) {
        const code = listing.querySelector("code");
        for (const place of listing.dataset.places.split(" ")) {
            const [name, from, length] = place.split(":");
            const range = makeRange(code, Number(from), Number(length));
            const line = make("span", { "class": "line", "data-line": name });
            line.append(range.extractContents());
            range.insertNode(line);
            makeButton(line);
        }
        code.addEventListener("click", event => {
            const line = event.target.closest("[data-line]");
            if (line && line !== hand) take(line, findCaret(line, event));
        });
        code.addEventListener("keydown", event => {
            const line = event.target.closest("[data-line]");
            if (!line) return;
            const isZ = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "z";
            if (isZ || (line !== hand ? [" ", "Enter"] : ["Enter"]).includes(event.key)) event.preventDefault();
            if (isZ) {
                show(event.shiftKey ? 1 : -1);
            } else if (line !== hand) {
                if (event.key === "Enter" || event.key === " ") take(line, line.textContent.length);
            } else if (event.key === "Enter") {
                draw(LARGE);
            } else if (event.key === "Escape") {
                record();
                setText(line, line.dataset.book);
                release();
                line.focus();
            }
        });
        code.addEventListener("input", drawSoon);
    }

    function makeButton(line) {
        for (const name of ["contenteditable", "aria-describedby", "aria-invalid"]) line.removeAttribute(name);
        const words = line.textContent.replace(/\s+/g, " ");
        for (const [name, value] of Object.entries({ role: "button", tabindex: 0, "aria-label": `Edit ${words}` })) line.setAttribute(name, value);
    }

    // The text of a line; editors write blanks of their own.
    const readText = line => line.textContent.replace(/\u00a0/g, " ");
    const isBook = line => !books.has(line) || readText(line) === line.dataset.book;
    const findEdited = () => [...books.keys()].filter(line => !isBook(line));

    // Writes into a line; the book's text may come back with its colours.
    function setText(line, text) {
        if (!books.has(line)) {
            books.set(line, line.innerHTML);
            line.dataset.book = line.textContent;
        }
        line.textContent = text;
        if (line === hand) return;
        if (isBook(line)) {
            line.innerHTML = books.get(line);
            books.delete(line);
            line.removeAttribute("data-book");
        }
        makeButton(line);
    }

    // How many letters of a line are before a press; all, if it is none.
    function findCaret(line, { clientX = -1, clientY = -1 }) {
        const caret = document.caretPositionFromPoint?.(clientX, clientY) ?? document.caretRangeFromPoint?.(clientX, clientY);
        const [node, offset] = [caret?.offsetNode ?? caret?.startContainer ?? null, caret?.offset ?? caret?.startOffset];
        if (!line.contains(node)) return line.textContent.length;
        const before = document.createRange();
        before.setStart(line, 0);
        before.setEnd(node, offset);
        return before.toString().length;
    }

    // Takes a line in hand, with the caret behind so many letters, if one is to write.
    function take(line, caret) {
        release();
        hand = line;
        setText(line, readText(line));
        const states = {
            role: "textbox", "aria-label": "Your line", "aria-describedby": status.id, contenteditable: "plaintext-only",
            spellcheck: false, autocapitalize: "off", autocorrect: "off",
        };
        for (const [name, value] of Object.entries(states)) line.setAttribute(name, value);
        if (line.contentEditable !== "plaintext-only") line.contentEditable = "true";
        line.closest("figure").append(panel);
        line.closest("pre").scrollLeft = 0;
        isDrawn = copies.open = false;
        tell("One moment …");
        if (caret !== undefined) {
            line.focus({ preventScroll: true });
            getSelection().collapse(line.firstChild, caret);
        }
        draw(LARGE);
    }

    // Lets the line in hand go: what is written in it stays, and the panel goes.
    function release() {
        if (!hand) return;
        const line = hand;
        clearTimers();
        record();
        underline();
        hand = null;
        setText(line, readText(line));
        panel.remove();
        const code = line.closest("code");
        if (!code.matches(".hljs")) colour(code);
    }

    // Notes what is written, for undo and in the address.
    function record() {
        const edits = Object.fromEntries(findEdited().map(line => [line.dataset.line, readText(line)]).sort());
        if (JSON.stringify(edits) !== JSON.stringify(states[current])) states.splice(current += 1, Infinity, edits);
        [undo.disabled, redo.disabled] = [current === 0, current === states.length - 1];
        writeAddress(edits);
    }

    // Shows what was written one edit later or earlier, and takes the line in hand that differs.
    function show(later) {
        record();
        const [before, after] = [states[current], states[current + later]];
        if (!after) return;
        current += later;
        clearTimers();
        const differ = Object.keys({ ...before, ...after }).filter(name => before[name] !== after[name]).map(find);
        for (const line of differ) setText(line, after[line.dataset.line] ?? line.dataset.book);
        take(differ[0], differ[0].textContent.length);
    }

    function clearTimers() {
        cancelAnimationFrame(frame);
        clearTimeout(restTimer);
    }

    function drawSoon() {
        clearTimers();
        underline();
        frame = requestAnimationFrame(() => draw(SMALL));
        restTimer = setTimeout(draw, REST, LARGE);
    }

    // Draws what is written. What there is to say, is said at rest.
    async function draw(columns) {
        const line = hand;
        const others = findEdited().filter(other => other !== line);
        const words = one => `${one.dataset.line} ${readText(one)}`;
        let answer, picture;
        try {
            const module = await wasmModules.get("expressions");
            if (line !== hand) return;
            answer = picture = ask(module, `edit ${columns} ${[line, ...others].map(words).join("\x1f")}`);
            // Before anything can be drawn with the line, there is the book's picture.
            if (answer.mistake && !isDrawn) picture = ask(module, `edit ${columns} ${line.dataset.line} ${line.dataset.book}`);
        } catch {
            // A module that failed once would fail again.
            wasmModules.drop("expressions");
            tell("This page can't draw that, or a part of it did not load. Press Enter to try again.");
            return;
        }
        reset.disabled = diff.disabled = isBook(line);
        resetAll.hidden = !others.length;
        panel.classList.toggle("old", Boolean(answer.mistake));
        if (picture.size) {
            const [width, height] = picture.size;
            if (canvas.width !== width) Object.assign(canvas, { width, height });
            paint(canvas, picture);
            isDrawn = true;
        }
        if (columns !== LARGE) return;
        record();
        const wrong = answer.line && find(answer.line);
        line.setAttribute("aria-invalid", wrong === line);
        underline(wrong, answer.from, answer.to);
        if (wrong) {
            tell(wrong === line ? answer.mistake : `In another line of yours: ${answer.mistake}`);
        } else if (isBook(line)) {
            tell(`This is the book’s line. Change it: there are numbers, operators, methods such as .sin(), if, let, and these names:\n${answer.names.join(", ")}`);
        } else {
            tell(answer.known || "Drawn with what you wrote. The address of the page holds it, too.");
        }
        keepInView();
    }

    // Says a sentence; a list behind it is folded where there is little room.
    function tell(text) {
        const [sentence, list] = text.split("\n");
        if (status.dataset.text === text) return; // A list stays open.
        status.dataset.text = text;
        status.replaceChildren(sentence);
        if (!list) return;
        const names = make("details", {}, make("summary", {}, "All names"), make("code", { tabindex: 0 }, list));
        names.open = !matchMedia("(max-width: 600px), (max-height: 560px)").matches;
        status.append(" ", names);
    }

    // The line stays in view beside the panel.
    function keepInView(event) {
        if (!hand) return;
        document.documentElement.style.scrollPaddingBottom = `${panel.offsetHeight + 16}px`;
        if (event || hand === document.activeElement) hand.scrollIntoView({ block: "nearest" });
    }

    // Underlines a part of a line, or nothing.
    function underline(line, from, to) {
        document.querySelectorAll(".wrong").forEach(one => one.remove());
        if (!line) return;
        const [pre, text] = [line.closest("pre"), readText(line)];
        const range = makeRange(line, from === text.length ? from - 1 : from, Math.max(1, to - from));
        const frame = pre.getBoundingClientRect();
        for (const box of text ? range.getClientRects() : line.getClientRects()) {
            const mark = make("span", { "class": "wrong", "aria-hidden": "true" });
            Object.assign(mark.style, {
                left: `${box.left - frame.left + pre.scrollLeft}px`, top: `${box.top - frame.top}px`,
                width: `${Math.max(8, box.width)}px`, height: `${box.height + 3}px`,
            });
            pre.append(mark);
        }
    }

    // The address holds the edits; a mail program may stop before a parenthesis at its end.
    function writeAddress(edits) {
        const encode = text => encodeURIComponent(text).replace(/[!'()*]/g, sign => `%${sign.charCodeAt(0).toString(16).toUpperCase()}`);
        const hash = Object.entries(edits).map(([name, text]) => `line=${name}:${encode(text)}`).join("&");
        if (!hash && !location.hash.startsWith("#line=")) return;
        history.replaceState(null, "", hash ? `#${hash}` : location.pathname + location.search);
    }

    // Opens the edits that are in the address, and takes the first in hand.
    function openAddress() {
        if (!location.hash.startsWith("#line=")) return;
        const matches = location.hash.slice(6).split("&line=").map(edit => edit.match(EDIT));
        const edits = matches.filter(match => match && find(match[1]));
        for (const [, name, text] of edits) {
            let written = text;
            try { written = decodeURIComponent(text); } catch { /* as it is */ }
            setText(find(name), written.replace(/\u00a0/g, " "));
        }
        if (!edits.length) return;
        const line = find(edits[0][1]);
        for (let box = line.closest("details"); box; box = box.parentElement.closest("details")) box.open = true;
        line.closest("main > *").style.contentVisibility = "visible";
        take(line);
        requestAnimationFrame(() => line.scrollIntoView({ block: "center" }));
    }

    // A line for the reader's own file, as `git apply` takes it.
    function makeDiff(line) {
        const listing = line.closest("figure");
        const code = listing.querySelector("code").cloneNode(true);
        for (const other of code.querySelectorAll("[data-book]")) {
            if (other.dataset.line !== line.dataset.line) other.textContent = other.dataset.book;
        }
        const before = document.createRange();
        before.setStart(code, 0);
        before.setEndBefore(code.querySelector(`[data-line="${line.dataset.line}"]`));
        const start = before.toString();
        const all = code.textContent.replace(/\n$/, "");
        const [book, now] = [start + line.dataset.book + all.slice(start.length + line.textContent.length), all].map(text => text.split("\n"));
        const first = start.split("\n").length - 1;
        const [gone, come] = [line.dataset.book, line.textContent].map(text => text.split("\n").length);
        const [above, below] = [book.slice(Math.max(0, first - 3), first), book.slice(first + gone, first + gone + 3)];
        const from = Number(listing.dataset.lines.split("-")[0]) + first - above.length;
        const [old, count] = [gone, come].map(rows => rows + above.length + below.length);
        const rows = (sign, list) => list.map(row => `${sign}${row.replace(/\u00a0/g, " ")}\n`).join("");
        const { path } = listing.dataset;
        return `--- a/${path}\n+++ b/${path}\n@@ -${from},${old} +${from},${count} @@\n`
            + rows(" ", above) + rows("-", book.slice(first, first + gone)) + rows("+", now.slice(first, first + come)) + rows(" ", below);
    }

    // What is as the book has it is closed by a click elsewhere, or when the keyboard leaves it: not
    // by a press, whose target would move away.
    for (const kind of ["click", "focusin"]) {
        addEventListener(kind, event => {
            const isOutside = hand && !event.composedPath().includes(hand.closest("figure"));
            if (isOutside && isBook(hand) && (kind === "click" || event.target.matches?.(":focus-visible"))) release();
        });
    }
    panel.addEventListener("toggle", keepInView, true);
    addEventListener("resize", () => { if (hand) draw(LARGE); });
    addEventListener("beforeprint", () => {
        release();
        [...books.keys()].forEach(line => setText(line, line.dataset.book));
    });
    addEventListener("afterprint", () => Object.entries(states[current]).forEach(([name, text]) => setText(find(name), text)));
    addEventListener("hashchange", openAddress);
    // A keyboard on the screen covers the end of the page: the panel stays above it.
    window.visualViewport?.addEventListener("resize", () => {
        const { height, offsetTop } = visualViewport;
        panel.style.bottom = `${Math.max(0, innerHeight - height - offsetTop)}px`;
    });

    document.querySelectorAll("[data-places]").forEach(makeEditable);
    openAddress();
}
