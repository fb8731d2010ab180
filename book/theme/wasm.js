"use strict";

// The modules, which are the code of the five crates: "live" draws the figures, "check" looks at the
// reader's picture, and "expressions" draws with a line that the reader edits. These two know the list of
// mistakes, which is a script of its own.
const wasmModules = (() => {
    const files = {}, modules = {};
    const loadFile = async name => {
        await load(`generated/${name}.js`, true);
        if (!files[name]) throw new Error("A part of this page did not load.");
        return Uint8Array.from(atob(files[name]), letter => letter.charCodeAt(0));
    };
    const compile = async name => {
        if (!window.WebAssembly) throw new Error("This browser has no WebAssembly, or it is switched off.");
        const names = name === "live" ? ["live-module"] : [`${name}-module`, "mistakes"];
        const [bytes, mistakes] = await Promise.all(names.map(loadFile));
        return { module: await WebAssembly.compile(bytes), mistakes };
    };
    return {
        provide: (name, base64) => { files[name] = base64; },
        compile,
        get: name => modules[name] ??= compile(name).then(startModule),
        // One that failed would fail again: the next request starts it anew.
        drop: name => { delete modules[name]; },
    };
})();

// The exports of a module that is started, which has got the list of mistakes if it knows them.
async function startModule({ module, mistakes }) {
    const { exports } = await WebAssembly.instantiate(module);
    if (mistakes) ask(exports, "mistakes", mistakes);
    return exports;
}

// The answer of a module to a request, about a file if there is one; with pixels if it has a picture.
function ask(module, request, file) {
    const copyIn = (bytes, at) => new Uint8Array(module.memory.buffer, at, bytes.length).set(bytes);
    const words = new TextEncoder().encode(request);
    copyIn(words, module.make_room(0, words.length));
    if (file) copyIn(file, module.make_room(1, file.length));
    const address = module.make_answer();
    const [text, letters, pixels, count] = new Uint32Array(module.memory.buffer, address, 4);
    const copyOut = (at, length) => new Uint8ClampedArray(module.memory.buffer, at, length);
    const answer = JSON.parse(new TextDecoder().decode(copyOut(text, letters)));
    if (answer.size) answer.pixels = copyOut(pixels, count);
    return answer;
}

// Puts the pixels of an answer on a canvas: all, or so many columns from one on.
function paint(canvas, { pixels, size: [width, height] }, column = 0, columns = width) {
    Object.assign(canvas, { width: columns, height });
    canvas.getContext("2d").putImageData(new ImageData(pixels, width, height), -column, 0);
}
