"use strict";

// The handles of a figure.
{
    /** @type {Record<string, ["horizontal" | "vertical", number]>} */
    const ARROW_KEYS = {
        ArrowLeft: ["horizontal", -1], ArrowRight: ["horizontal", 1], ArrowDown: ["vertical", -1], ArrowUp: ["vertical", 1],
    };

    // A handle is a slider that follows the pointer, a finger and the arrow keys. `index` is the
    // handle's index in the figure's list of handles.
    book.Handle = class {
        /** @param {InteractiveFigure} figure @param {HandleAbout} about @param {number} index */
        constructor(figure, about, index) {
            const { min, max } = figure.parameters.get(about.horizontal);
            this.figure = figure;
            this.about = about;
            this.index = index;
            // In an editable scene, a handle's label is the name of the object to move.
            this.object = figure.about.colours ? about.label : undefined;
            /** @type {[number, number] | null} */
            this.position = null;
            // The vector from the pointer to the handle. It stays the same during a drag, so that
            // the handle doesn't jump to the pointer.
            this.offset = [0, 0];
            this.element = book.make("span", {
                class: `handle handle-${about.mark}`, role: "slider", tabindex: 0, "aria-label": about.label, title: about.label,
                "aria-valuemin": min, "aria-valuemax": max,
            });
            this.element.addEventListener("focus", () => figure.selectObject(this.object));
            this.element.addEventListener("pointerdown", event => this.grab(event));
            this.element.addEventListener("pointermove", event => this.drag(event));
            this.element.addEventListener("keydown", event => this.pressKey(event));
        }

        /** @param {PointerEvent} event */
        grab(event) {
            if (event.button !== 0 || event.ctrlKey) return;
            this.element.setPointerCapture(event.pointerId);
            this.element.focus({ preventScroll: true });
            const [x, y] = this.figure.positionOfPointer(event);
            this.offset = [this.position[0] - x, this.position[1] - y];
        }

        /** @param {PointerEvent} event */
        drag(event) {
            if (!this.element.hasPointerCapture(event.pointerId)) return;
            if (event.shiftKey && this.about.depth) return this.changeDepth(event.movementY);
            const [x, y] = this.figure.positionOfPointer(event);
            this.figure.drawNextFrame({ request: "drag", handle: this.index, position: [x + this.offset[0], y + this.offset[1]] });
        }

        // Moves the handle's object towards the reader or away from the reader.
        /** @param {number} length in screen pixels */
        changeDepth(length) {
            const { depth } = this.about;
            this.figure.setValue(depth, this.figure.values[depth] + length / 30);
            this.figure.drawNextFrame({ request: "show" });
        }

        /** @param {KeyboardEvent} event */
        pressKey(event) {
            if (event.altKey || event.ctrlKey || event.metaKey) return;
            const isEnd = event.key === "Home" || event.key === "End";
            const [direction, sign] = ARROW_KEYS[event.key] ?? [];
            if (!direction && !isEnd) return;
            event.preventDefault();
            if (isEnd) return this.moveToEnd(event.key === "Home" ? "min" : "max");
            const { id, step, axis } = this.figure.parameters.get(this.about[direction]);
            const isReversed = direction === "vertical" && axis === "down";
            const steps = (event.shiftKey ? 10 : 1) * sign * (isReversed ? -1 : 1);
            this.figure.setValue(id, this.figure.values[id] + steps * step);
            // Don't wait for the next frame: keys may repeat faster than frames are drawn, and no
            // key press should be lost. Moving a probe doesn't change the picture, so request only
            // the numbers.
            this.figure.drawMoving({ request: this === this.figure.probe ? "read" : "show" });
        }

        // Moves the handle to an end of its range. If the figure has nothing to show at that end,
        // moves the handle as close to the end as possible.
        /** @param {"min" | "max"} end */
        moveToEnd(end) {
            const { figure, about: { horizontal } } = this;
            const { step, [end]: limit } = figure.parameters.get(horizontal);
            let value = figure.values[horizontal];
            for (let distance = limit - value; Math.abs(distance) >= step; distance /= 2) {
                while (Math.abs(limit - value) >= Math.abs(distance) && figure.canShow(horizontal, value + distance)) value += distance;
            }
            figure.setValue(horizontal, value);
            figure.drawMoving({ request: this === figure.probe ? "read" : "show" });
        }

        // Puts the handle at its position in the last reply.
        show() {
            const { figure, element, about } = this;
            const { values, reply: { positions, texts }, size } = figure;
            this.position = positions[this.index];
            // A handle's values are rounded to steps, so a handle at the border of the figure may
            // be a little outside the figure.
            const isInside = this.position?.every((x, k) => -4 <= x && x <= size[k] + 4) ?? false;
            const isLost = !isInside && element === document.activeElement;
            element.hidden = !isInside;
            if (isLost) figure.controlOf(about.horizontal)?.inputs[0].focus();
            const [left, top] = [0, 1].map(k => `${(this.position?.[k] ?? 0) / size[k] * 100}%`);
            Object.assign(element.style, { left, top });
            element.setAttribute("aria-valuenow", String(values[about.horizontal]));
            const ids = [...new Set([about.horizontal, about.vertical])];
            element.setAttribute("aria-valuetext", ids.map(id => texts[id]).join(", "));
        }
    };
}
