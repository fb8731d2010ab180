"use strict";

// Lines of the listings that the reader edits. A press on one, or a key, takes it in hand, and a
// panel below the listing shows what it draws: the module `expressions` is the five steps, with
// what is written in those places. One line at a time is in hand; what others have stays.
{
    const SMALL = 320, LARGE = 640; // Columns while one types, and at rest.
    const REST = 300; // Milliseconds after the last key.

    // Colours make other elements of the lines, unless they are edited.
    const find = name => document.querySelector(`[data-line="${name}"]`);
    let hand = null;
    // All that was written, as the texts of the edited lines by name, and which of these the page has.
    let [states, current] = [[{}], 0];
    let restTimer = 0;
    // What is wrong with the link that led here.
    let linkFault = "";

    const button = (words, act, label = words) => {
        const one = make("button", { type: "button", "class": "reset", "aria-label": label, title: label }, words);
        one.addEventListener("click", act);
        return one;
    };
    const canvas = make("canvas", { role: "img", "aria-label": "the picture with your lines", width: LARGE, height: LARGE * 9 / 16 });
    const status = make("p", { role: "status" });
    const undo = button("↶", () => show(-1), "Undo");
    const redo = button("↷", () => show(1), "Redo");
    const reset = button("Reset", () => { setText(hand, hand.dataset.book); hand.focus(); draw(LARGE); });
    const copyLine = button("Copy line", () => copyBy(copyLine, readText(hand), "Line copied"));
    const copyLink = button("Copy link", () => { record(); copyBy(copyLink, location.href, "Link copied"); });
    const close = button("✕", () => { const line = hand; release(); line.focus(); }, "Close");
    const panel = make("div", { "class": "panel" }, canvas, make("div", {}, status,
        make("div", {}, undo, redo, reset, close, copyLine, copyLink)));

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

    // Makes the places of a listing texts to write in.
    function makeEditable(listing) {
        const code = listing.querySelector("code");
        for (const place of listing.dataset.places.split(" ")) {
            const [name, from, length] = place.split(":");
            const range = makeRange(code, Number(from), Number(length));
            const line = make("span", {
                "class": "line", "data-line": name, role: "textbox", "aria-label": "A line to edit",
                contenteditable: "plaintext-only", spellcheck: false, autocapitalize: "off", autocorrect: "off",
            });
            line.append(range.extractContents());
            range.insertNode(line);
        }
        for (const kind of ["click", "beforeinput"]) {
            code.addEventListener(kind, event => {
                const line = event.target.closest("[data-line]");
                if (line && line !== hand) take(line);
            });
        }
        code.addEventListener("keydown", event => {
            const line = event.target.closest("[data-line]");
            if (!line) return;
            if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "z") {
                show(event.shiftKey ? 1 : -1);
            } else if (event.key === "Enter") {
                if (line === hand) draw(LARGE);
                else take(line);
            } else if (line === hand && event.key === "Escape") {
                record();
                setText(line, line.dataset.book);
                close.click();
            } else {
                return;
            }
            event.preventDefault();
        });
        code.addEventListener("input", drawSoon);
    }

    // The text of a line; editors write blanks of their own.
    const readText = line => line.textContent.replace(/\u00a0/g, " ");
    const isBook = line => readText(line) === line.dataset.book;
    // One that is edited, or in hand, has the book's text besides.
    const findEdited = () => [...document.querySelectorAll("[data-book]")].filter(line => !isBook(line));

    // Keeps the book's text of a line, and its colours.
    function keepBook(line) {
        line.dataset.book ??= line.textContent;
        line.bookHTML ??= line.innerHTML;
    }

    function setText(line, text) {
        keepBook(line);
        line.textContent = text;
        if (!isBook(line)) return;
        writeHTML(() => { line.innerHTML = line.bookHTML; });
        if (line !== hand) delete line.dataset.book;
    }

    function take(line) {
        release();
        hand = line;
        keepBook(line);
        line.ariaCurrent = true;
        line.closest("figure").append(panel);
        line.closest("pre").scrollLeft = 0;
        tell("One moment …");
        draw(LARGE);
    }

    // Lets the line in hand go: what is written in it stays, and the panel goes.
    function release() {
        if (!hand) return;
        const line = hand;
        clearLine();
        record();
        hand = line.ariaCurrent = null;
        setText(line, readText(line));
        panel.remove();
        document.documentElement.style.scrollPaddingBottom = "";
        const code = line.closest("code");
        if (!code.matches(".hljs")) colour(code);
    }

    // Notes what is written, for undo and in the address.
    function record() {
        const edits = Object.fromEntries(findEdited().map(line => [line.dataset.line, readText(line)]).sort());
        if (JSON.stringify(edits) !== JSON.stringify(states[current])) states.splice(current += 1, Infinity, edits);
        [undo.disabled, redo.disabled] = [current === 0, current === states.length - 1];
        const hash = new URLSearchParams(Object.entries(edits).map(([name, text]) => ["line", `${name}:${text}`]));
        if (!hash.size && !location.hash.startsWith("#line=")) return;
        history.replaceState(null, "", hash.size ? `#${hash}` : location.pathname + location.search);
    }

    // Shows what was written one edit later or earlier, and takes the line in hand that differs.
    function show(later) {
        record();
        const [before, after] = [states[current], states[current + later]];
        if (!after) return;
        current += later;
        const differ = Object.keys({ ...before, ...after }).filter(name => before[name] !== after[name]).map(find);
        for (const line of differ) setText(line, after[line.dataset.line] ?? line.dataset.book);
        take(differ[0]);
        differ[0].focus({ preventScroll: true });
        getSelection().selectAllChildren(differ[0]);
        getSelection().collapseToEnd();
    }

    // Drops what was to be drawn later, and what was told of the line.
    function clearLine() {
        clearTimeout(restTimer);
        mark();
    }

    function drawSoon() {
        linkFault = "";
        clearLine();
        draw(SMALL);
        restTimer = setTimeout(draw, REST, LARGE);
    }

    // Letters that nobody sees, and that no Rust has.
    const hasControl = text => /[^\P{Cc}\n\t]/u.test(text);

    // Draws what is written. What there is to say, is said at rest.
    async function draw(columns) {
        const line = hand;
        if (hasControl(readText(line))) {
            panel.classList.add("old");
            return tell("A control character is in this line, which nobody sees. Reset brings back the book’s.");
        }
        const others = findEdited().filter(other => other !== line && !hasControl(readText(other)));
        const words = one => `${one.dataset.line} ${readText(one)}`;
        let answer;
        try {
            const module = await wasmModules.get("expressions");
            if (line !== hand) return;
            answer = ask(module, `edit ${columns} ${[line, ...others].map(words).join("\x1f")}`);
        } catch ({ message }) {
            panel.classList.add("old");
            tell(`This page can't draw that. Press Enter to try again. (${message})`);
            wasmModules.drop("expressions");
            return;
        }
        reset.disabled = isBook(line);
        panel.classList.toggle("old", Boolean(answer.mistake));
        if (answer.size) paint(canvas, answer);
        if (columns !== LARGE) return;
        record();
        const wrong = answer.line && find(answer.line);
        mark(wrong, answer.from, answer.to);
        if (wrong) {
            tell(wrong === line ? answer.mistake : `In another line of yours: ${answer.mistake}`);
        } else if (isBook(line)) {
            tell(linkFault || `This is the book’s line. Change it: there are numbers, operators, methods such as .sin(), if, let, and these names:\n${answer.names.join(", ")}`);
        } else {
            tell(answer.known || "Drawn with what you wrote. The address of the page holds it now.");
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

    // Marks a part of a line as wrong, or nothing.
    function mark(line, from, to) {
        hand.ariaInvalid = line === hand;
        window.CSS.highlights?.delete("wrong");
        if (line) window.CSS.highlights?.set("wrong", new Highlight(makeRange(line, from, Math.max(1, to - from))));
    }

    // Opens the edits that are in the address, and takes the first in hand.
    function openAddress() {
        const words = new URLSearchParams(location.hash.slice(1)).getAll("line");
        const places = document.querySelectorAll("[data-line]").length;
        const isTooLong = words.length > places;
        const edits = words.slice(0, places).map(text => text.match(/^(\w+):(.*)$/s)).filter(match => match && find(match[1]));
        if (!edits.length) return;
        linkFault = edits.some(([, , text]) => hasControl(text)) ? "The link has a control character in it, so nothing of it was taken."
            : isTooLong ? `The link has ${words.length} edits, and this page ${places} places, so nothing of it was taken.` : "";
        if (!linkFault) for (const [, name, text] of edits) setText(find(name), text.replace(/\u00a0/g, " "));
        const line = find(edits[0][1]);
        for (let box = line.closest("details"); box; box = box.parentElement.closest("details")) box.open = true;
        line.closest("main > *").style.contentVisibility = "visible";
        take(line);
        requestAnimationFrame(() => line.scrollIntoView({ block: "center" }));
    }

    // What is as the book has it is closed by a click elsewhere. Undo takes another line only after this.
    addEventListener("click", event => {
        if (hand && isBook(hand) && !event.composedPath().includes(hand.closest("figure"))) release();
    }, { capture: true });
    panel.addEventListener("toggle", keepInView, true);
    addEventListener("hashchange", openAddress);
    // A keyboard on the screen covers the end of the page: the panel stays above it.
    window.visualViewport?.addEventListener("resize", () => {
        const { height, offsetTop } = visualViewport;
        panel.style.bottom = `${Math.max(0, innerHeight - height - offsetTop)}px`;
    });

    document.querySelectorAll("[data-places]").forEach(makeEditable);
    openAddress();
}
