"use strict";

const root = document.documentElement;
root.classList.add("js");

// Under Trusted Types, what may be written into a page is what these scripts write, and what may be loaded is
// theirs. Where a server allows no policy, what needs one says so.
const ownAddresses = new Set();
let isOwnHTML = false;
try {
    window.trustedTypes?.createPolicy("default", {
        createHTML: text => isOwnHTML ? text : null,
        createScriptURL: address => ownAddresses.has(address) ? address : null,
    });
} catch { /* not allowed */ }

// Runs what writes HTML that is made here or by the modules.
function writeHTML(act) {
    isOwnHTML = true;
    try { act(); } finally { isOwnHTML = false; }
}

// An element with these attributes and children.
const make = (tag, attributes, ...children) => {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
};

// Writes a text, unless it is there already: then nothing is laid out anew for it.
const write = (element, text) => { if (element.textContent !== text) element.textContent = text; };

// Copies a text, if the browser lets a page do so, and says so on its button for a while.
async function copyBy(button, text, words = "Copied") {
    const label = button.dataset.label ??= button.textContent;
    const isCopied = await navigator.clipboard?.writeText(text).then(() => true, () => false);
    button.textContent = isCopied ? words : "Not copied";
    setTimeout(() => { button.textContent = label; }, 1500);
}

// A number as people type it: 58.72, 58,72, 1/2, −3 or 60°; NaN if it is none.
function readNumber(text) {
    const parts = text.replace(/[\s°]/g, "").replace(/−/g, "-").split("/").map(part => part.replace(",", "."));
    const numbers = parts.map(part => part ? Number(part) : NaN);
    return numbers.length < 3 ? numbers.reduce((numerator, denominator) => numerator / denominator) : NaN;
}

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
    const show = theme => {
        root.dataset.theme = theme;
        button.title = `Theme: ${theme}`;
        button.setAttribute("aria-label", button.title);
    };
    let kept = "auto";
    try { kept = localStorage.getItem("theme") ?? kept; } catch { /* private */ }
    show(themes.includes(kept) ? kept : "auto");
    button.addEventListener("click", () => {
        show(themes[(themes.indexOf(root.dataset.theme) + 1) % themes.length]);
        try { localStorage.setItem("theme", root.dataset.theme); } catch { /* private */ }
    });
}

// Contents: mark this chapter and list its sections, to one of which a click leads.
{
    const contents = document.getElementById("contents");
    contents.addEventListener("click", event => { if (event.target.closest("a")) contents.hidePopover(); });
    const links = [...contents.querySelectorAll("a")];
    // Some servers leave out what ends the name of a file.
    const name = url => url.pathname.split("/").pop().replace(/\.html$/, "");
    const here = links.find(a => name(a) === name(location)) ?? (["", "index"].includes(name(location)) ? links[0] : null);
    if (here) {
        here.setAttribute("aria-current", "page");
        const list = make("ol", { class: "here" });
        for (const heading of document.querySelectorAll("main h2[id]")) {
            const words = heading.cloneNode(true).querySelector("a.header").childNodes;
            list.append(make("li", {}, make("a", { href: `#${heading.id}` }, ...words)));
        }
        if (list.children.length) here.closest("li").append(list);
        // Once the page is laid out, as it will be anyway.
        requestAnimationFrame(() => {
            if (contents.scrollHeight > contents.clientHeight) here.scrollIntoView({ block: "center" });
        });
    }
}

// Loads a script, once, in turn with others unless it is large, and says whether it has come; one that failed is
// loaded again.
const scripts = {};
const load = (file, isLarge = false) => scripts[file] ??= new Promise(done => {
    const script = document.createElement("script");
    const address = root.dataset.root + file;
    const onload = () => done(true);
    const onerror = () => {
        delete scripts[file];
        done(false);
    };
    ownAddresses.add(address);
    try {
        document.head.append(Object.assign(script, { src: address, async: isLarge, onload, onerror }));
    } catch { // The server's policy doesn't let one script load another.
        onerror();
    }
});

// Says, once, that a page lacks scripts.
function sayMissing(file) {
    if (document.querySelector(".missing")) return;
    const words = `A part of this page did not load (${file}), so some of what moves, answers or is searched doesn't here. `
        + "Perhaps the server's Content-Security-Policy forbids it.";
    document.querySelector("main").prepend(make("p", { class: "missing refused", role: "status" }, words));
}

// Code: colours, when it comes near the view, and a button that copies a listing.
const isWhole = document.body.matches(".whole");
const colourCode = code => {
    try { writeHTML(() => window.hljs?.highlightBlock(code)); } catch { /* It stays without colours. */ }
};
const colour = code => load("highlight.js").then(isLoaded => isLoaded && setTimeout(() => {
    // A line that is being edited stays as it is, and one that has the focus keeps it.
    if (code.querySelector("[data-book]")) return;
    const name = code.querySelector(":focus")?.dataset.line;
    colourCode(code);
    code.querySelector(`[data-line="${name}"]`)?.focus({ preventScroll: true });
}));
for (const code of document.querySelectorAll("pre > code[class^=language-]")) {
    const caption = code.closest(".listing")?.querySelector("figcaption");
    if (!caption) continue;
    const label = `Copy ${caption.querySelector(".path").textContent}`;
    const button = caption.appendChild(make("button", { type: "button", class: "copy", "aria-label": label }, "Copy"));
    button.addEventListener("click", () => {
        const copy = code.cloneNode(true);
        const edited = copy.querySelectorAll("[data-book]");
        for (const line of edited) line.textContent = line.dataset.book;
        // The file's own line ends and blank lines, so that its parts can be put below each other.
        const lines = Number(caption.parentElement.style.getPropertyValue("--lines"));
        const ends = lines + 1 - copy.textContent.split("\n").length;
        const text = copy.textContent + "\n".repeat(Math.max(0, ends));
        copyBy(button, text, edited.length ? "Copied, without your lines" : "Copied");
    });
}

// Problems on paper: a number is right if it is within the tolerance, a part of the answer.
for (const problem of isWhole ? [] : document.querySelectorAll(".problem")) {
    const [answer, tolerance] = [problem.dataset.answer, problem.dataset.tolerance].map(Number);
    const number = problem.querySelector(".number").textContent;
    const input = make("input", { required: "", placeholder: "your number", autocomplete: "off", "aria-label": `Your number for problem ${number}` });
    const verdict = make("output", {});
    const form = make("form", {}, input, make("button", {}, "Check"), verdict);
    // A comma is a point, or parts the thousands.
    const judge = text => {
        const errors = [text, text.replace(/,(?=\d{3})/g, "")].map(one => readNumber(one) - answer).filter(Number.isFinite);
        const [error] = errors.sort((one, other) => Math.abs(one) - Math.abs(other));
        if (error === undefined) return "not a number";
        if (Math.abs(error) <= tolerance * Math.abs(answer)) return "right";
        return `${Math.abs(error) <= 0.05 * Math.abs(answer) ? "close, but " : ""}too ${error < 0 ? "small" : "large"}`;
    };
    form.addEventListener("submit", event => {
        event.preventDefault();
        verdict.textContent = judge(input.value);
        verdict.classList.toggle("right", verdict.textContent === "right");
    });
    input.addEventListener("input", () => { verdict.textContent = ""; });
    problem.insertBefore(form, problem.querySelector("details"));
}

// What may scroll sideways takes the focus, so that the keyboard can scroll it.
document.querySelectorAll("main :is(pre, .table-wrapper)").forEach(part => { part.tabIndex = 0; });

// A translator leaves code, formulas and labels as they are.
document.querySelectorAll("code, math, svg, .symbol, .path").forEach(part => part.setAttribute("translate", "no"));

// The scripts of what answers, and what on a page needs them; each is run after those before it.
const SCRIPTS = {
    wasm: "[data-live], [data-places]", handle: "figure[data-live]", own_scene: "figure[data-live=own_scene]",
    figure: "figure[data-live]", check_form: "form[data-live]", line_editor: "[data-places]",
};

const loadOrSay = file => load(file).then(isLoaded => isLoaded || sayMissing(file));

// What a page can be read without comes once it is shown: colours, what answers, and the search.
requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(() => {
    whenNear(document.querySelectorAll("pre > code:is(.language-rust, .language-toml)"), colour);
    for (const [name, selector] of Object.entries(isWhole ? {} : SCRIPTS)) {
        if (document.querySelector(selector)) loadOrSay(`theme/${name}.js`);
    }
    loadOrSay("theme/search.js");
})));
