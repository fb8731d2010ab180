"use strict";

// The forms that say whether a picture is right. They run `check` in the page, so the file isn't sent anywhere.
{
    // The module runs in a worker. So the page stays responsive, and a new file or Reset can stop a check that is
    // no longer wanted.
    const source = `${ask} ${startModule}
        onmessage = async ({ data: [module, file, request] }) => {
            const answer = ask(await startModule(module), request, new Uint8Array(file));
            postMessage({ ...answer, pixels: answer.pixels?.slice() });
        };
        onunhandledrejection = ({ reason }) => { throw reason; };`;
    const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    ownAddresses.add(address);

    const LABELS = ["Yours", "Ours", "The difference: orange where yours is brighter, blue where it's darker"];

    // The elements that show an answer: its lines, and the pictures side by side.
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
                return show(2, `This page can't check ${file.name}. In our folder, run: cargo run --bin check`);
            }
            // Drop an answer that arrives after Reset or after a newer file.
            const answer = (...parts) => asked === worker && show(...parts);
            asked.onmessage = ({ data }) => answer(data.code, ...makeReport(data));
            asked.onerror = () => answer(2, `This page can't check ${file.name}. In our folder, run: cargo run --bin check`);
            const scene = form.elements.scene?.value.trim().normalize();
            const request = `check ${scene ? `@${scene}` : form.dataset.name}\n${file.name}`;
            // Read one byte more than a file may have: the module then reports that it's too large.
            Promise.all([wasmModules.compile("check"), file.slice(0, 2 ** 26 + 1).arrayBuffer()])
                .then(parts => asked.postMessage([...parts, request]), asked.onerror);
        };
        form.addEventListener("change", () => { if (input.files.length) checkFile(input.files[0]); });
        // Clear the field, so that choosing the same file again after a change is an event, too.
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
    // If a file is dropped beside a form, the browser must not open it in place of the page.
    for (const kind of forms.length ? ["dragover", "drop"] : []) addEventListener(kind, event => event.preventDefault());
}
