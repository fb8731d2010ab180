"use strict";

// The WebAssembly modules, which contain the code of the five steps. "live" draws the figures,
// "check" checks the reader's picture, and "expressions" draws pictures with the lines that the
// reader has edited. "check" and "expressions" need the list of mistakes, which is a separate
// script.
{
    /** @type {Record<string, string>} */
    const files = {};
    /** @type {Record<string, Promise<Module>>} */
    const modules = {};

    /** @param {string} name */
    const loadFile = async name => {
        await book.load(`generated/${name}.js`, true);
        if (!files[name]) throw new Error("A part of this page did not load.");
        return Uint8Array.from(atob(files[name]), letter => letter.charCodeAt(0));
    };

    book.modules = {
        provide: (name, base64) => { files[name] = base64; },
        async compile(name) {
            if (!window.WebAssembly) throw new Error("This browser has no WebAssembly, or it is switched off.");
            const names = name === "live" ? ["live-module"] : [`${name}-module`, "mistakes"];
            const [bytes, mistakes] = await Promise.all(names.map(loadFile));
            return { module: await WebAssembly.compile(bytes), mistakes };
        },
        get: name => modules[name] ??= book.modules.compile(name).then(book.startModule),
        drop: name => { delete modules[name]; },
    };

    // A worker runs a copy of the source text of `Refusal`, `startModule` and `ask`, so these three
    // may use each other, but nothing else from the page's scripts.
    book.Refusal = class extends Error {};

    book.startModule = async ({ module, mistakes }) => {
        const { exports } = await WebAssembly.instantiate(module);
        const started = /** @type {any} */ (exports);
        if (mistakes) book.ask(started, { request: "mistakes" }, mistakes);
        return started;
    };

    book.ask = (module, request, file) => {
        /** @type {(bytes: Uint8Array, at: number) => void} */
        const copyIn = (bytes, at) => new Uint8Array(module.memory.buffer, at, bytes.length).set(bytes);
        const json = new TextEncoder().encode(JSON.stringify(request));
        copyIn(json, module.allocate_input(0, json.length));
        if (file) copyIn(file, module.allocate_input(1, file.length));
        const address = module.make_reply();
        const [text, letters, pixels, count] = new Uint32Array(module.memory.buffer, address, 4);
        /** @type {(at: number, length: number) => Uint8ClampedArray<ArrayBuffer>} */
        const copyOut = (at, length) => new Uint8ClampedArray(module.memory.buffer, at, length);
        const reply = JSON.parse(new TextDecoder().decode(copyOut(text, letters)));
        if (reply.error) throw new book.Refusal(reply.error);
        if (reply.size) reply.pixels = copyOut(pixels, count);
        return reply;
    };

    book.paint = (canvas, { pixels, size: [width, height] }, column = 0, columns = width) => {
        Object.assign(canvas, { width: columns, height });
        canvas.getContext("2d").putImageData(new ImageData(pixels, width, height), -column, 0);
    };
}
