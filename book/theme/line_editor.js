"use strict";

// Lines of the listings that the reader edits. A press on one makes it a text to write in, and a
// panel below the listing shows what it draws: the module `expressions` is the five steps, with
// what is written in that place. One line at a time is the reader's.
{
    const SMALL = 320, LARGE = 640; // Columns while one types, and at rest.
    const REST = 300; // Milliseconds after the last key.
    const HASH = /^#line=(\w+)(?::|%3A)(.*)$/i;

    // The edit in progress: the line and its listing, what the book has there, as HTML, and whether
    // the canvas shows a picture of its step.
    let edit = null;
    let [frame, rest] = [0, 0];

    const canvas = make("canvas", { role: "img", "aria-label": "the picture with your line", width: LARGE, height: LARGE * 9 / 16 });
    const status = make("p", { role: "status", id: "line-status" });
    const [reset, diff] = ["Reset", "Copy as a diff"].map(words => make("button", { type: "button", "class": "reset" }, words));
    const panel = make("div", { "class": "panel" }, canvas, make("div", {}, status, make("div", {}, reset, diff)));

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
            if (line && line !== edit?.line) startEdit(line, line.textContent, findCaret(line, event));
        });
        code.addEventListener("keydown", event => {
            const line = event.target.closest("[data-line]");
            if (!line) return;
            if (line !== edit?.line) {
                if (event.key !== "Enter" && event.key !== " ") return;
                event.preventDefault();
                startEdit(line, line.textContent, line.textContent.length);
            } else if (event.key === "Enter") {
                event.preventDefault();
                draw(LARGE);
            } else if (event.key === "Escape") {
                endEdit();
                line.focus();
            }
        });
        code.addEventListener("input", drawSoon);
    }

    function makeButton(line) {
        for (const name of ["contenteditable", "aria-describedby", "aria-invalid", "data-book"]) line.removeAttribute(name);
        const words = line.textContent.replace(/\s+/g, " ");
        for (const [name, value] of Object.entries({ role: "button", tabindex: 0, "aria-label": `Edit ${words}` })) line.setAttribute(name, value);
    }

    // The text of the line; editors write blanks of their own.
    const readText = line => line.textContent.replace(/\u00a0/g, " ");
    const isBook = () => readText(edit.line) === edit.line.dataset.book;

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

    // Edits a line, from this text on, with the caret behind so many letters, if one is to write.
    function startEdit(line, text, caret) {
        endEdit();
        const listing = line.closest("figure");
        edit = { line, listing, html: line.innerHTML, isDrawn: false };
        line.dataset.book = line.textContent;
        line.textContent = text;
        const states = {
            role: "textbox", "aria-label": "Your line", "aria-describedby": status.id, contenteditable: "plaintext-only",
            spellcheck: false, autocapitalize: "off", autocorrect: "off",
        };
        for (const [name, value] of Object.entries(states)) line.setAttribute(name, value);
        if (line.contentEditable !== "plaintext-only") line.contentEditable = "true";
        listing.append(panel);
        listing.querySelector("pre").scrollLeft = 0;
        status.textContent = "One moment …";
        if (caret !== undefined) {
            line.focus({ preventScroll: true });
            getSelection().collapse(line.firstChild, caret);
        }
        draw(LARGE);
    }

    // Brings the book's line back, and takes the panel away.
    function endEdit() {
        if (!edit) return;
        const { line, listing, html } = edit;
        clearTimers();
        underline();
        line.innerHTML = html;
        edit = null;
        makeButton(line);
        panel.remove();
        writeAddress();
        const code = listing.querySelector("code");
        if (!code.matches(".hljs")) colour(code);
    }

    function clearTimers() {
        cancelAnimationFrame(frame);
        clearTimeout(rest);
    }

    function drawSoon() {
        clearTimers();
        underline();
        frame = requestAnimationFrame(() => draw(SMALL));
        rest = setTimeout(draw, REST, LARGE);
    }

    // Draws what is written. What there is to say, is said at rest.
    async function draw(columns) {
        let module;
        try {
            module = await wasmModules.get("expressions");
        } catch {
            status.textContent = "This page can't draw: a part of it did not load. Press Enter to try again.";
            return;
        }
        if (!edit) return;
        const { line } = edit;
        const name = line.dataset.line;
        const request = text => ask(module, `edit ${name} ${columns} ${text}`);
        const answer = request(readText(line));
        reset.disabled = diff.disabled = isBook();
        panel.classList.toggle("old", Boolean(answer.mistake));
        // Before anything can be drawn with the line, there is the book's picture.
        const picture = answer.size || edit.isDrawn ? answer : request(line.dataset.book);
        if (picture.size) {
            const [width, height] = picture.size;
            if (canvas.width !== width) Object.assign(canvas, { width, height });
            canvas.getContext("2d").putImageData(new ImageData(picture.pixels, width, height), 0, 0);
            edit.isDrawn = true;
        }
        if (columns !== LARGE) return;
        line.setAttribute("aria-invalid", Boolean(answer.mistake));
        if (answer.mistake) {
            write(status, answer.mistake);
            underline(answer.from, answer.to);
        } else if (isBook()) {
            const { variables } = ask(module, `variables ${name}`);
            status.replaceChildren("This is the book's line. Change it: you can use ");
            variables.forEach((one, k) => status.append(k ? ", " : "", make("code", {}, one)));
            status.append(", numbers, operators, and methods such as ", make("code", {}, ".sin()"), ".");
        } else {
            write(status, answer.known || "Drawn with your line. The address of the page holds it, too.");
        }
        if (!answer.mistake) writeAddress();
        keepInView();
    }

    // The line stays in view above the panel.
    function keepInView() {
        document.documentElement.style.scrollPaddingBottom = `${panel.offsetHeight + 16}px`;
        if (edit.line === document.activeElement) edit.line.scrollIntoView({ block: "nearest" });
    }

    // Underlines a part of the line, or nothing.
    function underline(from, to) {
        document.querySelectorAll(".wrong").forEach(one => one.remove());
        if (from === undefined) return;
        const [pre, text] = [edit.listing.querySelector("pre"), readText(edit.line)];
        const range = makeRange(edit.line, from === text.length ? from - 1 : from, Math.max(1, to - from));
        const frame = pre.getBoundingClientRect();
        for (const box of text ? range.getClientRects() : edit.line.getClientRects()) {
            const mark = make("span", { "class": "wrong", "aria-hidden": "true" });
            Object.assign(mark.style, {
                left: `${box.left - frame.left + pre.scrollLeft}px`, top: `${box.top - frame.top}px`,
                width: `${Math.max(8, box.width)}px`, height: `${box.height + 3}px`,
            });
            pre.append(mark);
        }
    }

    // The address holds the edit; a mail program may stop before a parenthesis at its end.
    function writeAddress() {
        const encode = text => encodeURIComponent(text).replace(/[!'()*]/g, sign => `%${sign.charCodeAt(0).toString(16).toUpperCase()}`);
        const isEdit = edit && !isBook();
        if (!isEdit && !HASH.test(location.hash)) return;
        const hash = isEdit ? `#line=${edit.line.dataset.line}:${encode(readText(edit.line))}` : "";
        history.replaceState(null, "", hash || location.pathname + location.search);
    }

    // Opens the edit that is in the address.
    function openAddress() {
        const [, name, text] = location.hash.match(HASH) ?? [];
        const line = name && document.querySelector(`[data-line="${name}"]`);
        if (!line) return;
        for (let box = line.closest("details"); box; box = box.parentElement.closest("details")) box.open = true;
        line.closest("main > *").style.contentVisibility = "visible";
        let written = text;
        try { written = decodeURIComponent(text); } catch { /* as it is */ }
        startEdit(line, written);
        requestAnimationFrame(() => line.scrollIntoView({ block: "center" }));
    }

    // The edit for the reader's own file, as `git apply` takes it.
    function makeDiff({ line, listing }) {
        const code = listing.querySelector("code");
        const before = document.createRange();
        before.setStart(code, 0);
        before.setEndBefore(line);
        const start = before.toString();
        const all = code.textContent.replace(/\n$/, "");
        const [book, now] = [start + line.dataset.book + all.slice(start.length + line.textContent.length), all].map(text => text.split("\n"));
        const first = start.split("\n").length - 1;
        const [gone, come] = [line.dataset.book, line.textContent].map(text => text.split("\n").length);
        const [above, below] = [book.slice(Math.max(0, first - 3), first), book.slice(first + gone, first + gone + 3)];
        const from = Number(listing.dataset.lines.split("-")[0]) + first - above.length;
        const [old, count] = [gone, come].map(rows => rows + above.length + below.length);
        const rows = (sign, list) => list.map(row => `${sign}${row}\n`).join("");
        const { path } = listing.dataset;
        return `--- a/${path}\n+++ b/${path}\n@@ -${from},${old} +${from},${count} @@\n`
            + rows(" ", above) + rows("-", book.slice(first, first + gone)) + rows("+", now.slice(first, first + come)) + rows(" ", below);
    }

    reset.addEventListener("click", () => {
        edit.line.textContent = edit.line.dataset.book;
        underline();
        edit.line.focus();
        draw(LARGE);
    });
    diff.addEventListener("click", async () => {
        const copied = await navigator.clipboard.writeText(makeDiff(edit)).then(() => true, () => false);
        write(status, copied ? "Copied. In your folder: git apply, and paste." : "This browser doesn't let a page copy here.");
    });
    // What is as the book has it is closed by a click elsewhere, or when the keyboard leaves it: not
    // by a press, whose target would move away.
    for (const kind of ["click", "focusin"]) {
        addEventListener(kind, event => {
            const isOutside = edit && !event.composedPath().includes(edit.listing);
            if (isOutside && isBook() && (kind === "click" || event.target.matches?.(":focus-visible"))) endEdit();
        });
    }
    addEventListener("resize", () => { if (edit) draw(LARGE); });
    addEventListener("beforeprint", endEdit);
    addEventListener("hashchange", openAddress);
    // A keyboard on the screen covers the end of the page: the panel stays above it.
    window.visualViewport?.addEventListener("resize", () => {
        const { height, offsetTop } = visualViewport;
        panel.style.bottom = `${Math.max(0, innerHeight - height - offsetTop)}px`;
    });

    document.querySelectorAll("[data-places]").forEach(makeEditable);
    openAddress();
}
