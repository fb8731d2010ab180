"use strict";

// The forms that say whether a picture is right: what `check` says of the file, which goes nowhere else.
{
    // The module works in a worker: the page can be read and moved meanwhile, and a check that is no longer
    // wanted is stopped.
    const source = `${ask} ${startModule}
        let check;
        onmessage = async ({ data: [module, request, file, port] }) => {
            check ??= startModule(module);
            const answer = ask(await check, request, file);
            port.postMessage({ ...answer, pixels: answer.pixels?.slice() });
        };
        onunhandledrejection = ({ reason }) => { throw reason; };`;
    let worker, isWorking = false;
    async function askWorker(request, file) {
        const module = await wasmModules.load("check");
        stopWorker();
        worker ??= new Worker(URL.createObjectURL(new Blob([source], { type: "text/javascript" })));
        const { port1, port2 } = new MessageChannel();
        isWorking = true;
        try {
            return await new Promise((resolve, reject) => {
                port1.onmessage = ({ data }) => resolve(data);
                worker.onerror = reject;
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

    const LABELS = ["Yours", "Ours", "Where they differ: orange where yours is brighter, else blue, with a white square around a single pixel"];

    // What is shown of an answer: its lines, and the pictures side by side.
    function makeReport({ text, size, pixels }) {
        const lines = text.split("\n").map(line => {
            // What goes on in the next row begins where the line's own words do.
            const start = line.match(/^ +(\S.*?  +)?/)?.[0].length ?? 0;
            return make("span", { style: `--start: ${start}ch` }, line);
        });
        const report = make("span", { class: "report" }, ...lines);
        if (!size) return [report];
        const [width, height] = [size[0] / 3, size[1]];
        const panels = LABELS.map((label, k) => {
            const canvas = make("canvas", { "aria-hidden": "true", width, height });
            paint(canvas, { pixels, size }, k * width);
            return make("span", {}, canvas, label);
        });
        return [report, make("span", { class: "panels" }, ...panels)];
    }

    function activate(form) {
        const [input, reset, output] = ["input", "button", "output"].map(tag => form.querySelector(tag));
        let lastRun = 0; // Only the last file that was given counts.
        const show = (exitCode, ...children) => {
            form.dataset.exitCode = exitCode;
            output.replaceChildren(...children);
            reset.disabled = children.length === 0;
        };
        const checkFile = async file => {
            if (!file) return;
            const run = lastRun += 1;
            show("", "Looking …");
            try {
                // A larger one is too large, whatever follows.
                const bytes = new Uint8Array(await file.slice(0, 2 ** 26 + 1).arrayBuffer());
                const scene = form.elements.scene?.value.trim();
                const name = scene ? `@${scene}` : form.dataset.name;
                const answer = await askWorker(`check ${name}\n${file.name}`, bytes);
                if (run === lastRun) show(answer.code, ...makeReport(answer));
            } catch {
                if (run === lastRun) show(2, `This page can't look at ${file.name}. In our folder, ask: cargo run --bin check`);
            }
        };
        form.addEventListener("change", () => checkFile(input.files[0]));
        // The same file, written again, is looked at again.
        input.addEventListener("click", () => { input.value = ""; });
        form.addEventListener("reset", () => { lastRun += 1; stopWorker(); show(""); });
        form.addEventListener("dragover", () => form.classList.add("held"));
        for (const end of ["dragleave", "drop"]) form.addEventListener(end, () => form.classList.remove("held"));
        form.addEventListener("drop", ({ dataTransfer: { files } }) => {
            if (files.length === 0) return show(2, "That isn't a file. Save the picture first, then drop the file.");
            input.files = files;
            checkFile(files[0]);
        });
        form.hidden = false;
    }

    const forms = document.querySelectorAll("form[data-live=check]");
    forms.forEach(activate);
    // A file that is dropped beside a form doesn't take the reader away from the page.
    for (const kind of forms.length ? ["dragover", "drop"] : []) addEventListener(kind, event => event.preventDefault());
}
