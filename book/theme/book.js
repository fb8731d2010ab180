"use strict";

// An element with these attributes and children.
const make = (tag, attributes, ...children) => {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
};

// Writes a text, unless it is there already: then nothing is laid out anew for it.
const write = (element, text) => { if (element.textContent !== text) element.textContent = text; };

// Calls back, once for each element, when it comes near the view.
function whenNear(elements, near) {
    const observer = new IntersectionObserver(entries => {
        for (const { isIntersecting, target } of entries) {
            if (!isIntersecting) continue;
            observer.unobserve(target);
            near(target);
        }
    }, { rootMargin: "400px" });
    elements.forEach(element => observer.observe(element));
}

// What has come near stays laid out.
whenNear(document.querySelectorAll("main > *"), part => { part.style.contentVisibility = "visible"; });

// Theme: follow the system, or stay light, or stay dark.
{
    const themes = ["auto", "light", "dark"];
    const button = document.getElementById("theme-toggle");
    const root = document.documentElement;
    const show = theme => {
        root.dataset.theme = theme;
        button.title = `Theme: ${theme}`;
        button.setAttribute("aria-label", `Theme: ${theme}`);
    };
    show(themes.includes(root.dataset.theme) ? root.dataset.theme : "auto");
    button.addEventListener("click", () => {
        show(themes[(themes.indexOf(root.dataset.theme) + 1) % themes.length]);
        try { localStorage.setItem("theme", root.dataset.theme); } catch { /* private */ }
    });
}

// Contents: open and close on small screens, mark this chapter and list its sections.
{
    const contents = document.getElementById("contents");
    const toggle = document.getElementById("contents-toggle");
    const open = yes => {
        contents.classList.toggle("open", yes);
        toggle.setAttribute("aria-expanded", yes);
    };
    toggle.addEventListener("click", () => open(!contents.classList.contains("open")));
    contents.addEventListener("click", event => { if (event.target.closest("a")) open(false); });
    const links = [...contents.querySelectorAll("a")];
    const file = url => url.pathname.split("/").pop();
    const here = links.find(a => file(a) === file(location))
        ?? (["", "index.html"].includes(file(location)) ? links[0] : null);
    if (here) {
        here.setAttribute("aria-current", "page");
        const list = document.createElement("ol");
        list.className = "here";
        for (const heading of document.querySelectorAll("main h2[id]")) {
            const item = list.appendChild(document.createElement("li"));
            const link = item.appendChild(document.createElement("a"));
            link.href = `#${heading.id}`;
            link.append(...heading.cloneNode(true).querySelector("a.header").childNodes);
        }
        if (list.children.length) here.closest("li").append(list);
        // Once the page is laid out, as it will be anyway.
        requestAnimationFrame(() => {
            if (contents.scrollHeight > contents.clientHeight) here.scrollIntoView({ block: "center" });
        });
    }
}

// Loads a script, once.
const scripts = {};
const load = file => scripts[file] ??= new Promise(done => {
    const script = document.createElement("script");
    document.head.append(Object.assign(script, { src: path_to_root + file, async: false, onload: done, onerror: done }));
});

// Code: colours, when it comes near the view or is printed, and a button that copies a listing.
const isWhole = document.body.matches(".whole");
const colour = code => load("highlight.js").then(() => setTimeout(() => {
    // A line that is being edited stays as it is.
    if (!code.querySelector("[data-book]")) hljs.highlightBlock(code);
}));
function colours() {
    const codes = document.querySelectorAll("pre > code:is(.language-rust, .language-toml)");
    if (isWhole) codes.forEach(colour);
    else whenNear(codes, colour);
}
for (const code of document.querySelectorAll("pre > code[class^=language-]")) {
    const caption = code.closest(".listing")?.querySelector("figcaption");
    if (!caption) continue;
    const button = caption.appendChild(document.createElement("button"));
    button.type = "button";
    button.className = "copy";
    button.textContent = "Copy";
    button.setAttribute("aria-label", `Copy ${caption.querySelector(".path").textContent}`);
    button.addEventListener("click", async () => {
        try {
            const copy = code.cloneNode(true);
            for (const line of copy.querySelectorAll("[data-book]")) line.textContent = line.dataset.book;
            await navigator.clipboard.writeText(copy.textContent);
            button.textContent = "Copied";
        } catch {
            button.textContent = "Not copied";
        }
        setTimeout(() => { button.textContent = "Copy"; }, 1500);
    });
}

// Problems on paper: a number is right if it is within the tolerance, a part of the answer.
for (const problem of isWhole ? [] : document.querySelectorAll(".problem")) {
    const [answer, tolerance] = [problem.dataset.answer, problem.dataset.tolerance].map(Number);
    const form = document.createElement("form");
    const input = Object.assign(document.createElement("input"), { type: "number", step: "any", required: true });
    input.setAttribute("aria-label", `Your number for problem ${problem.querySelector(".number").textContent}`);
    input.placeholder = "your number";
    const button = Object.assign(document.createElement("button"), { textContent: "Check" });
    const verdict = document.createElement("output");
    form.append(input, button, verdict);
    form.addEventListener("submit", event => {
        event.preventDefault();
        const isRight = Math.abs(input.valueAsNumber - answer) <= tolerance * Math.abs(answer);
        verdict.textContent = isRight ? "right" : "not yet";
        verdict.classList.toggle("right", isRight);
    });
    input.addEventListener("input", () => { verdict.textContent = ""; });
    problem.insertBefore(form, problem.querySelector("details"));
}

// What may scroll sideways takes the focus, so that the keyboard can scroll it.
document.querySelectorAll("main :is(pre, .table-wrapper)").forEach(part => { part.tabIndex = 0; });

// The arrow keys turn to the chapters before and after.
addEventListener("keydown", event => {
    const busy = event.altKey || event.ctrlKey || event.metaKey || event.shiftKey || event.target !== document.body;
    if (busy) return;
    const rel = { ArrowLeft: "prev", ArrowRight: "next" }[event.key];
    const link = rel && document.querySelector(`.turn a[rel=${rel}]`);
    if (link) location.href = link.href;
});

// What a page can be read without comes once it is shown: colours, what answers, and the search.
requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(() => {
    colours();
    if (!isWhole) {
        load("theme/live.js");
        load("theme/line_editor.js");
    }
    load("theme/search.js");
})));
