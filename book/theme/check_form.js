"use strict";

// The forms that say whether a picture is right: what `check` says of the file, which goes nowhere else.
{
    // The module works in a worker: the page can be read and moved meanwhile, and a new file or Reset ends
    // what is no longer wanted.
    const source = `${ask} ${startModule}
        onmessage = async ({ data: [module, request, file] }) => {
            const answer = ask(await startModule(module), request, file);
            postMessage({ ...answer, pixels: answer.pixels?.slice() });
        };
        onunhandledrejection = ({ reason }) => { throw reason; };`;
    const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));

    // Asks about a file; the one who asked is told nothing where the worker is ended.
    async function askWorker(worker, request, file) {
        // A larger one is too large, whatever follows.
        const bytes = new Uint8Array(await file.slice(0, 2 ** 26 + 1).arrayBuffer());
        const module = await wasmModules.compile("check");
        return new Promise((resolve, reject) => {
            Object.assign(worker, { onmessage: ({ data }) => resolve(data), onerror: reject });
            worker.postMessage([module, request, bytes]);
        });
    }

    const LABELS = ["Yours", "Ours", "Where they differ: orange where yours is brighter, else blue"];

    // What is shown of an answer: its lines, and the pictures side by side.
    function makeReport({ text, size, pixels }) {
        const [verdict, ...lines] = text.split("\n");
        const report = make("span", { class: "report" }, make("b", {}, verdict), lines.join("\n"));
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
        let worker;
        const show = (exitCode, ...children) => {
            worker?.terminate();
            form.dataset.exitCode = exitCode;
            output.replaceChildren(...children);
            reset.disabled = children.length === 0;
        };
        const checkFile = async file => {
            if (!file) return show(2, "That isn't a file. Save the picture first, then drop the file.");
            show("", "Looking …");
            worker = new Worker(address);
            const scene = form.elements.scene?.value.trim();
            try {
                const answer = await askWorker(worker, `check ${scene ? `@${scene}` : form.dataset.name}\n${file.name}`, file);
                show(answer.code, ...makeReport(answer));
            } catch {
                show(2, `This page can't look at ${file.name}. In our folder, ask: cargo run --bin check`);
            }
        };
        form.addEventListener("change", () => { if (input.files.length) checkFile(input.files[0]); });
        // The same file, written again, is looked at again.
        input.addEventListener("click", () => { input.value = ""; });
        form.addEventListener("reset", () => show(""));
        form.addEventListener("drop", ({ dataTransfer: { files } }) => {
            if (files.length) input.files = files;
            checkFile(files[0]);
        });
        form.hidden = false;
    }

    const forms = document.querySelectorAll("form[data-live=check]");
    forms.forEach(activate);
    // A file that is dropped beside a form doesn't take the reader away from the page.
    for (const kind of forms.length ? ["dragover", "drop"] : []) addEventListener(kind, event => event.preventDefault());
}
