"use strict";

// Figures and pictures that answer. Gestures become requests to the module, which is the code of the
// five crates; its answers are put in place. Nothing about rays is computed here.

// The modules, each compiled once its script is loaded: "live" draws the figures, "check" looks at
// the reader's picture, and "expressions" draws with a line that the reader edits.
const wasmModules = (() => {
    const resolvers = {}, modules = {}, instances = {};
    const load = name => modules[name] ??= new Promise((resolve, reject) => {
        resolvers[name] = resolve;
        const script = make("script", { src: `${path_to_root}generated/${name}-module.js` });
        script.onerror = reject;
        document.head.append(script);
    }).catch(error => {
        // The next request tries again.
        delete modules[name];
        throw error;
    }).then(base64 => {
        const letters = atob(base64);
        const bytes = new Uint8Array(letters.length);
        for (let k = 0; k < bytes.length; k += 1) bytes[k] = letters.charCodeAt(k);
        return WebAssembly.compile(bytes);
    });
    return {
        provide: (name, base64) => resolvers[name](base64),
        load,
        get: name => instances[name] ??= load(name).then(async module => (await WebAssembly.instantiate(module)).exports)
            .catch(error => { delete instances[name]; throw error; }),
    };
})();

// The answer of a module to a request, about a file if there is one; with pixels if it has a picture.
function ask(module, request, file) {
    const copyIn = (bytes, at) => new Uint8Array(module.memory.buffer, at, bytes.length).set(bytes);
    const words = new TextEncoder().encode(request);
    copyIn(words, module.live_request(words.length));
    if (file) copyIn(file, module.live_file(file.length));
    module.live_answer();
    const copyOut = (at, length) => new Uint8ClampedArray(module.memory.buffer, at, length);
    const text = new TextDecoder().decode(copyOut(module.live_text(), module.live_text_length()));
    const answer = JSON.parse(text);
    if (answer.size) answer.pixels = copyOut(module.live_pixels(), module.live_pixels_length());
    return answer;
}

// Asks the module "check" in a worker: the page can be read and moved meanwhile, and a check that is no
// longer wanted is stopped.
const workerSource = `${ask}
    let check;
    onmessage = async ({ data: [module, request, file, port] }) => {
        check ??= WebAssembly.instantiate(module);
        const answer = ask((await check).exports, request, file);
        port.postMessage({ ...answer, pixels: answer.pixels?.slice() });
    };
    onunhandledrejection = ({ reason }) => { throw reason; };`;
let worker, isWorking = false;
async function askWorker(request, file) {
    const module = await wasmModules.load("check");
    stopWorker();
    worker ??= new Worker(URL.createObjectURL(new Blob([workerSource], { type: "text/javascript" })));
    const { port1, port2 } = new MessageChannel();
    isWorking = true;
    try {
        return await new Promise((resolve, reject) => {
            port1.onmessage = ({ data }) => resolve(data);
            worker.addEventListener("error", reject);
            worker.postMessage([module, request, file, port2], [port2]);
        });
    } catch (error) {
        // The next file begins with a new worker.
        stopWorker();
        throw error;
    } finally {
        isWorking = false;
    }
}

// Ends the worker if it is busy; else it stays, with what it has drawn, for the next file.
function stopWorker() {
    if (!isWorking) return;
    worker.terminate();
    worker = null;
    isWorking = false;
}

// Milliseconds that a picture may take while something moves: a slower one is drawn coarser then, and
// whole after a rest.
const FRAME = 60, REST = 150;

// Makes a figure follow its handles and controls.
function activateFigure(figure, module) {
    const name = figure.dataset.live;
    const description = ask(module, `about ${name}`);
    let values = description.values;

    // The stage: the drawing or the picture, and above it the handles. What is printed stays until
    // something moves.
    const printed = figure.querySelector("svg, img");
    const isPicture = printed.tagName === "IMG";
    const stage = make("div", { class: "stage" });
    printed.replaceWith(stage);
    const size = isPicture
        ? ["width", "height"].map(side => Number(printed.getAttribute(side)))
        : [printed.viewBox.baseVal.width, printed.viewBox.baseVal.height];
    let output = printed;
    if (isPicture) stage.style.aspectRatio = `${size[0]} / ${size[1]}`;
    printed.draggable = false;
    stage.append(printed);

    // A picture is drawn with all its columns, or, while something moves, with a half or a quarter.
    const { columns } = description;
    let divisor = 1, wholeTime = 0, restTimer = 0;
    const request = (verb, ...words) => {
        const sent = columns === null ? values : values.with(columns, description.values[columns] / divisor);
        return [verb, name, ...words, ...sent].join(" ");
    };
    const drawWhole = () => { divisor = 1; show(ask(module, request("show"))); };
    const drawMoving = makeRequest => {
        divisor = [1, 2].find(k => wholeTime / k ** 2 <= FRAME) ?? 4;
        const start = performance.now();
        const answer = ask(module, makeRequest());
        if (answer.size) wholeTime = (performance.now() - start) * divisor ** 2;
        show(answer);
        clearTimeout(restTimer);
        if (answer.size && 1 < divisor) restTimer = setTimeout(drawWhole, REST);
    };

    // The requests of the next frame: of each thing that moves, only the last gesture counts.
    const requests = new Map();
    const drawNextFrame = (source, makeRequest) => {
        const isPlanned = 0 < requests.size;
        requests.set(source, makeRequest);
        if (isPlanned) return;
        requestAnimationFrame(() => {
            const planned = [...requests.values()];
            requests.clear();
            planned.forEach(drawMoving);
        });
    };

    // The controls are printed: for a parameter a range, a switch or a list, and a field for a number.
    const controls = figure.querySelector(".controls");
    const parameterControls = description.values.map((_, k) => {
        const element = controls.querySelector(`[data-parameter="${k}"]`);
        if (!element) return null;
        const inputs = [...element.querySelectorAll("input, select")];
        for (const input of inputs) {
            input.addEventListener("input", () => {
                if (input.value === "") return;
                if (probe !== null) showPanel();
                values = values.with(k, Number(input.type === "checkbox" ? input.checked : input.value));
                drawNextFrame("control", () => request("show"));
            });
            // What was typed gives way to the allowed number that is nearest.
            if (input.type !== "number") continue;
            input.addEventListener("blur", () => { input.value = values[k]; });
            input.addEventListener("keydown", event => { if (event.key === "Enter") input.value = values[k]; });
        }
        return { element, inputs, output: element.querySelector("b"), group: element.dataset.group };
    });
    // Where parameters have groups, the controls of one are visible: of what was touched last.
    const groupSelect = controls.querySelector(".choice select");
    const selectGroup = group => {
        if (!group) return;
        groupSelect.value = group;
        showControls();
        handles.forEach(handle => handle.classList.toggle("chosen", handle.group === group));
    };
    groupSelect?.addEventListener("change", () => selectGroup(groupSelect.value));
    let lastAnswer = ask(module, request("tell"));
    const showControls = () => {
        parameterControls.forEach((control, k) => {
            if (!control) return;
            const { element, inputs, output, group } = control;
            element.hidden = !lastAnswer.visible[k] || group !== groupSelect?.value;
            for (const input of inputs) {
                if (input.type === "checkbox") input.checked = values[k] === 1;
                // What is being typed stays as it is.
                else if (input.type !== "number" || input !== document.activeElement) input.value = values[k];
                if (input.type === "range") input.setAttribute("aria-valuetext", lastAnswer.texts[k]);
            }
            if (output) write(output, lastAnswer.texts[k]);
        });
    };

    // Handles: pointer, finger and arrow keys.
    const placeOfPointer = event => {
        const box = output.getBoundingClientRect();
        return [(event.clientX - box.left) / box.width * size[0], (event.clientY - box.top) / box.height * size[1]];
    };
    const handles = description.handles.map((about, k) => {
        const handle = make("span", {
            class: `handle handle-${about.mark}`, role: "slider", tabindex: 0, "aria-label": about.words, title: about.words,
            "aria-valuemin": about.min, "aria-valuemax": about.max,
        });
        handle.group = about.group;
        handle.addEventListener("focus", () => selectGroup(handle.group));
        let offset = null;
        handle.addEventListener("pointerdown", event => {
            if (event.button !== 0 || event.ctrlKey) return;
            handle.setPointerCapture(event.pointerId);
            if (about.mark === "probe") showPanel();
            selectGroup(handle.group);
            const [x, y] = placeOfPointer(event);
            offset = [handle.place[0] - x, handle.place[1] - y];
            handle.classList.add("held");
        });
        handle.addEventListener("pointermove", event => {
            if (!offset) return;
            const [x, y] = placeOfPointer(event);
            const [dx, dy] = offset;
            drawNextFrame(k, () => request("drag", k, x + dx, y + dy));
        });
        for (const end of ["pointerup", "pointercancel"]) {
            handle.addEventListener(end, () => { offset = null; handle.classList.remove("held"); });
        }
        for (const unwanted of ["touchstart", "dragstart"]) {
            handle.addEventListener(unwanted, event => event.preventDefault());
        }
        handle.addEventListener("keydown", event => {
            const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] }[event.key];
            if (!step || event.altKey || event.ctrlKey || event.metaKey) return;
            event.preventDefault();
            if (about.mark === "probe") showPanel();
            const count = event.shiftKey ? 10 : 1;
            // Keys follow each other faster than frames: none is lost.
            drawMoving(() => request("step", k, count * step[0], count * step[1]));
        });
        stage.append(handle);
        return handle;
    });

    // The probe, if there is one, goes where the picture is pressed, and to the pixel that a link names,
    // such as #pixel=470,120. What is told of a pixel is hidden until then.
    const probeIndex = description.handles.findIndex(handle => handle.mark === "probe");
    const probe = probeIndex < 0 ? null : description.handles[probeIndex];
    const panels = [...document.querySelectorAll(`[data-panel="${name}"]`)];
    const showPanel = () => panels.forEach(panel => { panel.hidden = false; });
    if (probe) {
        stage.classList.add("has-probe");
        stage.addEventListener("click", event => {
            if (event.target !== output) return;
            showPanel();
            drawNextFrame(probeIndex, () => request("drag", probeIndex, ...placeOfPointer(event)));
            handles[probeIndex].focus({ preventScroll: true });
        });
    }
    const openPixel = () => {
        const [, i, j] = location.hash.match(/^#pixel=(\d+)(?:,|%2C)(\d+)$/i) ?? [];
        if (!probe || j === undefined) return;
        const [column, row] = probe.parameters;
        values = values.with(column, Number(i)).with(row, Number(j));
        showPanel();
        drawMoving(() => request("show"));
        figure.scrollIntoView({ block: "center" });
        handles[probeIndex].focus({ preventScroll: true });
    };

    const reset = controls.querySelector(".reset");
    reset.addEventListener("click", () => { values = description.values; drawWhole(); });

    const numbers = [...document.querySelectorAll(`[data-number^="${name}:"]`)];
    const conditionalParts = [...document.querySelectorAll(`[data-when^="${name}:"]`)];
    const code = document.querySelector(`[data-code="${name}:rust"] code`);
    const companion = document.querySelector(`[data-companion="${name}"]`);

    function show(answer) {
        if (answer.error) {
            // There is nothing to show at these values: the last ones stay.
            values = lastAnswer.values;
            showControls();
            fault.textContent = "There is nothing to show at that number.";
            return;
        }
        // The columns of a coarse picture are not the reader's.
        values = columns === null ? answer.values : answer.values.with(columns, description.values[columns]);
        lastAnswer = { ...answer, values };
        if (answer.size) {
            const [width, height] = answer.size;
            if (output === printed) {
                output = make("canvas", { role: "img", "aria-label": printed.alt });
                printed.replaceWith(output);
            }
            if (output.width !== width || output.height !== height) Object.assign(output, { width, height });
            output.getContext("2d").putImageData(new ImageData(answer.pixels, width, height), 0, 0);
        } else if (answer.drawing !== undefined) {
            printed.querySelector("g").innerHTML = answer.drawing;
        }
        if (companion) {
            const companionName = companion.id.replace("figure-", "");
            companion.querySelector("g").innerHTML = ask(module, `show ${companionName} ${values.join(" ")}`).drawing;
        }
        showControls();
        handles.forEach((handle, k) => {
            const parameters = [...new Set(description.handles[k].parameters)];
            handle.place = answer.places[k];
            const isLost = !isInside(handle.place) && handle === document.activeElement;
            handle.hidden = !isInside(handle.place);
            if (isLost) parameterControls[parameters[0]]?.inputs[0].focus();
            for (const [k, side] of ["left", "top"].entries()) handle.style[side] = `${(handle.place?.[k] ?? 0) / size[k] * 100}%`;
            handle.setAttribute("aria-valuenow", values[parameters[0]]);
            handle.setAttribute("aria-valuetext", parameters.map(parameter => answer.texts[parameter]).join(", "));
        });
        // A number that there is not here is left empty, and what speaks of it is hidden.
        const numberOf = key => answer.numbers[key.slice(name.length + 1)] ?? "";
        for (const number of numbers) write(number, numberOf(number.dataset.number));
        for (const part of conditionalParts) part.hidden = numberOf(part.dataset.when) === "";
        if (code && code.textContent !== answer.numbers.rust) {
            code.textContent = answer.numbers.rust;
            window.hljs?.highlightBlock(code);
        }
        keepAddress(answer.numbers.address);
        reset.disabled = values.every((value, k) => value === description.values[k]);
    }
    // Rounded to its step, a handle at the border may be a little outside.
    const isInside = place => place?.every((x, k) => -4 <= x && x <= size[k] + 4) ?? false;

    // A scene of the reader's own is in the address of the page, once a gesture has come to rest.
    let sceneAddress = lastAnswer.numbers.address;
    let addressTimer = 0;
    const fault = make("output", { class: "refused" });
    function keepAddress(address) {
        fault.textContent = "";
        if (address === sceneAddress) return;
        sceneAddress = address;
        clearTimeout(addressTimer);
        addressTimer = setTimeout(() => history.replaceState(null, "", address ? `#scene=${address}` : location.pathname + location.search), 200);
    }
    const openScene = () => {
        if (!location.hash.startsWith("#scene=")) {
            // A heading was pressed: the page has gone there, and the address is the scene's again.
            if (sceneAddress) history.replaceState(null, "", `#scene=${sceneAddress}`);
            return;
        }
        // Some mail programs write a colon as %3A.
        const address = location.hash.slice("#scene=".length).replace(/%3A/gi, ":").replace(/%2C/gi, ",");
        const answer = ask(module, `open ${name} ${address}`);
        if (!answer.error) sceneAddress = answer.numbers.address;
        show(answer);
        fault.textContent = answer.error ? `${answer.error} Nothing has changed.` : "";
    };

    show(lastAnswer);
    selectGroup(handles[0]?.group);
    if (sceneAddress === undefined) {
        // On paper, everything is as printed.
        addEventListener("beforeprint", () => { if (!reset.disabled) reset.click(); });
    } else {
        addEventListener("hashchange", openScene);
        openScene();
    }
    controls.append(fault);
    Object.assign(controls, { hidden: false, inert: false });
    figure.dataset.ready = "";
    addEventListener("hashchange", openPixel);
    openPixel();
}

// Makes a form say whether a picture is right: what `check` says of the file, which goes nowhere else.
function activateCheckForm(form) {
    const [input, reset, output] = ["input", "button", "output"].map(tag => form.querySelector(tag));
    let lastRun = 0; // Only the last file that was given counts.
    const answerElements = ({ text, size, pixels }) => {
        const lines = text.split("\n").map(line => {
            // What goes on in the next row begins where the line's own words do.
            const start = line.match(/^ +(\S.*?  +)?/)?.[0].length ?? 0;
            return make("span", { style: `--start: ${start}ch` }, line);
        });
        const report = make("span", { class: "report" }, ...lines);
        if (!size) return [report];
        const [width, height] = [size[0] / 3, size[1]];
        const labels = ["Yours", "Ours", "Where they differ: orange where yours is brighter, else blue"];
        const panels = labels.map((label, k) => {
            const canvas = make("canvas", { "aria-hidden": "true", width, height });
            canvas.getContext("2d").putImageData(new ImageData(pixels, ...size), -k * width, 0);
            return make("span", {}, canvas, label);
        });
        return [report, make("span", { class: "panels" }, ...panels)];
    };
    const showAnswer = (exitCode, ...children) => {
        form.dataset.exitCode = exitCode;
        output.replaceChildren(...children);
        reset.disabled = children.length === 0;
    };
    const checkFile = async file => {
        if (!file) return;
        const run = lastRun += 1;
        showAnswer("", "Looking …");
        try {
            // A larger one is too large, whatever follows.
            const bytes = new Uint8Array(await file.slice(0, 2 ** 27 + 1).arrayBuffer());
            const answer = await askWorker(`check ${form.dataset.name} ${file.name}`, bytes);
            if (run === lastRun) showAnswer(answer.code, ...answerElements(answer));
        } catch {
            if (run === lastRun) showAnswer(2, `This page can't look at ${file.name}. In our folder, ask: cargo run --bin check`);
        }
    };
    input.addEventListener("change", () => checkFile(input.files[0]));
    form.addEventListener("reset", () => { lastRun += 1; stopWorker(); showAnswer(""); });
    form.addEventListener("dragover", event => { event.preventDefault(); form.classList.add("held"); });
    for (const end of ["dragleave", "drop"]) form.addEventListener(end, () => form.classList.remove("held"));
    form.addEventListener("drop", event => {
        event.preventDefault();
        if (event.dataTransfer.files.length === 0) return;
        input.files = event.dataTransfer.files;
        checkFile(input.files[0]);
    });
    form.hidden = false;
}
document.querySelectorAll("form[data-live=check]").forEach(activateCheckForm);

// A figure answers from when it comes near the view: only then is the module loaded. Where that
// fails, it is tried again while the figure is near.
const activateWhenLoaded = async figure => {
    const module = await wasmModules.get("live").catch(() => null);
    if (module) activateFigure(figure, module);
    else setTimeout(whenNear, 5000, [figure], activateWhenLoaded);
};
const figures = [...document.querySelectorAll("figure[data-live]")];
whenNear(figures, activateWhenLoaded);

// A link that names a pixel brings the picture near whose pixels can be asked.
const scrollToProbe = () => {
    const panel = location.hash.startsWith("#pixel=") && document.querySelector("[data-panel]");
    if (panel) document.querySelector(`figure[data-live="${panel.dataset.panel}"]`)?.scrollIntoView({ block: "center" });
};
addEventListener("hashchange", scrollToProbe);
scrollToProbe();
