"use strict";

// Figures and pictures that answer. Gestures become requests to the module, which is the code of the
// five crates; its answers are put in place. Nothing about rays is computed here.

// Milliseconds that a picture may take while something moves: a slower one is drawn coarser then, and
// whole after a rest.
const FRAME = 60, REST = 150;

// What the module says of a request to which it has no answer.
class Refusal extends Error {}

class Figure {
    constructor(root, module, controls, fault) {
        Object.assign(this, { root, module, controls, fault, name: root.dataset.live });
        this.about = this.ask("about");
        this.values = this.about.values;
        this.answer = this.ask("tell", ...this.values);
        this.findTexts();
        this.makeStage();
        this.findControls();
        this.handles = this.about.handles.map((about, k) => makeHandle(this, about, k));
        this.stage.append(...this.handles);
        this.probe = this.handles.find(handle => handle.about.mark === "probe");
        if (this.probe) this.askWherePressed();
        this.show(this.answer);
        this.selectGroup(this.handles[0]?.group);
    }

    // The answer of the module to a request; it throws a refusal of one to which there is none.
    ask(verb, ...words) {
        const answer = ask(this.module, [verb, this.name, ...words].join(" "));
        if (answer.error) throw new Refusal(answer.error);
        return answer;
    }

    // The stage: the drawing or the picture, and above it the handles. What is printed stays until
    // something moves.
    makeStage() {
        const printed = this.root.querySelector("svg, img");
        this.size = ["width", "height"].map(side => Number(printed.getAttribute(side)));
        this.stage = make("div", { class: "stage" });
        this.stage.style.aspectRatio = this.size.join(" / ");
        printed.replaceWith(this.stage);
        printed.draggable = false;
        this.stage.append(printed);
        Object.assign(this, { printed, output: printed, wholeTime: 0, restTimer: 0, frame: 0 });
    }

    // What stands elsewhere on the page and depends on the values.
    findTexts() {
        const { name } = this;
        this.numbers = [...document.querySelectorAll(`[data-number^="${name}:"]`)];
        this.conditionalParts = [...document.querySelectorAll(`[data-when^="${name}:"]`)];
        this.panel = document.querySelector(`[data-panel="${name}"]`);
        this.code = document.querySelector(`[data-code="${name}"] code`);
        this.companion = document.querySelector(`[data-companion="${name}"]`);
    }

    // These values with another one at an index.
    setValue(index, value) {
        this.values = this.values.map((old, k) => k === index ? value : old);
    }

    drawMoving(...words) {
        this.draw(words, [1, 2].find(k => this.wholeTime / k ** 2 <= FRAME) ?? 4);
    }

    // Only the last gesture before a frame counts.
    drawNextFrame(...words) {
        cancelAnimationFrame(this.frame);
        this.frame = requestAnimationFrame(() => this.drawMoving(...words));
    }

    // The controls are printed: for a parameter a range or a switch, and a field for a number.
    findControls() {
        this.parameterControls = this.values.map((_, k) => {
            const element = this.controls.querySelector(`[data-parameter="${k}"]`);
            if (!element) return null;
            const inputs = [...element.querySelectorAll("input")];
            inputs.forEach(input => this.followInput(input, k));
            return { element, inputs, output: element.querySelector("b"), group: element.dataset.group };
        });
        this.groupSelect = this.controls.querySelector(".choice select");
        this.groupSelect?.addEventListener("change", () => this.selectGroup(this.groupSelect.value));
        this.reset = this.controls.querySelector(".reset");
        this.reset.addEventListener("click", () => { this.values = this.about.values; this.draw(); });
    }

    followInput(input, k) {
        input.addEventListener("input", () => {
            const value = input.type === "checkbox" ? Number(input.checked) : readNumber(input.value);
            if (Number.isNaN(value)) return;
            this.setValue(k, value);
            this.drawNextFrame("show");
        });
        // A field of text takes 58,72 and 1/2, too. What was typed gives way to the allowed number that is
        // nearest, and arrow keys step as in a field of numbers.
        if (input.type !== "number") return;
        input.type = "text";
        input.addEventListener("change", () => { input.value = this.values[k]; });
        input.addEventListener("keydown", event => {
            const steps = { ArrowUp: 1, ArrowDown: -1 }[event.key];
            if (!steps) return;
            event.preventDefault();
            this.setValue(k, this.values[k] + steps * Number(input.step));
            this.drawMoving("show");
            input.value = this.values[k];
        });
    }

    // Where parameters have groups, the controls of one are visible: of what was touched last.
    selectGroup(group) {
        if (!group) return;
        this.groupSelect.value = group;
        this.showControls();
        this.handles.forEach(handle => handle.classList.toggle("chosen", handle.group === group));
    }

    showControls() {
        const { values, answer: { texts, visible } } = this;
        this.parameterControls.forEach((control, k) => {
            if (!control) return;
            const { element, inputs, output, group } = control;
            element.hidden = !visible[k] || group !== this.groupSelect?.value;
            for (const input of inputs) {
                if (input.type === "checkbox") input.checked = values[k] === 1;
                // What is being typed stays as it is.
                else if (input.type === "range" || input !== document.activeElement) input.value = values[k];
                if (input.type === "range") input.setAttribute("aria-valuetext", texts[k]);
            }
            if (output) write(output, texts[k]);
        });
        this.afterControls?.();
    }

    // Puts the answer to a request in place: a picture has all its columns, or, while something moves, a
    // half or a quarter. Where there is nothing to show, the last one stays, and the page says so.
    draw(words = ["show"], divisor = 1) {
        const { columns, values } = this.about;
        const sent = this.values.map((value, k) => k === columns ? values[k] / divisor : value);
        const start = performance.now();
        try {
            const answer = this.ask(...words, ...sent);
            this.show(answer);
            if (!answer.size) return;
            clearTimeout(this.restTimer);
            this.wholeTime = (performance.now() - start) * divisor ** 2;
            if (1 < divisor) this.restTimer = setTimeout(() => this.draw(), REST);
        } catch (error) {
            this.values = this.answer.values;
            this.showControls();
            if (!(error instanceof Refusal)) throw error;
            this.fault.textContent = "There is nothing to show at that number.";
        }
    }

    show(answer) {
        // The columns of a coarse picture are not the reader's.
        const { columns, values } = this.about;
        this.values = answer.values.map((value, k) => k === columns ? values[k] : value);
        this.answer = { ...answer, values: this.values };
        this.fault.textContent = "";
        this.showOutput(answer);
        this.showControls();
        this.handles.forEach(handle => handle.show());
        this.showTexts(answer.numbers);
        this.reset.disabled = this.values.every((value, k) => value === values[k]);
        this.afterShow?.();
    }

    showOutput({ size, pixels, drawing }) {
        if (size) {
            if (this.output === this.printed) {
                this.output = make("canvas", { role: "img", "aria-label": this.printed.alt });
                this.printed.replaceWith(this.output);
            }
            paint(this.output, { pixels, size });
        } else if (drawing !== undefined) {
            writeHTML(() => { this.printed.querySelector("g").innerHTML = drawing; });
        }
        if (!this.companion) return;
        const name = this.companion.id.replace("figure-", "");
        const companion = ask(this.module, `show ${name} ${this.values.join(" ")}`).drawing;
        writeHTML(() => { this.companion.querySelector("g").innerHTML = companion; });
    }

    // A number that there is not here is left empty, and what speaks of it is hidden.
    showTexts(numbers) {
        const numberOf = key => numbers[key.slice(this.name.length + 1)] ?? "";
        for (const number of this.numbers) write(number, numberOf(number.dataset.number));
        for (const part of this.conditionalParts) part.hidden = numberOf(part.dataset.when) === "";
        if (this.probe) this.showPixel(numbers);
        if (this.code && this.code.textContent !== numbers.rust) {
            this.code.textContent = numbers.rust;
            colourCode(this.code);
        }
    }

    // The line below the picture: what the ray of the probe's pixel meets, and its colour. Until a pixel is
    // asked, the hint stands there.
    showPixel({ i, j, object, object0 = object, t, t0 = t, bytes }) {
        const met = t0 ? `${object0}, t = ${t0}` : "sky";
        this.probe.setAttribute("aria-valuetext", `column ${i}, row ${j}: ${met}, colour ${bytes}`);
        for (const row of this.panel.querySelectorAll("tr")) row.classList.toggle("hit", row.cells[0].textContent === object);
        if (this.isAsked) {
            const swatch = make("span", { class: "swatch" });
            swatch.style.background = `rgb${bytes}`;
            this.controls.querySelector(".hint").replaceChildren(make("b", {}, met), " ", swatch, ` ${bytes}`);
        }
        this.isAsked = true;
    }

    // The probe goes where the picture is pressed.
    askWherePressed() {
        const isWide = matchMedia("(min-width: 1500px)").matches;
        if (isWide) this.root.append(this.panel);
        Object.assign(this.panel, { hidden: false, open: isWide });
        this.stage.classList.add("has-probe");
        this.stage.addEventListener("click", event => {
            if (event.target !== this.output) return;
            this.drawNextFrame("drag", this.handles.indexOf(this.probe), ...this.placeOfPointer(event));
            this.probe.focus({ preventScroll: true });
        });
    }

    // The place of a pointer in the coordinates of the output.
    placeOfPointer({ clientX, clientY }) {
        const box = this.output.getBoundingClientRect();
        return [(clientX - box.left) / box.width * this.size[0], (clientY - box.top) / box.height * this.size[1]];
    }
}

// A figure answers from when it comes near the view: only then is the module loaded. Where that fails,
// the page says why, and it is tried again while the figure is near.
async function activateFigure(root) {
    const controls = root.querySelector(".controls");
    const fault = controls.querySelector(".refused") ?? controls.appendChild(make("output", { class: "refused" }));
    try {
        const figure = new Figure(root, await wasmModules.get("live"), controls, fault);
        fault.textContent = "";
        root.figure = figure;
        if (figure.probe) openPixel({ isLate: true });
        if (figure.answer.numbers.address !== undefined) followScene(figure);
        Object.assign(controls, { hidden: false, inert: false });
        root.dataset.ready = "";
    } catch (error) {
        fault.textContent = `This doesn't answer here. ${error.message}`;
        wasmModules.drop("live");
        if (!root.querySelector(".stage")) setTimeout(whenNear, 5000, [root], activateFigure);
    }
}
whenNear(document.querySelectorAll("figure[data-live]"), activateFigure);

// A link that names a pixel, such as #pixel=470,120, brings the picture near whose pixels can be asked;
// once it answers, the pixel is, wherever the reader has gone meanwhile.
function openPixel({ isLate }) {
    const [, ...place] = location.hash.match(/^#pixel=(\d+)(?:,|%2C)(\d+)$/i) ?? [];
    const panel = place.length && document.querySelector("[data-panel]");
    const root = panel && document.querySelector(`figure[data-live="${panel.dataset.panel}"]`);
    if (!root) return;
    if (!isLate) root.scrollIntoView({ block: "center" });
    if (!root.figure) return;
    const { figure } = root;
    figure.probe.about.parameters.forEach((parameter, k) => figure.setValue(parameter, Number(place[k])));
    figure.drawMoving("show");
    figure.probe.focus({ preventScroll: true });
}
addEventListener("hashchange", openPixel);
// The same link once more, which leaves the address as it is.
addEventListener("click", ({ target }) => target.closest("a")?.hash === location.hash && openPixel({}));
openPixel({});
