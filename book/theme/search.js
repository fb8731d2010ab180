"use strict";

// The search: MiniSearch finds sections of the book, and a dialog shows them.
{
    const box = /** @type {HTMLDialogElement} */ (document.getElementById("search"));
    const field = /** @type {HTMLInputElement} */ (document.getElementById("search-field"));
    const [toggle, status, list] = ["search-toggle", "search-status", "search-results"].map(id => document.getElementById(id));

    // Longer queries would take long and find nothing.
    const MOST_LETTERS = 100, MOST_WORDS = 16, MOST_RESULTS = 30;
    field.maxLength = MOST_LETTERS;

    // Queries and the text of the book are treated alike: a text is split into words, and each word
    // has one or more terms by which the word is found.

    // The letters after an apostrophe, as in "doesn't", don't count as a word, and neither does the ending of a file
    // name such as "ray.rs". So a query for the variable `t` or `Rs` doesn't find these texts.
    const WORD = /(?<![\p{L}\p{N}_]|\p{L}['’]|\.(?=rs\b))[\p{L}\p{N}_]+/gu;
    // Turns mathematical letters and superscript digits into plain characters, and removes `^`. So
    // the query `hRes` finds ℎ𝑅𝑒𝑠, and `b^2` finds b².
    /** @type {(text: string) => string} */
    const straighten = text => text.normalize("NFKC").replaceAll("^", "");
    /** @type {(text: string) => string[]} */
    const findWords = text => straighten(text).match(WORD) ?? [];
    // Stop words: they say nothing about the subject of a query.
    const STOP_WORDS = new Set(findWords(`a about again all also although always am an and any anybody anything are
        aren around as at be been but by came can come comes completely could couldn did didn do does doesn don entire
        even ever every everything for from gave get gets give gives go goes got had happen happens has hasn have haven
        how i if in instead into is isn it its just know like look looking looks lot make makes making many matter me
        mean most much must my need of on or our out quite really seem seems shall should shouldn show so some somebody
        something still strange take takes tell tells than that the their them then there these they thing things this
        though to too totally use using very want was wasn we weird were what when where which who whole why will with
        won work works would wouldn you your yours`));
    // Spellings, names of Greek letters, and variables with subscripts, each with the form that the search uses
    // instead.
    const SPELLINGS = /** @type {[RegExp, string][]} */ ([
        [/color/, "colour"], [/center/, "centre"], [/gray/, "grey"], [/iz(?=e|ing|ation)/, "is"], [/^theta$/, "θ"], [/^alpha$/, "α"],
        [/^(\p{L})_(\p{L}|\p{N})$/u, "$1$2"],
    ]);

    // The ending of a plural. The last letter of "is", "axis", "less" and "radius" isn't such an ending.
    const PLURAL = /(?<=..[^isu])s$/;
    // The suffixes that are removed from a word, so that the word's other forms are found, too. The
    // rest of the word must have at least four letters, with a vowel before the last letter. So
    // "string", "ring" and "red" stay whole.
    const ENDING = /(?<=[aeiouy].*.)(?<=....)(ation|ate|ion|ive|ing|ed|er|ier|iness|ness|e|l?y)$/;

    // Returns a word in lower case, in the spelling that the search uses, and without the ending of
    // a plural.
    /** @param {string} word */
    function stem(word) {
        const spelled = SPELLINGS.reduce((text, [from, to]) => text.replace(from, to), straighten(word).toLowerCase());
        return spelled.replace(PLURAL, "");
    }

    // Maps the root of a word to the root that stands for the word's whole group of synonyms.
    /** @type {Map<string, string>} */
    const synonyms = new Map();

    // Returns the term that a stemmed word shares with its other forms and its synonyms, such as `~reflect`.
    /** @param {string} word */
    function findFamily(word) {
        const root = word.replace(ENDING, "").replace(/([bdgmnprt])\1$/, "$1");
        return `~${synonyms.get(root) ?? root}`;
    }

    // Returns the terms by which a word is found: its stem, its family and, for a name such as `to_radians`, the stems
    // of its parts.
    /** @param {string} word */
    function findTerms(word) {
        const parts = word.includes("_") ? word.split("_").filter(Boolean) : [];
        return [...[word, ...parts].map(stem), findFamily(stem(word))];
    }

    // Returns the stems of the words that say what a text is about: all words except stop words. If a text contains
    // only stop words, returns their stems.
    /** @param {string} text */
    function findSubjects(text) {
        const words = findWords(text), subjects = words.filter(word => !STOP_WORDS.has(word.toLowerCase()));
        return [...new Set((subjects.length ? subjects : words).slice(0, MOST_WORDS).map(stem))];
    }

    const addUp = (/** @type {number[]} */ numbers) => numbers.reduce((sum, number) => sum + number, 0);

    // Simplifies a text, so that texts can be compared without regard to case and punctuation.
    /** @param {string} text */
    const simplify = text => findWords(text.toLowerCase()).join(" ");

    // Rewrites a formula or a piece of code, so that differences in spaces, dots, minus signs and exponents don't
    // matter.
    /** @param {string} text */
    const findSymbols = text => straighten(text).toLowerCase().replace(/\s/g, "").replace(/⋅/g, "·").replace(/−/g, "-");
    const HAS_SYMBOLS = /[^\p{L}\p{N}\s_.,:;?!'’-]/u;

    // These constants determine the score of a section. MiniSearch computes a first score from the
    // fields in which a query's words occur. `TITLE_BOOST` and `PHRASES_BOOST` are the weights of
    // two of these fields. Then `find` multiplies the score by further factors. The comment at each
    // constant names a query from tests/browser/search_queries.txt that needs the constant. If you
    // remove the constant, or set an exponent to 1, the first result for this query is wrong.

    // The weight of a word in a section's title. A word in the section's text has the weight 1. Needed for "lambert".
    const TITLE_BOOST = 3;
    // The weight of a word in the phrases by which readers look for the section. Needed for "exercises".
    const PHRASES_BOOST = 2;
    // The weight of a section on the page of mistakes, if the query suggests that something is
    // wrong with the reader's picture. Needed for "the light doesn't get weaker".
    const MISTAKES_WEIGHT = 3;
    // The weight of a section on the page of mistakes, if the query might describe a wrong picture.
    // Such a query isn't a question, and has three or more words that aren't stop words. Needed for
    // "the side away from the lamp is as bright as the front".
    const POSSIBLE_MISTAKES_WEIGHT = 1;
    // The weight of a section on a page that only repeats the chapters. Needed for "jitter".
    const REPETITION_WEIGHT = 0.1;
    // The weight of the first section of the book. The weight falls from section to section, to 0.4 for the last
    // section. Needed for "exercises".
    const FIRST_SECTION_WEIGHT = 1.4;
    // The exponent of a section's share. The share is the fraction of the query's words that the
    // section has, with each word weighted by `weighWord`. If the share is one half, the score is
    // divided by eight. Needed for "how do students hand in their pictures".
    const SHARE_EXPONENT = 3;
    // If a whole name of the section makes up the whole query, the section's score is multiplied by
    // 1 plus this bonus. Needed for "color".
    const WHOLE_NAME_BONUS = 99;
    // If a whole name of the section makes up only a fraction of the query, the bonus is multiplied
    // by that fraction to the power of this exponent. Needed for "how do I test my code".
    const WHOLE_NAME_EXPONENT = 3;
    // The factor of a section that contains the query symbol by symbol. This applies only to a query with symbols, such
    // as code or a formula. Needed for "Option<f64>".
    const VERBATIM_FACTOR = 20;
    // The factor of a section if one of its names equals the query, word by word or symbol by symbol. Needed for "n·l".
    const EXACT_NAME_FACTOR = 10;
    // What is added to the rarity of a word, so that a common word has some weight, too. Needed for "highlights have
    // colour".
    const RARITY_ADDEND = 3;

    // The index.

    /**
     * A section of the book, with the phrases by which readers look for it. Its names are its title and these phrases.
     * @typedef {{ page: string, id: string, chapter: string, title: string, prose: string, listings: string, phrases: string[],
     *     symbols: string, names: { simple: string, symbols: string, families: string[] }[] }} Section
     */

    /**
     * A match that MiniSearch has found: a section, the terms that match, and the fields in which
     * each term occurs. `find` adds `share`, which is how much of the query the section has, and
     * `isFound`, which says whether the match is good enough to be shown.
     * @typedef {{ id: number, score: number, terms: string[], match: Record<string, string[]>, share: number, isFound: boolean }} Result
     */

    /** @type {Section[]} */
    let sections = [];
    /** @type {{ search(words: string, options?: object): Result[] }} */
    let index;
    // All terms of the index.
    const vocabulary = new Set();

    async function makeIndex() {
        await Promise.all([book.load("theme/minisearch.min.js"), book.load("search-index.js")]);
        if (!window.MiniSearch || !book.searchIndex) return book.setText(status, "The search did not load. Close it and try again.");
        for (const group of book.searchSynonyms) {
            const [first, ...others] = group.map(word => findFamily(stem(word)).slice(1));
            for (const other of others) synonyms.set(other, first);
        }
        sections = book.searchIndex.flatMap(([page, chapter, parts]) => parts.map(([id, title, prose, listings, phrases]) => {
            const titleWithoutTime = title.replace(/: [\d.]+ (minutes?|hours?)$/, "");
            const names = [titleWithoutTime, ...phrases].map(text => (
                { simple: simplify(text), symbols: findSymbols(text), families: findSubjects(text).map(findFamily) }));
            return { page, id, chapter, title, prose, listings, phrases, names, symbols: findSymbols(`${title} ${prose} ${listings}`) };
        }));
        const made = new MiniSearch({
            fields: ["title", "chapter", "phrases", "prose", "listings"], tokenize: findWords,
            processTerm: (/** @type {string} */ word) => {
                const terms = findTerms(word);
                terms.forEach(term => vocabulary.add(term));
                return terms;
            },
            // Each call of `index.search` passes processed terms, separated by spaces.
            searchOptions: {
                tokenize: (/** @type {string} */ terms) => terms.split(" "), processTerm: (/** @type {string} */ term) => term,
                boost: { title: TITLE_BOOST, phrases: PHRASES_BOOST },
            },
        });
        made.addAll(sections.map((section, id) => ({ ...section, id, phrases: section.phrases.join(" ") })));
        index = made;
    }

    // The search.

    // Words that suggest that a query is about the reader's own picture, or about something wrong
    // with the picture. In a question, only a few of these words suggest this: "why is the sky not
    // black" isn't about a mistake. "What if I use D and not its square root" may be about a
    // mistake, so `QUESTION` doesn't match "what if".
    const SYMPTOM = /\b(my|yours|wrong|too|no|not|missing|instead|forgot|broken|strange|weird|only|looks?|all|everything|nothing|should be|\w+n['’]t)\b/i;
    const SYMPTOM_IN_QUESTION = /\b(my|wrong|too|instead|broken|strange|weird)\b/i;
    const QUESTION = /^(?!what (happens )?if)(wh\w+|how|can|could|do|does|is|are|may|should|must)\b/i;
    // A sentence that says how something is, such as "the sky is green".
    const STATEMENT = /^(\S+ ){1,3}(is|are|has|have|comes?)\b/i;
    // Returns the weight of the page of mistakes for this query. `count` is how many of the query's words say what the
    // query is about.
    /** @param {string} query @param {number} count */
    function weighMistakes(query, count) {
        if (QUESTION.test(query)) return SYMPTOM_IN_QUESTION.test(query) ? MISTAKES_WEIGHT : REPETITION_WEIGHT;
        if (SYMPTOM.test(query) || STATEMENT.test(query)) return MISTAKES_WEIGHT;
        return count >= 3 ? POSSIBLE_MISTAKES_WEIGHT : REPETITION_WEIGHT;
    }

    // Returns the weight of a section. Pages that only repeat the chapters weigh less than the
    // chapters. `mistakesWeight` is the weight of the page of mistakes. Early sections weigh more
    // than later sections, because the early sections explain things first.
    /** @param {Section} section @param {number} place @param {number} mistakesWeight */
    function weigh({ page }, place, mistakesWeight) {
        const weight = page === "mistakes.html" ? mistakesWeight : /^(solutions|problems|teaching)/.test(page) ? REPETITION_WEIGHT : 1;
        return weight * (FIRST_SECTION_WEIGHT - place / sections.length);
    }

    // Returns the terms in the index for a stemmed word of a query. If the index doesn't have the
    // word, we try the word with two neighbouring letters swapped. Then we try the terms that begin
    // with the word. For a long word, we finally try the terms that differ from the word in one
    // letter.
    /** @param {string} word */
    function findKnownTerms(word) {
        const terms = [word, findFamily(word)].filter(term => vocabulary.has(term));
        if (terms.length) return terms;
        const swaps = Array.from(word, (_, at) => word.slice(0, at) + [...word.slice(at, at + 2)].reverse().join("") + word.slice(at + 2));
        const swapped = swaps.find(term => vocabulary.has(term));
        if (swapped) return [swapped];
        const begun = word.length > 1 ? index.search(word, { prefix: true }) : [];
        const [near] = begun.length || word.length < 6 ? begun : index.search(word, { fuzzy: 1 });
        return near?.terms.filter(term => !term.startsWith("~")) ?? [];
    }

    // Returns how much a word says about the subject of a query. A rare word, whose terms occur in
    // few sections, says more than a common word.
    /** @param {string[]} terms */
    const weighWord = terms => Math.log(RARITY_ADDEND + sections.length / (index.search(terms.join(" ")).length || 1));

    // Finds the sections that match a query, the best first. A section matches if it has more than
    // half of the query's words. A section also matches if one of its names makes up at least half
    // of the query, and the index knows every word of the query.
    /** @param {string} query */
    function find(query) {
        // A reader may write with a hyphen what is a single word in the book.
        const joined = query.replace(/(\p{L}+)-(\p{L}+)/gu, (pair, left, right) => vocabulary.has(stem(left + right)) ? left + right : pair);
        const words = findSubjects(joined).map(findKnownTerms);
        const families = words.map(([term]) => term?.startsWith("~") ? term : findFamily(term ?? ""));
        const weights = words.map(weighWord), total = addUp(weights), weightOf = new Map(families.map((family, at) => [family, weights[at]]));
        const mistakesWeight = weighMistakes(query, words.length), hasUnknown = words.some(terms => !terms.length);
        const symbols = HAS_SYMBOLS.test(query) ? findSymbols(query) : null, simple = simplify(query);
        const results = index.search(words.flat().join(" "));
        for (const result of results) {
            const section = sections[result.id];
            const has = words.map(terms => terms.some(term => result.match[term]));
            const names = section.names.filter(name => name.families.every(family => weightOf.has(family)));
            const asName = Math.max(0, ...names.map(name => addUp(name.families.map(family => weightOf.get(family))))) / total;
            result.share = addUp(weights.map((weight, at) => has[at] ? weight : 0)) / total;
            result.isFound = has.filter(Boolean).length > words.length / 2 || (asName >= 0.5 && !hasUnknown);
            result.score *= weigh(section, result.id, mistakesWeight) * result.share ** SHARE_EXPONENT
                * (1 + WHOLE_NAME_BONUS * asName ** WHOLE_NAME_EXPONENT)
                * (symbols && section.symbols.includes(symbols) ? VERBATIM_FACTOR : 1)
                * (section.names.some(name => symbols ? name.symbols === symbols : name.simple === simple) ? EXACT_NAME_FACTOR : 1);
        }
        return results.filter(result => result.isFound).sort((one, other) => other.score - one.score);
    }

    // Finds the hint for a message of the compiler or of Cargo.
    /** @param {string} query */
    function findHint(query) {
        const text = ` ${simplify(query.replace(/^(error|warning)(?=[:[])/, "$1 of the compiler"))} `;
        return book.searchHints.find(([, messages]) => messages.some(message => text.includes(` ${simplify(message)} `)));
    }

    // The dialog.

    function show() {
        if (!index) return;
        const query = field.value.trim().slice(0, MOST_LETTERS);
        const hint = findHint(query), results = hint ? [] : find(query);
        list.replaceChildren(...results.slice(0, MOST_RESULTS).map(makeItem));
        if (hint) list.append(makeHint(hint[0], hint[2]));
        else if (query && !results.length) list.append(makeHint("mistakes.html#what-went-wrong", "If something is wrong with your picture, look here."));
        const count = results.length === 1 ? "One section" : `${results.length} sections`;
        const shown = results.length > MOST_RESULTS ? `${count}. The first ${MOST_RESULTS}:` : count;
        book.setText(status, !query ? "" : hint ? "That’s a message from Rust." : !results.length ? "Nothing in the book comes near it."
            : results.some(({ share }) => share === 1) ? shown : "No section has all of it. These come near:");
    }

    /** @param {Section} section */
    const makeLink = ({ page, id, chapter, title }) =>
        book.make("a", { href: `${book.root.dataset.root}${page}#${id}` }, title === chapter ? title : `${chapter}: ${title}`);

    // Makes a list item with a link to the section at an address, and a sentence of advice.
    /** @param {string} address @param {string} sentence */
    function makeHint(address, sentence) {
        const section = sections.find(({ page, id }) => `${page}#${id}` === address);
        const words = sentence.split("`").map((part, at) => at % 2 ? book.make("code", {}, part) : part);
        return book.make("li", {}, makeLink(section), book.make("span", { class: "teaser" }, ...words));
    }

    // Makes the list item of a section: a link, and the text around the first word that matches. If
    // the section is about a mistake, the alt text of the mistake's picture comes before the prose.
    // Alt texts are the only phrases that end with a full stop.
    /** @param {Result} result */
    function makeItem({ id, terms }) {
        const { prose, listings, phrases } = sections[id];
        const text = [...phrases.filter(phrase => phrase.endsWith(".")), prose, listings].join(" ");
        /** @param {RegExpMatchArray} match */
        const isFound = ([word]) => findTerms(word).some(term => terms.includes(term));
        const { 0: word, index: at } = [...text.matchAll(WORD)].find(isFound) ?? { 0: "", index: 0 };
        const start = at < 60 ? 0 : text.indexOf(" ", at - 60) + 1;
        return book.make("li", {}, makeLink(sections[id]), book.make("span", { class: "teaser" }, start ? "… " : "", text.slice(start, at),
            book.make("em", {}, word), `${text.slice(at + word.length, at + 120).replace(/\s?\S*$/, "")} …`));
    }

    // The query is stored for this tab, so that the field contains the query again after the reader goes back to the
    // page.
    const KEPT_QUERY = "search";
    try { field.value = sessionStorage.getItem(KEPT_QUERY) ?? ""; } catch { /* a private window */ }
    const keepQuery = () => { try { sessionStorage.setItem(KEPT_QUERY, field.value); } catch { /* a private window */ } };

    async function open() {
        if (!box.open) box.showModal();
        field.select();
        if (!index) await makeIndex();
        show();
    }
    toggle.addEventListener("click", open);
    box.querySelector("button").addEventListener("click", () => box.close());
    field.addEventListener("input", show);
    box.addEventListener("close", keepQuery);
    // A click outside the dialog closes the search, unless the pointer was pressed inside. In that
    // case, the reader was selecting text.
    const isOutside = (/** @type {MouseEvent} */ { clientX: x, clientY: y }) => {
        const { left, right, top, bottom } = box.getBoundingClientRect();
        return x < left || right < x || y < top || bottom < y;
    };
    let beganOutside = false;
    box.addEventListener("pointerdown", event => { beganOutside = isOutside(event); });
    box.addEventListener("click", event => {
        if (beganOutside && event.target === box && isOutside(event)) box.close();
    });
    // Enter opens the first result.
    field.form.addEventListener("submit", event => {
        event.preventDefault();
        list.querySelector("a")?.click();
    });
    // A result may be on this page, so a click on a result closes the search.
    list.addEventListener("click", event => {
        if (/** @type {Element} */ (event.target).closest("a")) box.close();
    });
    addEventListener("keydown", event => {
        const target = /** @type {HTMLElement} */ (event.target);
        // After the search closes, its field keeps the focus until the page is drawn again. The
        // reader isn't typing at that time.
        const isTyping = target.isContentEditable || (/^(input|select|textarea)$/i.test(target.nodeName) && (box.open || target !== field));
        const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
        const isControlK = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "k";
        if (event.altKey || ((event.ctrlKey || event.metaKey) && !isControlK)) return;
        if (box.open && step) {
            // The arrow keys move through the results.
            /** @type {HTMLElement[]} */
            const stops = [field, ...list.querySelectorAll("a")];
            stops[stops.indexOf(/** @type {HTMLElement} */ (document.activeElement)) + step]?.focus();
        } else if ((isControlK || ["/", "s"].includes(event.key)) && !isTyping) open();
        else return;
        event.preventDefault();
    });
}
