"use strict";

// The search asks whether a key that is pressed belongs to something else on the page.
function mdbook_something_else_has_focus(event) {
    return /^(input|select|textarea)$/i.test(event.target.nodeName);
}

// Fetches a script when it is needed first.
const fetched = {};
const script = source => fetched[source] ??= new Promise((done, failed) => {
    const element = document.createElement("script");
    Object.assign(element, { src: source, onload: done, onerror: failed });
    document.head.append(element);
});

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

// Search: fetched when it is asked for, or when a link comes from its answers.
{
    const button = document.getElementById("mdbook-search-toggle");
    const box = document.getElementById("mdbook-search-wrapper");
    const words = document.getElementById("mdbook-searchbar");
    const fetchAll = async () => { for (const source of searchers) await script(source); };
    const ask = async () => {
        button.removeEventListener("click", ask);
        removeEventListener("keydown", press);
        // Words may be typed already while it comes.
        box.classList.remove("hidden");
        words.focus();
        await fetchAll();
        box.classList.add("hidden");
        button.click();
        words.setSelectionRange(words.value.length, words.value.length);
    };
    const press = event => {
        const other = event.altKey || event.ctrlKey || event.metaKey || mdbook_something_else_has_focus(event);
        if (other || !["s", "S", "/"].includes(event.key)) return;
        event.preventDefault();
        ask();
    };
    if (/[?&](search|highlight)=/.test(location.search)) fetchAll();
    else {
        button.addEventListener("click", ask);
        addEventListener("keydown", press);
    }
}

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

// Pictures load when they come into view. From a folder that saves nothing, so there all are
// loaded at once, and none is missing on paper.
if (location.protocol === "file:") {
    for (const picture of document.querySelectorAll("img[loading=lazy]")) picture.loading = "eager";
}

// Code: colours, when it comes into view, and a button that copies a listing.
{
    const colour = async code => { await script(highlighter); hljs.highlightBlock(code); };
    const codes = document.querySelectorAll("pre > code:is(.language-rust, .language-toml)");
    if (location.protocol === "file:") codes.forEach(colour);
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
            await navigator.clipboard.writeText(code.textContent);
            button.textContent = "Copied";
        } catch {
            button.textContent = "Not copied";
        }
        setTimeout(() => { button.textContent = "Copy"; }, 1500);
    });
}

// Works through a list some milliseconds at a time, a few elements at once, so that the page
// answers meanwhile. Returns what stops it.
function little(list, work, done) {
    const all = [...list];
    let due;
    const some = () => {
        const end = performance.now() + 5;
        while (all.length && performance.now() < end) work(all.splice(0, 4));
        if (all.length) due = setTimeout(some);
        else done();
    };
    due = setTimeout(some);
    return () => clearTimeout(due);
}

// What is far below waits until the page is shown; then it is laid out as well, so that all of
// it is there for whoever takes a picture of the page or jumps to its end.
const laidOut = new Promise(done => {
    const main = document.querySelector("main");
    const show = few => {
        for (const part of few) part.style.contentVisibility = "visible";
        main.getBoundingClientRect();
    };
    addEventListener("load", () => little(document.querySelectorAll("main > *, .formula"), show, done));
});

// What scrolls sideways takes the focus, so that the keyboard can scroll it.
{
    // What is measured is laid out; so a few are measured before one of them is changed.
    const main = document.querySelector("main");
    const range = document.createRange();
    const isWide = box => {
        if (!box.matches(".formula")) return box.scrollWidth > box.clientWidth;
        range.selectNodeContents(box.firstElementChild);
        return range.getBoundingClientRect().right > box.getBoundingClientRect().right + 0.5;
    };
    const measure = few => {
        const wide = few.map(isWide);
        few.forEach((box, k) => {
            if (wide[k]) box.tabIndex = 0;
            else box.removeAttribute("tabindex");
        });
    };
    let stop = () => {};
    const later = () => {
        stop();
        delete main.dataset.ready;
        stop = little(document.querySelectorAll("pre, .table-wrapper, .stage, .formula"), measure, () => { main.dataset.ready = ""; });
    };
    laidOut.then(() => {
        later();
        addEventListener("resize", later);
        document.fonts?.addEventListener("loadingdone", later);
    });
}

// The arrow keys turn to the chapters before and after.
addEventListener("keydown", event => {
    const busy = event.altKey || event.ctrlKey || event.metaKey || event.shiftKey || event.target !== document.body;
    if (busy) return;
    const rel = { ArrowLeft: "prev", ArrowRight: "next" }[event.key];
    const link = rel && document.querySelector(`.turn a[rel=${rel}]`);
    if (link) location.href = link.href;
});
