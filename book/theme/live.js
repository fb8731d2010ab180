"use strict";

// What answers in this page. Gestures become requests to the module, which is the code of the
// five crates; its answers are put in place. Nothing about rays is computed here.

// The modules, each once the script that holds it has come: "live" is what answers here, and "check"
// looks at the reader's picture.
const liveModule = (() => {
    const come = {}, modules = {}, instances = {};
    const load = name => modules[name] ??= new Promise((resolve, reject) => {
        come[name] = resolve;
        const script = make("script", { src: `${path_to_root}generated/${name}-module.js` });
        script.onerror = reject;
        document.head.append(script);
    }).catch(error => {
        // Who asks next tries again.
        delete modules[name];
        throw error;
    }).then(base64 => {
        const letters = atob(base64);
        const bytes = new Uint8Array(letters.length);
        for (let k = 0; k < bytes.length; k += 1) bytes[k] = letters.charCodeAt(k);
        return WebAssembly.compile(bytes);
    });
    return {
        come: (name, base64) => come[name](base64),
        load,
        get: name => instances[name] ??= load(name).then(async module => (await WebAssembly.instantiate(module)).exports)
            .catch(error => { delete instances[name]; throw error; }),
    };
})();

// Asks the module, about a file if there is one; its answer, with pixels where there is a picture.
function ask(module, request, file) {
    const put = (bytes, at) => new Uint8Array(module.memory.buffer, at, bytes.length).set(bytes);
    const words = new TextEncoder().encode(request);
    put(words, module.live_request(words.length));
    if (file) put(file, module.live_file(file.length));
    module.live_answer();
    const bytes = (at, length) => new Uint8ClampedArray(module.memory.buffer, at, length);
    const text = new TextDecoder().decode(bytes(module.live_text(), module.live_text_length()));
    const answer = JSON.parse(text);
    if (answer.size) answer.pixels = bytes(module.live_pixels(), module.live_pixels_length());
    return answer;
}

// Asks what looks at a file, beside the page, in a worker: the page can be read and moved meanwhile,
// and what is no longer wanted is stopped.
const work = `${ask}
    let check;
    onmessage = async ({ data: [module, request, file, port] }) => {
        check ??= WebAssembly.instantiate(module);
        const answer = ask((await check).exports, request, file);
        port.postMessage({ ...answer, pixels: answer.pixels?.slice() });
    };
    onunhandledrejection = ({ reason }) => { throw reason; };`;
let worker, isWorking = false;
async function askBeside(request, file) {
    const module = await liveModule.load("check");
    stopWorking();
    worker ??= new Worker(URL.createObjectURL(new Blob([work], { type: "text/javascript" })));
    const { port1, port2 } = new MessageChannel();
    isWorking = true;
    try {
        return await new Promise((resolve, reject) => {
            port1.onmessage = ({ data }) => resolve(data);
            worker.addEventListener("error", reject);
            worker.postMessage([module, request, file, port2], [port2]);
        });
    } catch (error) {
        // Nothing is left of what went wrong.
        stopWorking();
        throw error;
    } finally {
        isWorking = false;
    }
}

// Ends the worker if it is busy; what it has drawn is kept for the next file where it is not.
function stopWorking() {
    if (!isWorking) return;
    worker.terminate();
    worker = null;
    isWorking = false;
}

const make = (tag, attributes, ...children) => {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
};

// A text that is as it was stays, and nothing is laid out anew for it.
const write = (element, text) => { if (element.textContent !== text) element.textContent = text; };

// Makes one figure answer.
function liven(figure, module) {
    const name = figure.dataset.live;
    const about = ask(module, `about ${name}`);
    let values = about.values;

    // The stage: the drawing or the picture, and above it the handles. What is printed stays to be
    // seen until something is moved.
    const still = figure.querySelector("svg, img");
    const stage = make("div", { class: "stage" });
    still.replaceWith(stage);
    const size = still.tagName === "IMG"
        ? [Number(still.getAttribute("width")), Number(still.getAttribute("height"))]
        : [still.viewBox.baseVal.width, still.viewBox.baseVal.height];
    let sight = still;
    if (still.tagName === "IMG") stage.style.aspectRatio = `${size[0]} / ${size[1]}`;
    still.draggable = false;
    stage.append(still);

    // What waits to be asked: of each thing that is moved, only the last gesture before a frame counts.
    const waiting = new Map();
    const later = (what, request) => {
        const isAsked = 0 < waiting.size;
        waiting.set(what, request);
        if (isAsked) return;
        requestAnimationFrame(() => {
            const requests = [...waiting.values()];
            waiting.clear();
            requests.forEach(last => show(ask(module, last())));
        });
    };
    const request = (verb, ...words) => [verb, name, ...words, ...values].join(" ");

    // Ranges, switches and lists are printed; they are those of what no handle turns there.
    const printed = ask(module, request("tell"));
    const isInside = ([x, y]) => 0 <= x && x <= size[0] && 0 <= y && y <= size[1];
    const controls = figure.querySelector(".controls");
    const parameterControls = about.values.map((_, k) => {
        const label = controls.querySelector(`[data-parameter="${k}"]`);
        if (!label) return null;
        const [input, output] = [label.querySelector("input"), label.querySelector("b")];
        const isSwitch = input.type === "checkbox";
        input.addEventListener("input", () => {
            values = values.with(k, Number(isSwitch ? input.checked : input.value));
            later("show", () => request("show"));
        });
        return { label, input, output, isSwitch, group: label.dataset.group };
    });
    // Where controls are of several things, those of one are to be seen: of what was touched last.
    const choice = controls.querySelector(".choice select");
    const choose = thing => {
        if (!thing) return;
        choice.value = thing;
        parameterControls.forEach(control => { if (control) control.label.hidden = control.group !== thing; });
        handles.forEach(grip => grip.classList.toggle("chosen", grip.thing === thing));
    };
    choice?.addEventListener("change", () => choose(choice.value));

    // Handles: pointer, finger and arrow keys.
    const place = event => {
        const box = sight.getBoundingClientRect();
        return [(event.clientX - box.left) / box.width * size[0], (event.clientY - box.top) / box.height * size[1]];
    };
    const handles = about.handles.map((handle, k) => {
        const grip = make("span", {
            class: `handle handle-${handle.mark}`, role: "slider", tabindex: 0, "aria-label": handle.words,
            "aria-valuemin": handle.min, "aria-valuemax": handle.max,
        });
        grip.thing = handle.group;
        grip.addEventListener("focus", () => choose(grip.thing));
        let offset = null;
        grip.addEventListener("pointerdown", event => {
            if (event.button !== 0 || event.ctrlKey) return;
            grip.setPointerCapture(event.pointerId);
            if (handle.mark === "probe") reveal();
            choose(grip.thing);
            const [x, y] = place(event);
            offset = [grip.at[0] - x, grip.at[1] - y];
            grip.classList.add("held");
        });
        grip.addEventListener("pointermove", event => {
            if (!offset) return;
            const [x, y] = place(event);
            const [dx, dy] = offset;
            later(k, () => request("drag", k, x + dx, y + dy));
        });
        for (const end of ["pointerup", "pointercancel"]) {
            grip.addEventListener(end, () => { offset = null; grip.classList.remove("held"); });
        }
        for (const unwanted of ["touchstart", "dragstart"]) {
            grip.addEventListener(unwanted, event => event.preventDefault());
        }
        grip.addEventListener("keydown", event => {
            const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] }[event.key];
            if (!step || event.altKey || event.ctrlKey || event.metaKey) return;
            event.preventDefault();
            if (handle.mark === "probe") reveal();
            const far = event.shiftKey ? 10 : 1;
            // Keys follow each other faster than frames: none is lost.
            show(ask(module, request("step", k, far * step[0], far * step[1])));
        });
        stage.append(grip);
        return grip;
    });
    // A press on no handle of a picture brings the one there that asks.
    const asking = about.handles.findIndex(handle => handle.mark === "probe");
    if (asking >= 0) {
        stage.classList.add("asked-by-press");
        stage.addEventListener("click", event => {
            if (event.target !== sight) return;
            reveal();
            later(asking, () => request("drag", asking, ...place(event)));
            handles[asking].focus({ preventScroll: true });
        });
    }

    const reset = controls.querySelector(".reset");
    reset.addEventListener("click", () => { values = about.values; show(ask(module, request("show"))); });

    const numbers = [...document.querySelectorAll(`[data-number^="${name}:"]`)];
    const spoken = [...document.querySelectorAll(`[data-when^="${name}:"]`)];
    const code = document.querySelector(`[data-code="${name}:rust"] code`);
    const beside = document.querySelector(`[data-beside="${name}"] g`);
    const follow = [...document.querySelectorAll(`[data-chain="${name}"]`)];

    function show(answer) {
        if (answer.error) return;
        values = answer.values;
        if (answer.size) {
            const [width, height] = answer.size;
            if (sight === still) {
                sight = make("canvas", { role: "img", "aria-label": still.alt });
                still.replaceWith(sight);
            }
            if (sight.width !== width || sight.height !== height) Object.assign(sight, { width, height });
            sight.getContext("2d").putImageData(new ImageData(answer.pixels, width, height), 0, 0);
        } else if (answer.drawing !== undefined) {
            still.querySelector("g").innerHTML = answer.drawing;
        }
        if (beside) beside.innerHTML = answer.beside;
        parameterControls.forEach((control, k) => {
            if (!control) return;
            control.label.hidden = !answer.shown[k] || control.group !== choice?.value;
            if (control.isSwitch) { control.input.checked = values[k] === 1; return; }
            control.input.value = values[k];
            control.input.setAttribute("aria-valuetext", answer.texts[k]);
            write(control.output, answer.texts[k]);
        });
        handles.forEach((grip, k) => {
            const turns = [...new Set(about.handles[k].parameters)];
            grip.at = answer.places[k];
            const isLost = !isInside(grip.at) && grip === document.activeElement;
            grip.hidden = !isInside(grip.at);
            if (isLost) parameterControls[turns[0]]?.input.focus();
            grip.style.left = `${grip.at[0] / size[0] * 100}%`;
            grip.style.top = `${grip.at[1] / size[1] * 100}%`;
            grip.setAttribute("aria-valuenow", values[turns[0]]);
            grip.setAttribute("aria-valuetext", turns.map(control => answer.texts[control]).join(", "));
        });
        // A number that there is not here is left empty, and what speaks of it is hidden.
        const told = which => answer.numbers[which.slice(name.length + 1)] ?? "";
        for (const number of numbers) write(number, told(number.dataset.number));
        if (code && code.textContent !== answer.numbers.rust) {
            code.textContent = answer.numbers.rust;
            window.hljs?.highlightBlock(code);
        }
        keep(answer.numbers.address);
        for (const part of spoken) part.hidden = told(part.dataset.when) === "";
        reset.disabled = values.every((value, k) => value === about.values[k]);
    }
    // What is said of a pixel comes when the first is asked.
    function reveal() {
        follow.forEach(part => { part.hidden = false; });
    }
    // What is made here may be kept: it is in the address, once a gesture has come to rest.
    let kept = printed.numbers.address;
    let rest;
    const refused = make("output", { class: "refused" });
    function keep(address) {
        refused.textContent = "";
        if (address === kept) return;
        kept = address;
        clearTimeout(rest);
        rest = setTimeout(() => history.replaceState(null, "", kept ? `#scene=${kept}` : location.pathname + location.search), 200);
    }
    const open = () => {
        if (!location.hash.startsWith("#scene=")) {
            // A heading was pressed: the page has gone there, and the address is the scene's again.
            if (kept) history.replaceState(null, "", `#scene=${kept}`);
            return;
        }
        // Some mail programs write a colon as %3A.
        const address = location.hash.slice("#scene=".length).replace(/%3A/gi, ":").replace(/%2C/gi, ",");
        const answer = ask(module, `open ${name} ${address}`);
        if (!answer.error) kept = answer.numbers.address;
        show(answer);
        refused.textContent = answer.error ? `${answer.error} Nothing has changed.` : "";
    };

    choose(handles[0]?.thing);
    show(printed);
    if (kept === undefined) {
        // On paper, everything is as printed.
        addEventListener("beforeprint", () => { if (!reset.disabled) reset.click(); });
    } else {
        controls.append(refused);
        addEventListener("hashchange", open);
        open();
    }
    Object.assign(controls, { hidden: false, inert: false });
    figure.dataset.ready = "";
}

// Says whether a picture is right: what `check` says of the file, which goes nowhere else.
function looking(form) {
    const [input, reset, output] = ["input", "button", "output"].map(tag => form.querySelector(tag));
    let last = 0; // Only the last file that was given counts.
    const told = ({ text, size, pixels }) => {
        const said = make("span", { class: "said" });
        for (const line of text.split("\n")) {
            // What goes on in the next row begins where the line's own words do.
            const start = line.match(/^ +(\S.*?  +)?/)?.[0].length ?? 0;
            const row = make("span", { style: `--start: ${start}ch` }, line);
            said.append(row);
        }
        if (!size) return [said];
        const [width, height] = [size[0] / 3, size[1]];
        const labels = ["Yours", "Ours", "Where they differ: orange where yours is brighter, else blue"];
        const panels = labels.map((label, k) => {
            const canvas = make("canvas", { "aria-hidden": "true", width, height });
            canvas.getContext("2d").putImageData(new ImageData(pixels, ...size), -k * width, 0);
            return make("span", {}, canvas, label);
        });
        return [said, make("span", { class: "panels" }, ...panels)];
    };
    const show = (code, ...children) => {
        form.dataset.told = code;
        output.replaceChildren(...children);
        reset.disabled = children.length === 0;
    };
    const look = async file => {
        if (!file) return;
        const mine = last += 1;
        show("", "Looking …");
        try {
            // A larger one is too large, whatever follows.
            const bytes = new Uint8Array(await file.slice(0, 2 ** 27 + 1).arrayBuffer());
            const answer = await askBeside(`check ${form.dataset.name} ${file.name}`, bytes);
            if (mine === last) show(answer.code, ...told(answer));
        } catch {
            if (mine === last) show(2, `This page can't look at ${file.name}. In our folder, ask: cargo run --bin check`);
        }
    };
    input.addEventListener("change", () => look(input.files[0]));
    form.addEventListener("reset", () => { last += 1; stopWorking(); show(""); });
    form.addEventListener("dragover", event => { event.preventDefault(); form.classList.add("held"); });
    for (const end of ["dragleave", "drop"]) form.addEventListener(end, () => form.classList.remove("held"));
    form.addEventListener("drop", event => {
        event.preventDefault();
        if (event.dataTransfer.files.length === 0) return;
        input.files = event.dataTransfer.files;
        look(input.files[0]);
    });
    form.hidden = false;
}
document.querySelectorAll("form[data-live=check]").forEach(looking);

// A figure answers from when it comes near the view: only then is the module loaded. Where that
// fails, it is tried again while the figure is near.
const wake = async figure => {
    const module = await liveModule.get("live").catch(() => null);
    if (module) liven(figure, module);
    else setTimeout(whenNear, 5000, [figure], wake);
};
whenNear(document.querySelectorAll("figure[data-live]"), wake);
