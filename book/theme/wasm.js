"use strict";

// The modules, which are the code of the five crates: "live" draws the figures, "check" looks at the
// reader's picture, and "expressions" draws with a line that the reader edits. These two know the list of
// mistakes, which is a script of its own. Each is compiled once its script is loaded.
const wasmModules = (() => {
    const resolvers = {}, promises = {};
    // What is made once of a name; where that fails, the next request tries again.
    const once = (name, make) => promises[name] ??= make().catch(error => { delete promises[name]; throw error; });
    const loadFile = name => once(name, async () => {
        if (!window.WebAssembly) throw new Error("This browser has no WebAssembly, or it is switched off.");
        const base64 = await new Promise((resolve, reject) => {
            resolvers[name] = resolve;
            const script = make("script", { src: `${path_to_root}generated/${name}.js` });
            script.onerror = () => reject(new Error("A part of this page did not load."));
            document.head.append(script);
        });
        return Uint8Array.from(atob(base64), letter => letter.charCodeAt(0));
    });
    const load = name => once(`${name}, compiled`, async () => {
        const names = name === "live" ? ["live-module"] : [`${name}-module`, "mistakes"];
        const [bytes, mistakes] = await Promise.all(names.map(loadFile));
        return { module: await WebAssembly.compile(bytes), mistakes };
    });
    return {
        provide: (name, base64) => resolvers[name](base64),
        load,
        get: name => once(name, async () => startModule(await load(name))),
        drop: name => { delete promises[name]; },
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
    copyIn(words, module.live_room(0, words.length));
    if (file) copyIn(file, module.live_room(1, file.length));
    const address = module.live_answer();
    const [text, letters, pixels, count] = new Uint32Array(module.memory.buffer, address, 4);
    const copyOut = (at, length) => new Uint8ClampedArray(module.memory.buffer, at, length);
    const answer = JSON.parse(new TextDecoder().decode(copyOut(text, letters)));
    if (answer.size) answer.pixels = copyOut(pixels, count);
    return answer;
}

// Puts the pixels of an answer on a canvas, from a column on.
function paint(canvas, { pixels, size: [width, height] }, column = 0) {
    canvas.getContext("2d").putImageData(new ImageData(pixels, width, height), -column, 0);
}
