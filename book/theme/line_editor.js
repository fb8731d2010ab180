"use strict";

// The lines in listings that the reader can edit. A click on a line selects the line, and so does
// typing in the line. A panel below or beside the listing then shows the picture that the step
// draws with the edited lines. The module `expressions`, which contains the five steps, draws this
// picture with the reader's text instead of the book's. Only one line at a time is selected, but
// all edited lines keep their text.
{
    const SMALL = 320, LARGE = 640; // The columns of a picture while the reader types, and at rest.
    const REST_DELAY = 300; // Rest begins this many milliseconds after the last key press.

    // Finds a line by its name. Call this function instead of storing the element, because
    // colouring a listing replaces the elements of its lines.
    /** @type {(name: string) => EditedLine} */
    const findLine = name => document.querySelector(`[data-line="${name}"]`);
    /** @type {EditedLine | null} */
    let selected = null;
    // The states for Undo and Redo. A state consists of the texts of the edited lines, keyed by the
    // lines' names.
    /** @type {UndoHistory<Record<string, string>>} */
    const states = new book.History({});
    let restTimer = 0;
    // What is wrong with the link that the reader followed, if anything.
    let linkFault = "";
    // A sentence that says what the last Undo or Redo did. It is cleared when the reader types.
    let undoMessage = "";

    /** @type {(words: string, act: () => void, label?: string) => HTMLButtonElement} */
    const button = (words, act, label = words) => {
        const element = book.make("button", { type: "button", "class": "reset", "aria-label": label, title: label }, words);
        element.addEventListener("click", act);
        return element;
    };
    const canvas = book.make("canvas", { role: "img", "aria-label": "the picture with your lines", width: LARGE, height: LARGE * 9 / 16 });
    const status = book.make("p", { role: "status" });
    const undo = button("↶", () => show(-1), "Undo");
    const redo = button("↷", () => show(1), "Redo");
    const reset = button("Reset", () => { undoMessage = ""; setText(selected, selected.dataset.book); selected.focus(); draw(LARGE); });
    const copyLine = button("Copy line", () => book.copyAndReport(copyLine, readText(selected), "Line copied"));
    const copyLink = button("Copy link", () => { record(); book.copyAndReport(copyLink, location.href, "Link copied"); });
    const close = button("✕", () => { const line = selected; deselect(); line.focus(); }, "Close");
    const panel = book.make("div", { "class": "panel" }, canvas, book.make("div", {}, status,
        book.make("div", {}, undo, redo, reset, close, copyLine, copyLink)));
    const tool = book.make("div", { "class": "tool" }, panel);

    /** @type {(event: Event) => EditedLine | null} */
    const lineOf = event => /** @type {Element} */ (event.target).closest("[data-line]");

    // A line may have several rows. Puts the indent of each row after the first into an element of
    // its own, so that the indent isn't underlined.
    /** @param {Element} line */
    function separateIndents(line) {
        for (const { 0: spaces, index } of line.textContent.matchAll(/(?<=\n) +/g)) {
            book.makeRange(line, index, spaces.length).surroundContents(book.make("span", { "class": "indent" }));
        }
    }

    // Makes the places of a listing editable.
    /** @param {HTMLElement} listing */
    function makeEditable(listing) {
        const code = listing.querySelector("code");
        for (const place of listing.dataset.places.split(" ")) {
            const [name, from, length] = place.split(":");
            const range = book.makeRange(code, Number(from), Number(length));
            const line = book.make("span", {
                "class": "line", "data-line": name, role: "textbox", "aria-label": `The value of ${name}`,
                contenteditable: "plaintext-only", spellcheck: false, autocapitalize: "off", autocorrect: "off",
            });
            line.append(range.extractContents());
            range.insertNode(line);
            separateIndents(line);
        }
        for (const kind of ["click", "beforeinput"]) {
            code.addEventListener(kind, event => {
                const line = lineOf(event);
                if (line && line !== selected) select(line);
            });
        }
        code.addEventListener("keydown", event => {
            const line = lineOf(event);
            if (!line) return;
            const edits = book.readUndoKey(event);
            if (edits) {
                show(edits);
            } else if (event.key === "Enter") {
                if (line === selected) draw(LARGE);
                else select(line);
            } else if (line === selected && event.key === "Escape") {
                close.click();
            } else {
                return;
            }
            event.preventDefault();
        });
        code.addEventListener("input", drawSoon);
    }

    // Returns the text of a line, with ordinary spaces in place of no-break spaces. Browsers insert
    // a no-break space for some of the spaces that a reader types.
    /** @param {EditedLine} line */
    const readText = line => line.textContent.replace(/\u00a0/g, " ");
    /** @param {EditedLine} line */
    const isBook = line => readText(line) === line.dataset.book;
    // Finds the lines whose text differs from the book's. While a line is edited or selected, its
    // `data-book` contains the book's text.
    const findEdited = () => {
        /** @type {EditedLine[]} */
        const lines = [...document.querySelectorAll("[data-book]")];
        return lines.filter(line => !isBook(line));
    };

    // Stores the book's text of a line and the HTML that colours it, so that both can be restored.
    /** @param {EditedLine} line */
    function keepBook(line) {
        line.dataset.book ??= line.textContent;
        line.bookHTML ??= line.innerHTML;
    }

    /** @param {EditedLine} line @param {string} text */
    function setText(line, text) {
        keepBook(line);
        line.textContent = text;
        if (line !== selected) separateIndents(line);
        if (!isBook(line)) return;
        book.writeHTML(() => { line.innerHTML = line.bookHTML; });
        if (line !== selected) delete line.dataset.book;
    }

    // Calls `act`, which opens or closes the panel. Then scrolls so that `element` stays where it
    // was in the window. Otherwise the element might jump, since notes above it may move into the
    // margin or out of the margin.
    /** @param {Element} element @param {() => void} act */
    function keepPlace(element, act) {
        const { top } = element.getBoundingClientRect();
        act();
        scrollBy({ top: element.getBoundingClientRect().top - top, behavior: "instant" });
    }

    /** @param {EditedLine} line */
    function select(line) {
        keepPlace(line, () => {
            deselect();
            line.closest("figure").after(tool);
        });
        selected = line;
        undoMessage = "";
        keepBook(line);
        line.ariaCurrent = "true";
        document.querySelector(".line.first")?.classList.remove("first");
        line.closest("pre").scrollLeft = 0;
        say("One moment …");
        keepInView();
        draw(LARGE);
    }

    // Deselects the line, keeps its text, and closes the panel.
    function deselect() {
        if (!selected) return;
        const line = selected;
        clearLine();
        record();
        selected = null;
        line.ariaCurrent = null;
        setText(line, readText(line));
        tool.remove();
        document.documentElement.style.scrollPaddingBottom = "";
        const code = line.closest("code");
        if (!code.matches(".hljs")) book.colour(code);
    }

    // Records the edited lines in the history for Undo, and in the address.
    function record() {
        const edits = Object.fromEntries(findEdited().map(line => [line.dataset.line, readText(line)]).sort());
        states.record(edits);
        [undo.disabled, redo.disabled] = [!states.has(-1), !states.has(1)];
        const hash = new URLSearchParams(Object.entries(edits).map(([name, text]) => ["line", `${name}:${text}`]));
        if (!hash.size && !location.hash.startsWith("#line=")) return;
        history.replaceState(null, "", hash.size ? `#${hash}` : location.pathname + location.search);
    }

    // Moves through the history by this many edits (backwards, if the number is negative), and
    // selects the first line that differs.
    /** @param {number} edits */
    function show(edits) {
        record();
        if (!states.has(edits)) return;
        const [before, after] = [states.go(0), states.go(edits)];
        const differ = Object.keys({ ...before, ...after }).filter(name => before[name] !== after[name]).map(findLine);
        for (const line of differ) setText(line, after[line.dataset.line] ?? line.dataset.book);
        select(differ[0]);
        const file = differ[0].closest("figure").querySelector(".path b").textContent;
        undoMessage = `${edits < 0 ? "Undone" : "Redone"} in ${file}. `;
        differ[0].focus({ preventScroll: true });
        getSelection().selectAllChildren(differ[0]);
        getSelection().collapseToEnd();
    }

    // Stops the timer that would draw the large picture. Removes the mark of an error in a line.
    function clearLine() {
        clearTimeout(restTimer);
        mark();
    }

    function drawSoon() {
        linkFault = undoMessage = "";
        clearLine();
        draw(SMALL);
        restTimer = setTimeout(draw, REST_DELAY, LARGE);
    }

    // Whether a text contains control characters other than line breaks and tabs. Such characters
    // are invisible and have no place in Rust code.
    /** @param {string} text */
    const hasControl = text => /[^\P{Cc}\n\t]/u.test(text);

    // Draws the step's picture with the edited lines. The picture is small while the reader types,
    // and large at rest. Only a call for the large picture shows the module's message and updates
    // the address.
    /** @param {number} columns */
    async function draw(columns) {
        const line = selected;
        if (hasControl(readText(line))) {
            panel.classList.add("old");
            return say("This line contains an invisible control character. Reset brings back the book’s line.");
        }
        const others = findEdited().filter(other => other !== line && !hasControl(readText(other)));
        const lines = [line, ...others].map(edited => ({ place: edited.dataset.line, text: readText(edited) }));
        /** @type {EditReply} */
        let reply;
        try {
            const module = await book.modules.get("expressions");
            if (line !== selected) return;
            reply = book.ask(module, { request: "edit", columns, lines });
        } catch (error) {
            const { message } = /** @type {Error} */ (error);
            panel.classList.add("old");
            say(`This page can't draw that. Press Enter to try again. (${message})`);
            book.modules.drop("expressions");
            return;
        }
        reset.disabled = isBook(line);
        panel.classList.toggle("old", Boolean(reply.fault));
        if (reply.size) book.paint(canvas, reply);
        if (columns !== LARGE) return;
        record();
        // If the reader has scrolled the line out of view, don't scroll back to the line.
        const { top, bottom } = line.getBoundingClientRect();
        const isInView = bottom > 0 && top < innerHeight;
        const wrong = reply.line ? findLine(reply.line) : null;
        mark(wrong, reply.from, reply.to);
        if (wrong) {
            say(undoMessage + (wrong === line ? reply.fault : `In another line of yours: ${reply.fault}`));
        } else if (isBook(line)) {
            say(undoMessage + (linkFault || `This is the book’s line. Change it: there are numbers, operators, methods such as .sin(), if, let, and these names:\n${reply.names.join(", ")}`));
        } else {
            say(undoMessage + (reply.note || "Drawn with what you wrote. The address of the page holds it now."));
        }
        if (isInView) keepInView();
    }

    // Shows a message. If the message contains a line break, the text after the line break is a
    // list of names. In a small window, the list is folded.
    /** @param {string} text */
    function say(text) {
        const [sentence, list] = text.split("\n");
        if (status.dataset.text === text) return; // If the list is open, leave it open.
        status.dataset.text = text;
        status.replaceChildren(sentence);
        if (!list) return;
        const names = book.make("details", {}, book.make("summary", {}, "All names"), book.make("code", { tabindex: 0 }, list));
        names.open = !matchMedia("(max-width: 600px), (max-height: 560px)").matches;
        status.append(" ", names);
    }

    // Scrolls so that the panel is in view, and the line if it has the focus. A panel that isn't
    // beside the listing stays at the bottom of the window, where it could cover the line. So the
    // scrolling leaves room for the panel.
    function keepInView() {
        if (!selected) return;
        const isBeside = panel.getBoundingClientRect().left >= selected.closest("pre").getBoundingClientRect().right;
        if (isBeside) panel.scrollIntoView({ block: "nearest" });
        const height = isBeside ? 0 : panel.offsetHeight + (parseFloat(panel.style.bottom) || 0);
        document.documentElement.style.scrollPaddingBottom = `${height + 16}px`;
        if (selected === document.activeElement) selected.scrollIntoView({ block: "nearest" });
    }

    // Marks a part of a line as wrong. Without a line, removes the mark.
    /** @param {EditedLine | null} [line] @param {number} [from] @param {number} [to] */
    function mark(line, from, to) {
        selected.ariaInvalid = String(line === selected);
        window.CSS.highlights?.delete("wrong");
        if (line) window.CSS.highlights?.set("wrong", new Highlight(book.makeRange(line, from, Math.max(1, to - from))));
    }

    // Applies the edits that are in the address, and selects the line of the first edit. Colours
    // the listings before applying the edits, because a listing that contains an edited line can't
    // be coloured.
    async function openAddress() {
        const words = new URLSearchParams(location.hash.slice(1)).getAll("line");
        const places = document.querySelectorAll("[data-line]").length;
        const isTooLong = words.length > places;
        const edits = words.slice(0, places).map(text => text.match(/^(\w+):(.*)$/s)).filter(match => match && findLine(match[1]));
        if (!edits.length) return;
        linkFault = edits.some(([, , text]) => hasControl(text)) ? "The link contains an invisible control character, so no line was changed."
            : isTooLong ? `The link has ${words.length} edits, but this page has only ${places} editable lines, so no line was changed.` : "";
        const isLoaded = await book.load("highlight.js");
        const codes = edits.map(([, name]) => findLine(name).closest("code"));
        for (const code of isLoaded ? codes : []) {
            if (!code.matches(".hljs") && !code.querySelector("[data-book]")) book.colourCode(code);
        }
        if (!linkFault) for (const [, name, text] of edits) setText(findLine(name), text.replace(/\u00a0/g, " "));
        const line = findLine(edits[0][1]);
        for (let box = line.closest("details"); box; box = box.parentElement.closest("details")) box.open = true;
        /** @type {HTMLElement} */ (line.closest("main > *")).style.contentVisibility = "visible";
        select(line);
        requestAnimationFrame(() => {
            line.scrollIntoView({ block: "center" });
            keepInView();
        });
    }

    // A click outside the line's listing and the panel deselects a line that still has the book's
    // text. The listener is called in the capture phase, before a click on Undo can select a line.
    addEventListener("click", event => {
        if (selected && isBook(selected) && ![tool, selected.closest("figure")].some(part => event.composedPath().includes(part))) {
            keepPlace(/** @type {Element} */ (event.target), deselect);
        }
    }, { capture: true });
    addEventListener("hashchange", openAddress);
    // An on-screen keyboard covers the bottom of the page, so keep the panel above the keyboard.
    window.visualViewport?.addEventListener("resize", () => {
        const { height, offsetTop } = visualViewport;
        panel.style.bottom = `${Math.max(0, innerHeight - height - offsetTop)}px`;
        keepInView();
    });

    document.querySelectorAll("[data-places]").forEach(makeEditable);
    // The first line is marked "edit" until the reader selects a line.
    document.querySelector("[data-line]").classList.add("first");
    openAddress();
}
