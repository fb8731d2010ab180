"use strict";

// The forms that say whether a picture is right. The module `check` examines the file inside the
// browser. The file isn't sent anywhere.
{
    // The module runs in a worker, so that the page stays usable while a file is checked. If the
    // reader chooses a new file or presses Reset, the worker is terminated.
    const source = `const book = { ask: ${book.ask}, startModule: ${book.startModule}, Refusal: ${book.Refusal} };
        onmessage = async ({ data: [module, file, request] }) => {
            const reply = book.ask(await book.startModule(module), request, new Uint8Array(file));
            postMessage({ ...reply, pixels: reply.pixels?.slice() });
        };
        onunhandledrejection = ({ reason }) => { throw reason; };`;
    const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    book.trustAddress(address);

    // The value of `data-check` in a form that accepts any picture. For such a form, `check` finds
    // out which picture the file should show.
    const ANY_PICTURE = "*";

    const LABELS = ["Yours", "Ours", "The difference: orange where yours is brighter, blue where it's darker"];

    // Makes elements for the lines of a reply and for its three pictures. The reply's pixels
    // contain these pictures side by side.
    /** @param {CheckReply} reply */
    function makeReport({ lines: [headline, ...details], links, size, pixels }) {
        // In a listed mistake, the correct lines of code start with a minus, and the wrong lines
        // that were written instead start with a plus.
        const parts = details.map((line, k) => {
            const end = k + 1 < details.length ? "\n" : "";
            const address = links?.[line];
            if (address) return book.make("a", { href: address }, line, end);
            if (line.startsWith("  - ")) return book.make("del", {}, line, end);
            return line.startsWith("  + ") ? book.make("ins", {}, line, end) : line + end;
        });
        const report = book.make("span", { class: "report" }, book.make("b", {}, headline), ...parts);
        if (!size) return [report];
        const width = size[0] / 3;
        const panels = LABELS.map((label, k) => {
            const canvas = book.make("canvas", { "aria-hidden": "true" });
            book.paint(canvas, { pixels, size }, k * width, width);
            return book.make("span", {}, canvas, label);
        });
        return [report, book.make("span", { class: "panels" }, ...panels)];
    }

    // Sets up a form so that each file that a reader chooses in it is checked. Returns a function
    // that checks the first of some dropped files.
    /** @param {HTMLFormElement} form @returns {(files: FileList) => void} */
    function activate(form) {
        const input = form.querySelector("input"), reset = form.querySelector("button"), output = form.querySelector("output");
        const expected = form.dataset.check === ANY_PICTURE ? null : form.dataset.check;
        /** @type {Worker | null} */
        let worker = null;
        /** @param {ExitCode | ""} exitCode @param {(Node | string)[]} children */
        const show = (exitCode, ...children) => {
            worker?.terminate();
            worker = null;
            form.dataset.exitCode = String(exitCode);
            output.replaceChildren(...children);
            reset.disabled = children.length === 0;
        };
        /** @param {File | undefined} file */
        const checkFile = file => {
            if (!file) return show(2, "That isn't a file. Save the picture first, then drop the file.");
            show("", "Looking …");
            /** @type {Worker} */
            let asked;
            try {
                asked = worker = new Worker(address);
            } catch {
                return show(2, `This page can't check ${file.name}. In our folder, run: cargo run --bin check`);
            }
            const { scene: field } = /** @type {any} */ (form.elements);
            const scene = field?.value.trim().normalize();
            // Shows a reply, unless the reader has pressed Reset or chosen a newer file since the
            // request.
            /** @param {ExitCode | ""} exitCode @param {(Node | string)[]} children */
            const showIfAsked = (exitCode, ...children) => {
                if (asked === worker) show(exitCode, ...children);
            };
            asked.onmessage = ({ data }) => {
                showIfAsked(data.code, ...makeReport(data));
                if (data.code !== 0 || scene) return;
                book.store("right", expected ?? file.name.replace(/\.png$/i, ""), true);
                book.markRight();
            };
            const fail = () => showIfAsked(2, `This page can't check ${file.name}. In our folder, run: cargo run --bin check`);
            asked.onerror = fail;
            /** @type {ModuleRequest} */
            const request = scene ? { request: "check-scene", fileName: file.name, person: scene }
                : { request: "check", fileName: file.name, picture: expected };
            // `check` refuses files of more than 2 ** 26 bytes. Read only the first 2 ** 26 + 1
            // bytes of a larger file: `check` refuses these bytes, too.
            Promise.all([book.modules.compile("check"), file.slice(0, 2 ** 26 + 1).arrayBuffer()])
                .then(parts => asked.postMessage([...parts, request]), fail);
        };
        form.addEventListener("change", () => { if (input.files.length) checkFile(input.files[0]); });
        // Clear the field. Otherwise, no event would be fired if the reader changes the file and
        // chooses it again.
        input.addEventListener("click", () => { input.value = ""; });
        form.addEventListener("reset", () => show(""));
        form.hidden = false;
        return files => {
            if (files.length) input.files = files;
            checkFile(files[0]);
        };
    }

    /** @type {NodeListOf<HTMLFormElement>} */
    const forms = document.querySelectorAll("form[data-check]");
    const droppers = new Map([...forms].map(form => [form, activate(form)]));

    // Returns the vertical distance from `y` to a form, or 0 if `y` is between the form's top and
    // bottom.
    /** @param {HTMLFormElement} form @param {number} y */
    function findDistance(form, y) {
        const { top, bottom } = form.getBoundingClientRect();
        return Math.max(top - y, y - bottom, 0);
    }

    // A file that is dropped anywhere on the page goes to the nearest form. Otherwise the browser
    // would open the file in place of the page.
    addEventListener("dragover", event => event.preventDefault());
    addEventListener("drop", event => {
        event.preventDefault();
        const { clientY, dataTransfer: { files } } = event;
        const [nearest] = [...forms].sort((one, other) => findDistance(one, clientY) - findDistance(other, clientY));
        const isBeside = findDistance(nearest, clientY) > 0;
        if (isBeside && !files.length) return;
        droppers.get(nearest)(files);
        if (isBeside) nearest.scrollIntoView({ block: "center" });
    });
}
