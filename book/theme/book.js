"use strict";

// Everything that all pages need: the theme, the contents, code and problems. It also loads the other scripts.

const root = document.documentElement;
root.classList.add("js");

// A policy for Trusted Types: only HTML that these scripts write may be put into a page, and only scripts that
// they name may be loaded. If the server doesn't allow the policy, the parts that need it report that.
const ownAddresses = new Set();
let isOwnHTML = false;
try {
    window.trustedTypes?.createPolicy("default", {
        createHTML: text => isOwnHTML ? text : null,
        createScriptURL: address => ownAddresses.has(address) ? address : null,
    });
} catch { /* not allowed */ }

// Runs `act`, which may write HTML that was made by these scripts or by the modules.
function writeHTML(act) {
    isOwnHTML = true;
    try { act(); } finally { isOwnHTML = false; }
}

// Creates an element with these attributes and children.
const make = (tag, attributes, ...children) => {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
};

// Sets the text of an element, unless it is the same already, so that nothing is laid out again for nothing.
const write = (element, text) => { if (element.textContent !== text) element.textContent = text; };

// Copies a text, if the browser allows it, and shows the result on the button for a moment.
async function copyBy(button, text, words = "Copied") {
    const label = button.dataset.label ??= button.textContent;
    const isCopied = await navigator.clipboard?.writeText(text).then(() => true, () => false);
    button.textContent = isCopied ? words : "Not copied";
    setTimeout(() => { button.textContent = label; }, 1500);
}

// Parses a number as people type it, such as 58.72, 58,72, 1/2, −3 or 60°. Returns NaN if it isn't a number.
function readNumber(text) {
    const parts = text.replace(/[\s°]/g, "").replace(/−/g, "-").split("/").map(part => part.replace(",", "."));
    const numbers = parts.map(part => part ? Number(part) : NaN);
    return numbers.length < 3 ? numbers.reduce((numerator, denominator) => numerator / denominator) : NaN;
}

// Calls `near` once for each element, when it comes near the view.
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

// Parts of the page are laid out when they come near the view, and stay so.
whenNear(document.querySelectorAll("main > *"), part => { part.style.contentVisibility = "visible"; });

// The theme: it follows the system, or it stays light or dark.
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

// The contents: mark this chapter, and list links to its sections.
{
    const contents = document.getElementById("contents");
    contents.addEventListener("click", event => { if (event.target.closest("a")) contents.hidePopover(); });
    const links = [...contents.querySelectorAll("a")];
    // Some servers leave out `.html`.
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
        // Wait until the page has been laid out, so that asking for heights costs nothing.
        requestAnimationFrame(() => {
            if (contents.scrollHeight > contents.clientHeight) here.scrollIntoView({ block: "center" });
        });
    }
}

// Loads a script once, and returns whether that succeeded. Scripts run in the order of the calls, except large
// ones, which run as soon as they arrive. A script that failed to load is loaded again by the next call.
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

// Puts a message at the top of the page that a script is missing, but only one message.
function sayMissing(file) {
    if (document.querySelector(".missing")) return;
    const words = `A part of this page did not load (${file}), so some figures, forms or the search don't work here. `
        + "Perhaps the server's Content-Security-Policy forbids it.";
    document.querySelector("main").prepend(make("p", { class: "missing refused", role: "status" }, words));
}

// Code: colour it when it comes near the view, and give each listing a button that copies it.
const isWhole = document.body.matches(".whole");
const colourCode = code => {
    try { writeHTML(() => window.hljs?.highlightBlock(code)); } catch { /* The code stays without colours. */ }
};
const colour = code => load("highlight.js").then(isLoaded => isLoaded && setTimeout(() => {
    // Leave listings with an edited line alone. A line that has the focus keeps it.
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
        // Add the blank lines that the file has at the end of this part, so that its parts can be pasted one below
        // the other.
        const lines = Number(caption.parentElement.style.getPropertyValue("--lines"));
        const ends = lines + 1 - copy.textContent.split("\n").length;
        const text = copy.textContent + "\n".repeat(Math.max(0, ends));
        copyBy(button, text, edited.length ? "Copied, without your lines" : "Copied");
    });
}

// Problems on paper: a number is right if its error is at most the tolerance, which is relative to the answer.
for (const problem of isWhole ? [] : document.querySelectorAll(".problem")) {
    const [answer, tolerance] = [problem.dataset.answer, problem.dataset.tolerance].map(Number);
    const number = problem.querySelector(".number").textContent;
    const input = make("input", { required: "", placeholder: "your number", autocomplete: "off", "aria-label": `Your number for problem ${number}` });
    const verdict = make("output", {});
    const form = make("form", {}, input, make("button", {}, "Check"), verdict);
    // Try a comma as the decimal point and as the separator of thousands, and judge the closer number.
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

// Let everything that may scroll sideways take the focus, so that the keyboard can scroll it.
document.querySelectorAll("main :is(pre, .table-wrapper)").forEach(part => { part.tabIndex = 0; });

// Keep translation by the browser away from code, formulas and labels.
document.querySelectorAll("code, math, svg, .symbol, .path").forEach(part => part.setAttribute("translate", "no"));

// The scripts of the interactive parts, each with the selector of the elements that need it. They run in this order.
const SCRIPTS = {
    wasm: "[data-live], [data-places]", handle: "figure[data-live]", own_scene: "figure[data-live=own_scene]",
    figure: "figure[data-live]", check_form: "form[data-live]", line_editor: "[data-places]",
};

const loadOrSay = file => load(file).then(isLoaded => isLoaded || sayMissing(file));

// Once the page is shown, load everything that it can be read without: colours, interactive parts and the search.
requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(() => {
    whenNear(document.querySelectorAll("pre > code:is(.language-rust, .language-toml)"), colour);
    for (const [name, selector] of Object.entries(isWhole ? {} : SCRIPTS)) {
        if (document.querySelector(selector)) loadOrSay(`theme/${name}.js`);
    }
    loadOrSay("theme/search.js");
})));
