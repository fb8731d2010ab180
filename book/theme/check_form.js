"use strict";

// The forms that say whether a picture is right: what `check` says of the file, which goes nowhere else.
{
    // The module works in a worker: the page can be read and moved meanwhile, and a new file or Reset ends
    // what is no longer wanted.
    const source = `${ask} ${startModule}
        onmessage = async ({ data: [module, file, request] }) => {
            const answer = ask(await startModule(module), request, new Uint8Array(file));
            postMessage({ ...answer, pixels: answer.pixels?.slice() });
        };
        onunhandledrejection = ({ reason }) => { throw reason; };`;
    const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    ownAddresses.add(address);

    const LABELS = ["Yours", "Ours", "Where they differ: orange where yours is brighter, else blue"];

    // What is shown of an answer: its lines, and the pictures side by side.
    function makeReport({ lines: [headline, ...details], size, pixels }) {
        const report = make("span", { class: "report" }, make("b", {}, headline), details.join("\n"));
        if (!size) return [report];
        const width = size[0] / 3;
        const panels = LABELS.map((label, k) => {
            const canvas = make("canvas", { "aria-hidden": "true" });
            paint(canvas, { pixels, size }, k * width, width);
            return make("span", {}, canvas, label);
        });
        return [report, make("span", { class: "panels" }, ...panels)];
    }

    function activate(form) {
        const [input, reset, output] = ["input", "button", "output"].map(tag => form.querySelector(tag));
        let worker;
        const show = (exitCode, ...children) => {
            worker?.terminate();
            worker = null;
            form.dataset.exitCode = exitCode;
            output.replaceChildren(...children);
            reset.disabled = children.length === 0;
        };
        const checkFile = file => {
            if (!file) return show(2, "That isn't a file. Save the picture first, then drop the file.");
            show("", "Looking …");
            let asked;
            try {
                asked = worker = new Worker(address);
            } catch {
                return show(2, `This page can't look at ${file.name}. In our folder, ask: cargo run --bin check`);
            }
            // What comes after Reset, or after a newer file, is dropped.
            const answer = (...parts) => asked === worker && show(...parts);
            asked.onmessage = ({ data }) => answer(data.code, ...makeReport(data));
            asked.onerror = () => answer(2, `This page can't look at ${file.name}. In our folder, ask: cargo run --bin check`);
            const scene = form.elements.scene?.value.trim().normalize();
            const request = `check ${scene ? `@${scene}` : form.dataset.name}\n${file.name}`;
            // A larger file is too large, whatever follows.
            Promise.all([wasmModules.compile("check"), file.slice(0, 2 ** 26 + 1).arrayBuffer()])
                .then(parts => asked.postMessage([...parts, request]), asked.onerror);
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
