"use strict";

// The search: MiniSearch finds sections of the book, and a dialog shows them.
{
    const box = /** @type {HTMLDialogElement} */ (document.getElementById("search"));
    const field = /** @type {HTMLInputElement} */ (document.getElementById("search-field"));
    const [toggle, status, list] = ["search-toggle", "search-status", "search-results"].map(id => document.getElementById(id));

    // Words that readers use, each with the book's own word for it.
    const SYNONYMS = new Map(Object.entries({
        acne: "rash", antialiasing: "rays pixel", bvh: "bounding volume", center: "centre", closest: "nearest", color: "colour",
        epsilon: "rash", falloff: "attenuation", intersection: "meet", performance: "faster", samples: "rays pixel",
        shiny: "shininess", spotlight: "spot light", supersampling: "rays pixel", theta: "θ", zbuffer: "nearest hit",
    }));
    // Longer queries take long and find nothing.
    const MOST_LETTERS = 100, MOST_WORDS = 16;
    field.maxLength = MOST_LETTERS;
    const WORD = /[\p{L}\p{N}_]+/gu;
    /** @type {(text: string) => string[]} */
    const findWords = text => text.match(WORD) ?? [];
    // Words that say nothing about the subject of a query.
    const SMALL_WORDS = /^(an?|as|at|by|do(es)?|for|from|how|in|is|it|of|on|or|the|to|what|with)$/i;
    /** @param {string} query */
    const findSubjects = query => {
        const words = findWords(query), subjects = words.filter(word => !SMALL_WORDS.test(word));
        return (subjects.length ? subjects : words).slice(0, MOST_WORDS);
    };
    // Reduces a word to lower case, without the common endings of plurals and nouns.
    /** @param {string} word */
    const stem = word => word.toLowerCase().replace(/(?<=...)(ion)?s?$/, "");
    // The terms by which a word is found. A name such as `to_radians` is found by its parts, too.
    /** @param {string} word */
    const findTerms = word => [word, ...word.split("_")].filter(Boolean).map(stem);
    // The weight of a section. Chapters come first, and early sections before later ones, since they explain things
    // first. Pages that only repeat the chapters come last.
    /** @type {(section: Section, id: number) => number} */
    const weigh = ({ page }, id) => (1.4 - id / sections.length)
        * (/^(mistakes|solutions|problems|teaching)/.test(page) ? 0.2 : /^(notation|slips|lecture|how)/.test(page) ? 0.5 : 1);

    /** @typedef {{ page: string, hash: string, chapter: string, title: string, prose: string, listings: string }} Section */

    /** @type {Section[]} */
    let sections = [];
    /** @type {any} */
    let index;
    async function makeIndex() {
        await Promise.all([book.load("theme/minisearch.min.js"), book.load("search-index.js")]);
        if (!window.MiniSearch || !book.searchIndex) return book.write(status, "The search did not load. Close it and try again.");
        sections = book.searchIndex.flatMap(([page, chapter, parts]) =>
            parts.map(([hash, title, prose, listings]) => ({ page, hash, chapter, title, prose, listings })));
        index = new MiniSearch({
            fields: ["title", "chapter", "prose", "listings"], tokenize: findWords, processTerm: findTerms,
            searchOptions: {
                processTerm: stem, boost: { title: 3, listings: 0.5 }, weights: { fuzzy: 0.7, prefix: 0.3 },
                boostDocument: (/** @type {number} */ id) => weigh(sections[id], id),
                prefix: (/** @type {string} */ term) => term.length > 2, fuzzy: (/** @type {string} */ term) => /^\p{L}{5,}$/u.test(term) && 0.2,
            },
        });
        index.addAll(sections.map((section, id) => ({ id, ...section })));
    }

    // Finds the sections that have all words of a query, whether its hyphens separate words or join them.
    /** @param {string} query */
    function findAll(query) {
        const queries = [" ", ""].map(link => findSubjects(query.replaceAll(/\b-\b/g, link))
            .map(word => SYNONYMS.get(word.toLowerCase()) ?? word).join(" "));
        return index.search({ queries: queries.map(words => ({ combineWith: "AND", queries: [words] })) });
    }

    function show() {
        if (!index) return;
        const query = field.value.trim().slice(0, MOST_LETTERS);
        const all = findAll(query);
        const results = all.length ? all : index.search(findWords(query).slice(0, MOST_WORDS).join(" "), { fuzzy: 0.4 });
        list.replaceChildren(...results.map(makeItem));
        const count = all.length === 1 ? "One section" : `${all.length} sections`;
        const near = results.length ? "No section has all of it. These come near:" : "Nothing in the book comes near it.";
        book.write(status, all.length ? count : query && near);
    }

    // The list item of a section: its title, and the text around the first word that matches.
    /** @param {{ id: number, terms: string[] }} result */
    function makeItem({ id, terms }) {
        const { page, hash, chapter, title, prose, listings } = sections[id];
        const text = `${prose} ${listings}`;
        const link = book.make("a", { href: `${book.root.dataset.root}${page}#${hash}` }, title === chapter ? title : `${chapter}: ${title}`);
        /** @param {RegExpMatchArray} match */
        const isFound = ([word]) => findTerms(word).some(term => terms.includes(term));
        const { 0: word, index: at } = [...text.matchAll(WORD)].find(isFound) ?? { 0: "", index: 0 };
        const start = at < 60 ? 0 : text.indexOf(" ", at - 60) + 1;
        return book.make("li", {}, link, book.make("span", { class: "teaser" }, start ? "… " : "", text.slice(start, at),
            book.make("em", {}, word), `${text.slice(at + word.length, at + 120).replace(/\s?\S*$/, "")} …`));
    }

    async function open() {
        if (!box.open) box.showModal();
        field.select();
        if (!index) await makeIndex();
        show();
    }
    toggle.addEventListener("click", open);
    box.querySelector("button").addEventListener("click", () => box.close());
    field.addEventListener("input", show);
    // Enter opens the first result, which may be on this page.
    field.form.addEventListener("submit", event => {
        event.preventDefault();
        list.querySelector("a")?.click();
    });
    list.addEventListener("click", event => {
        if (/** @type {Element} */ (event.target).closest("a")) box.close();
    });
    addEventListener("keydown", event => {
        const target = /** @type {HTMLElement} */ (event.target);
        const isTyping = target.isContentEditable || /^(input|select|textarea)$/i.test(target.nodeName);
        const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
        if (event.altKey || event.ctrlKey || event.metaKey) return;
        if (box.open && step) {
            // The arrow keys move through the results.
            /** @type {HTMLElement[]} */
            const stops = [field, ...list.querySelectorAll("a")];
            stops[stops.indexOf(/** @type {HTMLElement} */ (document.activeElement)) + step]?.focus();
        } else if (["/", "s"].includes(event.key) && !isTyping) open();
        else return;
        event.preventDefault();
    });
}
