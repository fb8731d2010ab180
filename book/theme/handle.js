"use strict";

// A handle of a figure, its number k: a slider that follows pointer, finger and arrow keys.
function makeHandle(figure, about, k) {
    // Each of its parameters has a control, too.
    const parameters = [...new Set(about.parameters)];
    const fields = about.parameters.map(parameter => figure.parameterControls[parameter].inputs[0]);
    const { group } = figure.parameterControls[parameters[0]];
    const handle = make("span", {
        class: `handle handle-${about.mark}`, role: "slider", tabindex: 0, "aria-label": about.words, title: about.words,
        "aria-valuemin": fields[0].min, "aria-valuemax": fields[0].max,
    });
    Object.assign(handle, { about, group });
    handle.addEventListener("focus", () => figure.selectGroup(group));

    // What is dragged keeps its distance from the pointer.
    let offset;
    handle.grab = event => {
        if (event.button !== 0 || event.ctrlKey) return;
        handle.setPointerCapture(event.pointerId);
        handle.focus({ preventScroll: true });
        const [x, y] = figure.placeOfPointer(event);
        offset = [handle.place[0] - x, handle.place[1] - y];
    };
    handle.addEventListener("pointerdown", handle.grab);
    // Where handles have groups, z follows x and y.
    handle.changeDepth = length => {
        const z = about.parameters[1] + 1;
        figure.setValue(z, figure.values[z] + length / 30);
        figure.drawNextFrame("show");
    };
    handle.addEventListener("pointermove", event => {
        if (!handle.hasPointerCapture(event.pointerId)) return;
        if (event.shiftKey && group) return void handle.changeDepth(event.movementY);
        const [x, y] = figure.placeOfPointer(event);
        figure.drawNextFrame("drag", k, x + offset[0], y + offset[1]);
    });
    handle.addEventListener("keydown", event => {
        const [axis, sign] = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowDown: [1, -1], ArrowUp: [1, 1] }[event.key] ?? [];
        if (!sign || event.altKey || event.ctrlKey || event.metaKey) return;
        event.preventDefault();
        const steps = (event.shiftKey ? 10 : 1) * sign * (axis && about.down ? -1 : 1);
        const parameter = about.parameters[axis];
        figure.setValue(parameter, figure.values[parameter] + steps * fields[axis].step);
        // Keys follow each other faster than frames: none is lost. A probe leaves the picture as it is.
        figure.drawMoving(handle === figure.probe ? "tell" : "show");
    });

    // Rounded to its step, a handle at the border may be a little outside.
    const isInside = place => place?.every((x, k) => -4 <= x && x <= figure.size[k] + 4) ?? false;
    // Puts the handle where the last answer has it.
    handle.show = () => {
        const { values, answer: { places, texts }, size } = figure;
        handle.place = places[k];
        const isLost = !isInside(handle.place) && handle === document.activeElement;
        handle.hidden = !isInside(handle.place);
        if (isLost) fields[0].focus();
        for (const [k, side] of ["left", "top"].entries()) handle.style[side] = `${(handle.place?.[k] ?? 0) / size[k] * 100}%`;
        handle.setAttribute("aria-valuenow", values[parameters[0]]);
        handle.setAttribute("aria-valuetext", parameters.map(parameter => texts[parameter]).join(", "));
    };
    return handle;
}
