"use strict";

// The modules, which are the code of the five crates: "live" draws the figures, "check" looks at the
// reader's picture, and "expressions" draws with a line that the reader edits. Each is compiled once its
// script is loaded.
const wasmModules = (() => {
    const resolvers = {}, modules = {}, instances = {};
    const load = name => modules[name] ??= new Promise((resolve, reject) => {
        if (!window.WebAssembly) throw new Error("This browser has no WebAssembly, or it is switched off.");
        resolvers[name] = resolve;
        const script = make("script", { src: `${path_to_root}generated/${name}-module.js` });
        script.onerror = () => reject(new Error("A part of this page did not load."));
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

// Puts the pixels of an answer on a canvas, from a column on.
function paint(canvas, { pixels, size: [width, height] }, column = 0) {
    canvas.getContext("2d").putImageData(new ImageData(pixels, width, height), -column, 0);
}
