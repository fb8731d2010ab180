"use strict";

// A scene of the reader's own: its tools, its gestures, and its address.

// Columns of a picture that is kept: it is drawn with twice as many, for smooth edges.
const KEPT_COLUMNS = 1920;

function followScene(figure) {
    const tools = make("div", { class: "tools" });
    figure.controls.append(tools);
    const addTool = (words, act) => {
        const button = tools.appendChild(make("button", { type: "button" }, words));
        button.addEventListener("click", act);
        return button;
    };
    const writeAddress = followAddress(figure, addHistory(figure, addTool));
    addSphereButton(figure, addTool);
    addColourField(figure, tools);
    addCopies(figure, addTool, writeAddress);
    dragObjects(figure);
}

// What was done can be undone. Returns a function that keeps the values of a scene at rest.
function addHistory(figure, addTool) {
    const states = [figure.values];
    let now = 0;
    const keepState = () => {
        if (figure.values.some((value, k) => value !== states[now][k])) states.splice(now += 1, Infinity, figure.values);
        [undo.disabled, redo.disabled] = [now === 0, now === states.length - 1];
    };
    const showState = step => {
        keepState();
        if (!states[now + step]) return;
        now += step;
        figure.values = states[now];
        figure.draw();
    };
    const undo = addTool("Undo", () => showState(-1));
    const redo = addTool("Redo", () => showState(1));
    addEventListener("keydown", event => {
        const isTyping = event.target.type === "text" || event.target.isContentEditable;
        if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z" || isTyping) return;
        event.preventDefault();
        showState(event.shiftKey ? 1 : -1);
    });
    figure.reset.addEventListener("click", event => {
        if (!confirm("Begin again with the scene of step 5? Undo brings yours back.")) event.stopImmediatePropagation();
    }, { capture: true });
    return keepState;
}

// The address of the page holds the scene, once a gesture has come to rest. Returns what writes it at once.
function followAddress(figure, keepState) {
    let restTimer = 0;
    const writeAddress = () => {
        const { address } = figure.answer.numbers;
        if (address) history.replaceState(null, "", `#scene=${address}`);
        else if (location.hash.startsWith("#scene=")) history.replaceState(null, "", location.pathname);
        keepState();
    };
    figure.afterShow = () => {
        clearTimeout(restTimer);
        restTimer = setTimeout(writeAddress, 200);
    };
    const openScene = () => {
        // Where a heading was pressed, the page has gone there, and the address is the scene's again.
        if (!location.hash.startsWith("#scene=")) return writeAddress();
        // Some mail programs write a colon as %3A.
        const address = location.hash.slice("#scene=".length).replace(/%3A/gi, ":").replace(/%2C/gi, ",");
        try {
            figure.show(figure.ask("open", address));
            figure.root.scrollIntoView({ block: "nearest" });
        } catch (error) {
            if (!(error instanceof Refusal)) throw error;
            figure.fault.textContent = `${error.message} Nothing has changed.`;
        }
    };
    addEventListener("hashchange", openScene);
    openScene();
    return writeAddress;
}

// The next sphere that is not there comes into the scene; its switch is before its x.
function addSphereButton(figure, addTool) {
    addTool("+ Sphere", () => {
        const isMissing = ({ about: { mark, parameters: [x] } }) => mark === "point" && figure.values[x - 1] === 0;
        const handle = figure.handles.find(isMissing);
        if (!handle) return void (figure.fault.textContent = "There can be twelve spheres at most.");
        figure.setValue(handle.about.parameters[0] - 1, 1);
        figure.draw();
        figure.selectGroup(handle.group);
        handle.focus({ preventScroll: true });
    });
}

// One field sets red, green and blue of what was touched last.
function addColourField(figure, tools) {
    const field = make("input", { type: "color" });
    const label = tools.appendChild(make("label", {}, "Colour ", field));
    const isChannel = (control, words) => control?.group === figure.groupSelect.value
        && control.element.querySelector("label span").textContent.trim() === words;
    const findChannels = () => ["red", "green", "blue"].map(words =>
        figure.parameterControls.findIndex(control => isChannel(control, words)));
    field.addEventListener("input", () => {
        const bytes = field.value.match(/\w\w/g).map(byte => parseInt(byte, 16));
        findChannels().forEach((channel, k) => figure.setValue(channel, bytes[k] / 255));
        figure.drawNextFrame("show");
    });
    figure.afterControls = () => {
        const channels = findChannels();
        label.hidden = channels.includes(-1);
        if (label.hidden) return;
        const bytes = channels.map(channel => Math.round(255 * Math.min(figure.values[channel], 1)));
        field.value = `#${bytes.map(byte => byte.toString(16).padStart(2, "0")).join("")}`;
    };
    figure.afterControls();
}

function addCopies(figure, addTool, writeAddress) {
    const link = addTool("Copy link", () => { writeAddress(); copyBy(link, location.href); });
    const rust = addTool("Copy Rust", () => copyBy(rust, figure.answer.numbers.rust));
    addTool("Download PNG", () => {
        const large = make("canvas", {}), kept = make("canvas", {});
        const values = figure.values.map((value, k) => k === figure.about.columns ? 2 * KEPT_COLUMNS : value);
        const answer = figure.ask("show", ...values);
        paint(large, answer);
        [kept.width, kept.height] = answer.size.map(side => side / 2);
        kept.getContext("2d").drawImage(large, 0, 0, kept.width, kept.height);
        kept.toBlob(blob => make("a", { href: URL.createObjectURL(blob), download: "own_scene.png" }).click());
    });
}

// A ball is dragged where it is pressed. Its depth changes by a pinch on a touchpad, by the wheel with Alt,
// or by dragging with Shift.
function dragObjects(figure) {
    const find = event => {
        const { group } = figure.ask("press", ...figure.placeOfPointer(event), ...figure.values);
        return figure.handles.find(handle => handle.group === group && !handle.hidden);
    };
    figure.stage.addEventListener("pointerdown", event => {
        if (event.target === figure.output) find(event)?.grab(event);
    });
    // A finger beside the balls scrolls the page.
    figure.stage.addEventListener("touchstart", event => {
        if (event.touches.length === 1 && find(event.touches[0])) event.preventDefault();
    }, { passive: false });
    figure.stage.addEventListener("wheel", event => {
        const chosen = figure.handles.find(handle => handle.group === figure.groupSelect.value);
        if (!chosen || !(event.ctrlKey || event.altKey)) return;
        event.preventDefault();
        chosen.changeDepth(event.deltaY * (event.ctrlKey ? 1.5 : 0.3));
    }, { passive: false });
}
