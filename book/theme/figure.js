"use strict";

// Interactive figures. This script turns gestures into requests to the module "live", and shows the
// module's replies on the page. The module contains the code of the five steps, so nothing about
// rays is computed here.
{
    // While something moves, a picture may take FRAME milliseconds. A picture that takes longer is
    // drawn with fewer columns. Once nothing has moved for REST milliseconds, it is drawn with all
    // columns.
    const FRAME = 60, REST = 150;
    // The cover's image in the page's HTML has more than `about.columns` columns. At rest, the
    // cover's picture is drawn again with as many columns as this image, unless that would take
    // longer than LONGEST_REST_FRAME milliseconds.
    const LONGEST_REST_FRAME = 300;

    // In an address that chooses a pixel, this prefix precedes the pixel's column and row.
    const PIXEL = "#pixel=";

    /** @param {string} hash */
    const writeHash = hash => history.replaceState(null, "", hash || location.pathname + location.search);

    /** @implements {InteractiveFigure} */
    class Figure {
        /** @param {HTMLElement} root @param {Module} module @param {HTMLElement} controls @param {HTMLElement} fault */
        constructor(root, module, controls, fault) {
            this.root = root;
            this.module = module;
            this.controls = controls;
            this.fault = fault;
            this.isPreview = root.matches("[data-preview]");
            this.name = root.dataset.live ?? root.dataset.preview;
            // `showCallbacks` are called after each reply is shown, and `controlsCallbacks` each
            // time the controls are shown.
            /** @type {(() => void)[]} */
            this.showCallbacks = [];
            /** @type {(() => void)[]} */
            this.controlsCallbacks = [];
            // The pixel at which the probe was shown last, in the form used in addresses, such as
            // "470,120". It's null until the probe has been shown.
            /** @type {string | null} */
            this.pixel = null;
            // Whether the next pixel that is shown counts as the reader's choice, even if it's the
            // same pixel as before.
            this.isNextPixelChosen = false;
            /** @type {FigureAbout} */
            this.about = book.ask(module, { request: "about", figure: this.name });
            this.parameters = new Map(this.about.parameters.map(parameter => [parameter.id, parameter]));
            /** @type {ParameterValues} */
            this.defaults = Object.fromEntries(this.about.parameters.map(parameter => [parameter.id, parameter.default]));
            this.values = this.defaults;
            /** @type {FigureReply} */
            this.reply = book.ask(module, { request: "read", figure: this.name, values: this.values });
            this.findReadouts();
            this.makeStage();
            this.findControls();
            /** @type {Handle[]} */
            this.handles = this.about.handles.map((about, index) => new book.Handle(this, about, index));
            this.probe = this.handles.find(handle => handle.about.mark === "probe");
            if (this.isPreview && this.probe) this.handles = [this.probe];
            this.stage.append(...this.handles.map(handle => handle.element));
            if (this.probe) this.followPresses();
            this.show(this.reply);
            this.selectObject(this.handles[0]?.object);
            const first = this.handles.find(handle => handle !== this.probe);
            if (first && !this.about.colours) this.addCue(first.element);
            for (const kind of ["pointerdown", "keydown"]) {
                this.stage.addEventListener(kind, () => { root.dataset.touched = ""; }, { once: true });
            }
        }

        // Adds the word "drag" beside a handle. The word disappears once the figure is touched. If
        // possible, the word goes to a side where it covers no label and no other handle.
        /** @param {HTMLElement} handle */
        addCue(handle) {
            const cue = book.make("span", { "aria-hidden": true }, "drag");
            handle.append(cue);
            const stage = this.stage.getBoundingClientRect();
            const others = [...this.stage.querySelectorAll("text, .handle")].filter(part => part !== handle);
            const boxes = others.map(part => part.getBoundingClientRect());
            const isFree = () => {
                const { left, right, top, bottom } = cue.getBoundingClientRect();
                const covers = boxes.some(box => left < box.right && box.left < right && top < box.bottom && box.top < bottom);
                return stage.top <= top && right <= stage.right && !covers;
            };
            const sides = ["", "below", "left", "left below", "below far"];
            const isFreeAt = (/** @type {string} */ side) => {
                cue.className = `cue ${side}`;
                return isFree();
            };
            if (!sides.some(isFreeAt)) isFreeAt("");
        }

        // Makes the stage, which holds a drawing or a picture, with the handles on top. Until
        // something moves, the stage shows the drawing or picture from the page's HTML.
        makeStage() {
            /** @type {HTMLImageElement} */
            const initialImage = this.root.querySelector("svg, img");
            const size = ["width", "height"].map(side => Number(initialImage.getAttribute(side)));
            // On the cover, this divisor is less than 1, because the picture in the HTML has more
            // columns than are drawn while something moves.
            this.restDivisor = this.about.columns ? this.about.columns / size[0] : 1;
            this.size = size.map(side => side * this.restDivisor);
            this.stage = book.make("div", { class: "stage" });
            this.stage.style.aspectRatio = this.size.join(" / ");
            initialImage.replaceWith(this.stage);
            initialImage.draggable = false;
            this.stage.append(initialImage);
            this.initialImage = initialImage;
            /** @type {HTMLElement} */
            this.output = initialImage;
            // How many milliseconds it takes to draw the picture with all columns. This is a guess
            // until the picture has been drawn.
            this.fullDrawingTime = 2 * FRAME;
            // The shortest `fullDrawingTime` so far. It's the most reliable, because interruptions
            // can only make a time longer.
            this.leastDrawingTime = Infinity;
            this.restTimer = 0;
            this.addressTimer = 0;
            this.frame = 0;
        }

        // Finds the elements outside the figure whose contents depend on the figure's values.
        findReadouts() {
            const { name } = this;
            this.panel = /** @type {HTMLDetailsElement} */ (document.querySelector(`[data-panel="${name}"]`));
            /** @type {HTMLElement[]} */
            this.readouts = [];
            /** @type {Set<string> | null} */
            this.oldLines = null;
            /** @type {HTMLElement[]} */
            this.conditionalParts = [];
            if (this.isPreview) return;
            this.readouts = [...document.querySelectorAll(`[data-number^="${name}:"]`)];
            this.conditionalParts = [...document.querySelectorAll(`[data-when^="${name}:"]`)];
            this.code = document.querySelector(`[data-code="${name}"] code`);
            // The listing may be coloured later, when it is about to scroll into view. Colouring
            // replaces the listing's elements and loses the marks on its lines, so mark the lines
            // again.
            if (this.code) new MutationObserver(() => this.markChangedLines()).observe(this.code, { childList: true });
            this.companion = document.querySelector(`[data-companion="${name}"]`);
        }

        /** @param {string} id @param {number} value */
        setValue(id, value) {
            this.values = { ...this.values, [id]: value };
        }

        // Whether the figure can show anything with this value of a parameter.
        /** @param {string} id @param {number} value */
        canShow(id, value) {
            try {
                book.ask(this.module, { request: "read", figure: this.name, values: { ...this.values, [id]: value } });
                return true;
            } catch (error) {
                if (!(error instanceof book.Refusal)) throw error;
                return false;
            }
        }

        /** @param {Gesture} gesture */
        drawMoving(gesture) {
            this.draw(gesture, [1, 2].find(k => this.fullDrawingTime / k ** 2 <= FRAME) ?? 4);
        }

        // Draws in the next frame. If several gestures come before the next frame, only the last is
        // drawn.
        /** @param {Gesture} gesture */
        drawNextFrame(gesture) {
            cancelAnimationFrame(this.frame);
            this.frame = requestAnimationFrame(() => this.drawMoving(gesture));
        }

        // Finds the controls that the builder has written into the page. The control of a parameter
        // is a switch, a slider, a number field, or a slider with a number field.
        findControls() {
            /** @type {Map<string, Control>} */
            this.parameterControls = new Map();
            if (this.isPreview) return;
            this.objectSelect = /** @type {HTMLSelectElement} */ (this.controls.querySelector(".choice select"));
            this.objectSelect?.addEventListener("change", () => this.selectObject(this.objectSelect.value));
            this.reset = /** @type {HTMLButtonElement} */ (this.controls.querySelector(".reset"));
            for (const parameter of this.about.parameters) {
                const element = this.findControl(parameter.id) ?? this.copyControl(parameter);
                const inputs = [...element.querySelectorAll("input")];
                const control = { element, inputs, output: element.querySelector("b"), object: element.dataset.object };
                this.parameterControls.set(parameter.id, control);
            }
            // Call `followInput` only now, because it changes a control, and `copyControl` has to
            // copy unchanged controls.
            for (const parameter of this.about.parameters) {
                for (const input of this.controlOf(parameter.id).inputs) this.followInput(input, parameter);
            }
            this.reset.addEventListener("click", () => {
                this.values = this.defaults;
                if (this.probe) this.forgetPixel();
                this.draw();
            });
        }

        /** @param {string} id @returns {HTMLElement | null} */
        findControl(id) {
            return this.controls.querySelector(`[data-parameter="${id}"]`);
        }

        // Makes the control of a parameter by copying the control that another object has for the
        // parameter of the same name. In an editable scene, every sphere has the same parameters as
        // the other spheres, and every light has the same parameters as the other lights. So the
        // HTML contains the controls of only one sphere and one light.
        /** @param {ParameterAbout} parameter */
        copyControl({ id, object, name, min, max, step }) {
            const namesakes = this.about.parameters.filter(other => other.object && other.name === name);
            const model = namesakes.map(other => this.findControl(other.id)).find(Boolean);
            const copy = /** @type {HTMLElement} */ (model.cloneNode(true));
            Object.assign(copy.dataset, { parameter: id, object });
            for (const slider of copy.querySelectorAll("[type=range]")) Object.assign(slider, { min, max, step });
            (copy.matches(".switch") ? this.reset : this.fault).before(copy);
            return copy;
        }

        /** @param {string} id */
        controlOf(id) {
            return this.parameterControls.get(id);
        }

        /** @param {HTMLInputElement} input @param {ParameterAbout} parameter */
        followInput(input, { id, min, step }) {
            input.addEventListener("input", () => {
                const value = input.type === "checkbox" ? Number(input.checked) : book.readNumber(input.value);
                if (Number.isNaN(value)) return;
                this.setValue(id, value);
                this.drawNextFrame({ request: "show" });
            });
            // A finger that scrolls the page may first move a slider beneath the finger. Once the
            // browser treats the gesture as scrolling, restore the slider's value.
            let before = this.values[id];
            input.addEventListener("pointerdown", () => { before = this.values[id]; });
            input.addEventListener("pointercancel", () => {
                if (before === this.values[id]) return;
                this.setValue(id, before);
                this.drawNextFrame({ request: "show" });
            });
            // Turn a number field into a text field, which also accepts a decimal comma (58,72) and
            // a fraction (1/2). When the reader leaves the field, the nearest allowed number
            // replaces what was typed. The arrow keys still change the number by one step.
            if (input.type !== "number") return;
            input.type = "text";
            // A phone's keypad for decimal numbers has no minus sign.
            if (min >= 0) input.inputMode = "decimal";
            input.addEventListener("focus", () => input.select());
            input.addEventListener("change", () => { input.value = String(this.values[id]); });
            input.addEventListener("keydown", event => {
                const steps = { ArrowUp: 1, ArrowDown: -1 }[event.key];
                if (!steps) return;
                event.preventDefault();
                this.setValue(id, this.values[id] + steps * step);
                this.drawMoving({ request: "show" });
                input.value = String(this.values[id]);
            });
        }

        // In an editable scene, shows the controls of this object, and hides the controls of all
        // other objects.
        /** @param {string | undefined} object */
        selectObject(object) {
            if (!object) return;
            if (this.objectSelect) {
                this.objectSelect.value = object;
                this.showControls();
            }
            for (const handle of this.handles) handle.element.classList.toggle("chosen", handle.object === object);
        }

        showControls() {
            const { values, reply: { texts, visible } } = this;
            for (const [id, { element, inputs, output, object }] of this.parameterControls) {
                element.hidden = !visible[id] || object !== this.objectSelect?.value;
                for (const input of inputs) {
                    if (input.type === "checkbox") input.checked = values[id] === 1;
                    // Leave a number alone while it is being typed. If the figure can't show this
                    // number, say which number it shows instead.
                    else if (input.type === "range" || input !== document.activeElement) input.value = String(values[id]);
                    else if (Math.abs(book.readNumber(input.value) - values[id]) > 1e-9) book.setText(this.fault, `The figure shows ${texts[id]} instead.`);
                    if (input.type === "range") input.setAttribute("aria-valuetext", texts[id]);
                }
                if (output) book.setText(output, texts[id]);
            }
            for (const callback of this.controlsCallbacks) callback();
        }

        // Sends a request, and shows the reply. A picture has `about.columns / divisor` columns.
        // While something moves, `divisor` is 1, 2 or 4. At rest, it's 1 or `restDivisor`. If
        // there is nothing to show, the figure stays as it was.
        /** @param {Gesture} gesture */
        draw(gesture = { request: "show" }, divisor = 1) {
            const { name: figure, values, about } = this;
            const columns = about.columns && Math.round(about.columns / divisor);
            const start = performance.now();
            try {
                const reply = book.ask(this.module, { figure, values, columns, ...gesture });
                this.show(reply);
                if (!reply.size) return;
                clearTimeout(this.restTimer);
                this.fullDrawingTime = (performance.now() - start) * divisor ** 2;
                this.leastDrawingTime = Math.min(this.leastDrawingTime, this.fullDrawingTime);
                const isFast = this.leastDrawingTime / this.restDivisor ** 2 <= LONGEST_REST_FRAME;
                const next = divisor === 1 && isFast ? this.restDivisor : 1;
                if (divisor > next) this.restTimer = setTimeout(() => this.draw({ request: "show" }, next), REST);
            } catch (error) {
                this.values = this.reply.values;
                this.showControls();
                if (!(error instanceof book.Refusal)) throw error;
                // Only a typed number needs an explanation. A handle that can't move any further
                // just stays where it is.
                if (document.activeElement?.matches("input[type=text]")) this.fault.textContent = "There is nothing to show at that number.";
            }
        }

        /** @param {FigureReply} reply */
        show(reply) {
            this.values = reply.values;
            this.reply = reply;
            this.fault.textContent = "";
            this.showOutput(reply);
            this.showControls();
            this.handles.forEach(handle => handle.show());
            this.showReadouts(reply);
            if (this.reset) this.reset.disabled = this.about.parameters.every(({ id }) => this.values[id] === this.defaults[id]);
            for (const callback of this.showCallbacks) callback();
        }

        /** @param {() => void} callback */
        afterShow(callback) {
            this.showCallbacks.push(callback);
        }

        /** @param {() => void} callback */
        afterControls(callback) {
            this.controlsCallbacks.push(callback);
        }

        /** @param {FigureReply} reply */
        showOutput(reply) {
            if (reply.size) {
                if (this.output === this.initialImage) {
                    this.output = book.make("canvas", { role: "img", "aria-label": this.initialImage.alt });
                    this.initialImage.replaceWith(this.output);
                }
                book.paint(/** @type {HTMLCanvasElement} */ (this.output), reply);
            } else if (reply.drawing !== undefined) {
                book.writeHTML(() => { this.initialImage.querySelector("g").innerHTML = reply.drawing; });
            }
            if (!this.companion) return;
            const figure = this.companion.id.replace("figure-", "");
            const { drawing } = book.ask(this.module, { request: "show", figure, values: this.values, columns: null });
            book.writeHTML(() => { this.companion.querySelector("g").innerHTML = drawing; });
        }

        // Fills in the readouts. A readout without a value is left empty, and the text about the
        // readout is hidden.
        /** @param {FigureReply} reply */
        showReadouts({ readouts, program }) {
            /** @type {(key: string) => string} */
            const readoutOf = key => readouts[key.slice(this.name.length + 1)] ?? "";
            for (const element of this.readouts) book.setText(element, readoutOf(element.dataset.number));
            for (const part of this.conditionalParts) part.hidden = readoutOf(part.dataset.when) === "";
            if (this.probe) this.showPixel(readouts);
            if (this.code && this.code.textContent !== program) this.showProgram(program);
        }

        // Writes the scene's program into its listing.
        /** @param {string} program */
        showProgram(program) {
            this.oldLines = new Set(this.code.textContent.split("\n"));
            this.code.textContent = program;
            book.colourCode(this.code);
        }

        // Marks the lines that the last change has added to the program.
        markChangedLines() {
            if (!this.oldLines) return;
            const ranges = [];
            let from = 0;
            for (const line of this.code.textContent.split("\n")) {
                if (!this.oldLines.has(line)) ranges.push(book.makeRange(this.code, from, line.length));
                from += line.length + 1;
            }
            window.CSS.highlights?.set("changed", new Highlight(...ranges));
        }

        // Describes the probe's pixel in the line below the picture: what the pixel's ray meets,
        // and the pixel's colour. Until a pixel is chosen, this line contains the hint.
        /** @param {Record<string, string>} readouts */
        showPixel({ i, j, object, seen, bytes }) {
            this.probe.element.setAttribute("aria-valuetext", `column ${i}, row ${j}: ${seen}, colour ${bytes}`);
            const previous = this.pixel, isChosen = this.isNextPixelChosen || previous !== `${i},${j}`;
            this.pixel = `${i},${j}`;
            this.isNextPixelChosen = false;
            if (previous === null) return;
            const swatch = book.make("span", { class: "swatch" });
            swatch.style.background = `rgb${bytes}`;
            this.controls.querySelector(".hint").replaceChildren(book.make("b", {}, seen), " ", swatch, ` ${bytes} `, ...this.makeLinks());
            if (!this.panel) return;
            /** @type {NodeListOf<HTMLElement>} */
            const names = this.panel.querySelectorAll("[data-object]");
            if (!this.isPreview) for (const name of names) name.closest("tr").classList.toggle("hit", name.dataset.object === object);
            if (isChosen) this.followPixel();
        }

        // Makes a button that copies a link to the chosen pixel. In a preview, also makes a link to
        // the panel on the same page.
        makeLinks() {
            if (!this.panel) return [];
            this.copyLink ??= book.make("button", { type: "button", class: "copy" }, "Copy link");
            this.copyLink.onclick = () => {
                writeHash(PIXEL + this.pixel);
                book.copyAndReport(this.copyLink, location.href);
            };
            if (!this.isPreview) return [this.copyLink];
            return [book.make("a", { href: PIXEL + this.pixel }, "The whole sum"), " ", this.copyLink];
        }

        // Opens the panel, and writes the pixel into the address once the probe is at rest.
        followPixel() {
            if (!this.isPreview) this.openPanel(true);
            clearTimeout(this.addressTimer);
            this.addressTimer = setTimeout(() => writeHash(PIXEL + this.pixel), REST);
        }

        // After this call, the next pixel that is shown counts as the reader's choice, even if it's
        // the same pixel as before.
        treatNextPixelAsChosen() {
            this.isNextPixelChosen = true;
        }

        // Goes back to the default pixel, as if the reader had chosen none.
        forgetPixel() {
            const { horizontal, vertical } = this.probe.about;
            this.pixel = `${this.defaults[horizontal]},${this.defaults[vertical]}`;
            this.isNextPixelChosen = false;
            clearTimeout(this.addressTimer);
            if (location.hash.startsWith(PIXEL)) writeHash("");
        }

        // Opens or closes the panel. If the page has a margin, an open panel takes over the margin.
        /** @param {boolean} isOpen */
        openPanel(isOpen) {
            this.panel.open = isOpen;
            this.panel.classList.toggle("tool", isOpen);
        }

        // When the reader presses a point of the picture, moves the probe to that point.
        followPresses() {
            /** @type {HTMLButtonElement | null} */
            this.copyLink = null;
            if (this.panel && !this.isPreview) {
                this.panel.hidden = false;
                this.panel.addEventListener("toggle", () => this.openPanel(this.panel.open));
            }
            this.stage.classList.add("has-probe");
            let pressed = { clientX: 0, clientY: 0 };
            this.stage.addEventListener("pointerdown", event => { pressed = event; });
            this.stage.addEventListener("click", event => {
                const { target, clientX, clientY } = event;
                const isOnCross = target === this.probe.element;
                // Another handle may cover the pixel. If the pointer has moved, that handle was
                // dragged, so don't choose the pixel.
                const isDragged = Math.hypot(clientX - pressed.clientX, clientY - pressed.clientY) > 2;
                const isOnHandle = !isDragged && this.handles.some(({ element }) => element === target);
                if (target !== this.output && !isOnCross && !isOnHandle) return;
                this.treatNextPixelAsChosen();
                if (isOnCross) this.drawNextFrame({ request: "read" });
                else this.drawNextFrame({ request: "drag", handle: this.probe.index, position: this.positionOfPointer(event) });
                if (!isOnHandle) this.probe.element.focus({ preventScroll: true });
            });
        }

        // The position of a pointer in the coordinates of the figure.
        /** @param {{ clientX: number, clientY: number }} pointer @returns {[number, number]} */
        positionOfPointer({ clientX, clientY }) {
            const box = this.output.getBoundingClientRect();
            return [(clientX - box.left) / box.width * this.size[0], (clientY - box.top) / box.height * this.size[1]];
        }
    }

    // The figures that are interactive by now, keyed by their elements.
    /** @type {Map<Element, Figure>} */
    const figures = new Map();

    // An ordinary figure becomes interactive when it comes near the view. A preview becomes
    // interactive only when a reader points at it, presses it or focuses it. The module is loaded
    // only at that time. If loading fails, the page says why. The page waits five seconds, and then
    // tries again as soon as the figure is near the view.
    /** @param {HTMLElement} root */
    book.activateFigure = async root => {
        const controls = root.querySelector(".controls");
        const fault = controls.querySelector(".refused") ?? controls.appendChild(book.make("output", { class: "refused" }));
        try {
            const figure = new Figure(root, await book.modules.get("live"), controls, fault);
            fault.textContent = "";
            figures.set(root, figure);
            if (figure.probe && !figure.isPreview) movePixelOfAddress();
            if (figure.reply.address !== undefined) book.followScene(figure);
            controls.hidden = false;
            root.dataset.ready = "";
            if (figure.isPreview) beginPreview(figure);
        } catch (error) {
            fault.textContent = `This isn't interactive here. ${/** @type {Error} */ (error).message}`;
            book.modules.drop("live");
            if (!root.querySelector(".stage")) setTimeout(book.whenNear, 5000, [root], book.activateFigure);
        }
    };
    book.whenNear(document.querySelectorAll("figure:is([data-live], .woken)"), book.activateFigure);

    // Repeats the event that woke a preview (a press or a focus), now that the preview can react to
    // it.
    /** @param {Figure} figure */
    function beginPreview({ root, output, handles }) {
        if (root === document.activeElement) handles[0].element.focus({ preventScroll: true });
        root.removeAttribute("tabindex");
        const press = book.presses.get(root);
        if (press) output.dispatchEvent(new PointerEvent(press.type, press));
    }

    // Parses an address that names a pixel, such as #pixel=470,120. Returns the pixel's column and
    // row, and the element of the figure whose probe can show the pixel. Returns a falsy value if
    // the address names no pixel, or if there is no such figure.
    function findPixelOfAddress() {
        if (!location.hash.startsWith(PIXEL)) return null;
        const [, i, j] = location.hash.slice(PIXEL.length).match(/^(\d+)(?:,|%2C)(\d+)$/i) ?? [];
        const panel = i && document.querySelector("[data-panel]");
        const root = panel && document.querySelector(`figure[data-live="${panel.dataset.panel}"]`);
        return root && { root, i: Number(i), j: Number(j) };
    }

    // Moves the probe to the pixel in the address, if the probe's picture is already interactive.
    // Otherwise, `activateFigure` calls this function once the picture is interactive. Doesn't
    // scroll to the picture, because the reader may have scrolled elsewhere by then.
    function movePixelOfAddress() {
        const { root, i, j } = findPixelOfAddress() || {};
        const figure = figures.get(root);
        if (!figure) return;
        figure.setValue(figure.probe.about.horizontal, i);
        figure.setValue(figure.probe.about.vertical, j);
        figure.treatNextPixelAsChosen();
        figure.drawMoving({ request: "show" });
        figure.probe.element.focus({ preventScroll: true });
    }

    function openPixelOfAddress() {
        const pixel = findPixelOfAddress();
        if (!pixel) return;
        pixel.root.scrollIntoView({ block: "center" });
        movePixelOfAddress();
    }
    addEventListener("hashchange", openPixelOfAddress);
    // If the reader goes back while a pixel waits to be written, the pixel must not be written into
    // the address to which the reader has gone.
    addEventListener("popstate", () => figures.forEach(figure => clearTimeout(figure.addressTimer)));
    // If the address already names a pixel, a click on a link to the same pixel doesn't change the
    // address, so there is no hashchange event.
    addEventListener("click", event => {
        const target = /** @type {Element} */ (event.target);
        if (target.closest("a")?.hash === location.hash) openPixelOfAddress();
    });
    openPixelOfAddress();
}
