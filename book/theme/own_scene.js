"use strict";

// A scene of the reader's own: its tools, its gestures, and its address.
{
    // The number of columns in a picture that a reader downloads. The picture is drawn with twice
    // as many columns and then scaled down, which smooths its edges.
    const KEPT_COLUMNS = 1920;

    // In an address that opens a scene, this prefix precedes the scene's values.
    const SCENE = "#scene=";

    /** @typedef {(words: string, act: () => void) => HTMLButtonElement} AddTool */

    book.followScene = figure => {
        dragObjects(figure);
        if (figure.isPreview) addLinkAndReset(figure);
        else addTools(figure);
        figure.afterShow(() => markCoveredBalls(figure));
        markCoveredBalls(figure);
    };

    /** @param {InteractiveFigure} figure */
    function addTools(figure) {
        const tools = book.make("div", { class: "tools" });
        figure.controls.append(tools);
        /** @type {AddTool} */
        const addTool = (words, act) => {
            const button = book.make("button", { type: "button" }, words);
            button.addEventListener("click", act);
            tools.append(button);
            return button;
        };
        const writeAddress = followAddress(figure, addHistory(figure, addTool));
        addSphereButton(figure, addTool);
        addColourField(figure, tools);
        addCopies(figure, addTool, writeAddress);
    }

    // Marks the handles of balls whose centre is behind another ball.
    /** @param {InteractiveFigure} figure */
    function markCoveredBalls(figure) {
        for (const { element, about, object, position } of figure.handles) {
            const isVisible = about.mark !== "point" || element.hidden || pickObject(figure, position) === object;
            element.classList.toggle("covered", !isVisible);
        }
    }

    // Returns the name of the object at a position in the picture.
    /** @param {InteractiveFigure} figure @param {[number, number]} position @returns {string | null} */
    const pickObject = ({ module, name, values }, position) => book.ask(module, { request: "pick", figure: name, values, position }).object;

    // If the selected object isn't in the scene, selects the first object that is in the scene.
    // Call this function only after a whole scene has been replaced: at other times, a reader may
    // select a missing sphere in order to add it.
    /** @param {InteractiveFigure} figure */
    function selectPresent(figure) {
        const { handles, objectSelect, values } = figure;
        /** @param {Handle} handle */
        const isPresent = handle => values[handle.about.presence] !== 0;
        if (handles.some(handle => handle.object === objectSelect.value && !isPresent(handle))) {
            figure.selectObject(handles.find(isPresent).object);
        }
    }

    // The link below a preview opens the scene that the preview shows. Once the reader has changed
    // the scene, there is also a Reset button.
    /** @param {InteractiveFigure} figure */
    function addLinkAndReset(figure) {
        const { values } = figure;
        const link = figure.controls.querySelector("a");
        const reset = book.make("button", { type: "button", class: "copy", hidden: "" }, "Reset");
        reset.addEventListener("click", () => {
            figure.values = values;
            figure.draw();
        });
        figure.controls.querySelector(".hint").append(" ", reset);
        figure.afterShow(() => {
            const { address } = figure.reply;
            link.hash = address ? SCENE + address : "";
            reset.hidden = !address;
        });
    }

    // Adds Undo and Redo. Returns a function that records the values of the scene. Call the
    // returned function when the scene is at rest.
    /** @param {InteractiveFigure} figure @param {AddTool} addTool */
    function addHistory(figure, addTool) {
        const states = new book.History(figure.values);
        const keepState = () => {
            states.record(figure.values);
            [undo.disabled, redo.disabled] = [!states.has(-1), !states.has(1)];
        };
        /** @param {number} steps */
        const showState = steps => {
            keepState();
            if (!states.has(steps)) return;
            figure.values = states.go(steps);
            figure.draw();
            selectPresent(figure);
        };
        const undo = addTool("Undo", () => showState(-1));
        const redo = addTool("Redo", () => showState(1));
        addEventListener("keydown", event => {
            const target = /** @type {HTMLInputElement} */ (event.target);
            const isTyping = target.type === "text" || target.isContentEditable;
            const steps = book.readUndoKey(event);
            if (!steps || isTyping) return;
            event.preventDefault();
            showState(steps);
        });
        figure.reset.addEventListener("click", event => {
            if (!confirm("Begin again with the scene of step 5? Undo brings yours back.")) event.stopImmediatePropagation();
        }, { capture: true });
        figure.reset.addEventListener("click", () => selectPresent(figure));
        return keepState;
    }

    // Writes the scene into the page's address each time a gesture ends. Opens the scene that the
    // address contains, both now and whenever the address changes. Returns a function that writes
    // the address at once.
    /** @param {InteractiveFigure} figure @param {() => void} keepState */
    function followAddress(figure, keepState) {
        let restTimer = 0;
        const writeAddress = () => {
            const { address } = figure.reply;
            if (address) history.replaceState(null, "", SCENE + address);
            else if (location.hash.startsWith(SCENE)) history.replaceState(null, "", location.pathname);
            keepState();
        };
        // A drag that pauses isn't over: it ends when the pointer is lifted.
        let isPressed = false;
        figure.root.addEventListener("pointerdown", () => { isPressed = true; });
        for (const kind of ["pointerup", "pointercancel"]) addEventListener(kind, () => { isPressed = false; });
        const writeAtRest = () => {
            clearTimeout(restTimer);
            restTimer = setTimeout(() => isPressed ? writeAtRest() : writeAddress(), 200);
        };
        figure.afterShow(writeAtRest);
        const openScene = () => {
            // If a link to a heading has replaced the scene in the address, the page has scrolled
            // to the heading by now, so put the scene back into the address.
            if (!location.hash.startsWith(SCENE)) return writeAddress();
            // Some mail programs escape the colons and commas in an address.
            const address = location.hash.slice(SCENE.length).replace(/%3A/gi, ":").replace(/%2C/gi, ",");
            try {
                figure.show(book.ask(figure.module, { request: "open", figure: figure.name, address }));
                selectPresent(figure);
                figure.root.scrollIntoView({ block: "nearest" });
            } catch (error) {
                if (!(error instanceof book.Refusal)) throw error;
                figure.fault.textContent = `${error.message} Nothing has changed.`;
            }
        };
        addEventListener("hashchange", openScene);
        openScene();
        return writeAddress;
    }

    // Adds a button that puts the next missing sphere into the scene.
    /** @param {InteractiveFigure} figure @param {AddTool} addTool */
    function addSphereButton(figure, addTool) {
        addTool("+ Sphere", () => {
            const handle = figure.handles.find(({ about: { mark, presence } }) => mark === "point" && figure.values[presence] === 0);
            if (!handle) return void (figure.fault.textContent = "There can be twelve spheres at most.");
            figure.setValue(handle.about.presence, 1);
            figure.draw();
            figure.selectObject(handle.object);
            handle.element.focus({ preventScroll: true });
        });
    }

    // Adds a field for the colour of the chosen object. The field is hidden while the chosen object
    // has no colour.
    /** @param {InteractiveFigure} figure @param {HTMLElement} tools */
    function addColourField(figure, tools) {
        const field = book.make("input", { type: "color" });
        const label = book.make("label", {}, "Colour ", field);
        tools.append(label);
        const findChannels = () => figure.about.colours[figure.objectSelect.value];
        field.addEventListener("input", () => {
            const bytes = field.value.match(/\w\w/g).map(byte => parseInt(byte, 16));
            findChannels().forEach((channel, k) => figure.setValue(channel, bytes[k] / 255));
            figure.drawNextFrame({ request: "show" });
        });
        const showColour = () => {
            const channels = findChannels();
            label.hidden = !channels;
            if (!channels) return;
            const bytes = channels.map(channel => Math.round(255 * Math.min(figure.values[channel], 1)));
            field.value = `#${bytes.map(byte => byte.toString(16).padStart(2, "0")).join("")}`;
        };
        figure.afterControls(showColour);
        showColour();
    }

    /** @param {InteractiveFigure} figure @param {AddTool} addTool @param {() => void} writeAddress */
    function addCopies(figure, addTool, writeAddress) {
        const link = addTool("Copy link", () => { writeAddress(); book.copyAndReport(link, location.href); });
        const rust = addTool("Copy Rust", () => book.copyAndReport(rust, figure.reply.program));
        addTool("Download PNG", () => {
            const large = book.make("canvas", {}), kept = book.make("canvas", {});
            const { module, name, values } = figure;
            const reply = book.ask(module, { request: "show", figure: name, values, columns: 2 * KEPT_COLUMNS });
            book.paint(large, reply);
            [kept.width, kept.height] = reply.size.map(side => side / 2);
            kept.getContext("2d").drawImage(large, 0, 0, kept.width, kept.height);
            kept.toBlob(blob => book.make("a", { href: URL.createObjectURL(blob), download: "own_scene.png" }).click());
        });
    }

    // Lets the reader drag a ball by any point on it. The reader can change a ball's depth by
    // pinching on a touchpad, turning the wheel with Alt, or dragging with Shift.
    /** @param {InteractiveFigure} figure */
    function dragObjects(figure) {
        /** @param {{ clientX: number, clientY: number }} pointer */
        const findHandle = pointer => {
            const object = pickObject(figure, figure.positionOfPointer(pointer));
            return figure.handles.find(handle => handle.object === object && !handle.element.hidden);
        };
        figure.stage.addEventListener("pointerdown", event => {
            if (event.target === figure.output) findHandle(event)?.grab(event);
        });
        // A touch that isn't on a ball still scrolls the page.
        figure.stage.addEventListener("touchstart", event => {
            if (event.touches.length === 1 && findHandle(event.touches[0])) event.preventDefault();
        }, { passive: false });
        figure.stage.addEventListener("wheel", event => {
            const chosen = figure.handles.find(handle => handle.element.matches(".chosen"));
            if (!chosen || !(event.ctrlKey || event.altKey)) return;
            event.preventDefault();
            chosen.changeDepth(event.deltaY * (event.ctrlKey ? 1.5 : 0.3));
        }, { passive: false });
    }
}
