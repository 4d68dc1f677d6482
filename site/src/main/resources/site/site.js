// Search, copying of commands, and a list of pages that folds on narrow screens. Without this, pages are as readable.
'use strict';

const byId = (id) => document.getElementById(id);
const root = document.body.dataset.root;
const query = byId('query');
const results = byId('results');
const MOST = 12;
const AROUND = 70;

function make(name, attributes, ...children) {
    const element = Object.assign(document.createElement(name), attributes);
    element.append(...children);
    return element;
}

// Search: what it needs is loaded when somebody goes to the field. Scripts, since pages may lie in a folder without a server.

function load(name) {
    return new Promise((loaded, failed) =>
        document.head.append(make('script', { src: `${root}assets/${name}`, onload: loaded, onerror: failed })));
}

let searching = null;

function search() {
    searching ||= Promise.all([load('search.js'), load('sections.js')]).then(() => {
        lunr.tokenizer.separator = /[^\p{L}\p{N}_]+/u;
        return lunr(function () {
            this.pipeline.remove(lunr.stemmer);
            this.field('page', { boost: 8 });
            this.field('heading', { boost: 6 });
            this.field('text');
            window.sections.forEach(([, page, heading, text], id) => {
                // A title counts for the first section only, else all of a page would come first.
                this.add({ id, page: page === heading ? page : '', heading, text });
            });
        });
    });
    return searching;
}

function wordsOf(text) {
    const words = text.toLowerCase().split(/[^\p{L}\p{N}_]+/u).filter(Boolean);
    const rare = words.filter((word) => lunr.stopWordFilter(new lunr.Token(word)));
    return rare.length ? rare : words;
}

function find(index, words) {
    return index.query((asked) => words.forEach((word) => {
        asked.term(word, { presence: lunr.Query.presence.OPTIONAL, boost: 20, usePipeline: false });
        asked.term(word, {
            presence: lunr.Query.presence.REQUIRED, usePipeline: false, wildcard: lunr.Query.wildcard.TRAILING,
        });
    }));
}

/** A piece of text around the first word, with the words marked. */
function excerpt(text, words) {
    const low = text.toLowerCase();
    const first = Math.min(...words.map((word) => low.indexOf(word)).filter((at) => at >= 0), low.length);
    const from = first === low.length ? 0 : Math.max(0, first - AROUND);
    const piece = (from > 0 ? '…' : '') + text.slice(from, from + 2.6 * AROUND) + '…';
    const pattern = new RegExp(`(${words.join('|')})`, 'giu');
    return piece.split(pattern).map((part, number) => (number % 2 ? make('mark', {}, part) : part));
}

async function show() {
    const asked = query.value;
    if (!asked.trim()) {
        results.hidden = true;
        return;
    }
    const index = await search();
    if (asked !== query.value) {
        return; // somebody has typed on
    }
    const words = wordsOf(asked);
    const found = words.length ? find(index, words) : [];
    results.querySelector('p').textContent =
        found.length === 0 ? `No page has ${words.length > 1 ? 'all of these words' : 'this word'}.`
            : found.length > MOST ? `${found.length} sections, the best of them:` : '';
    results.querySelector('ol').replaceChildren(...found.slice(0, MOST).map(({ ref }) => {
        const [address, page, heading, text] = window.sections[ref];
        const title = page === heading ? page : `${page}: ${heading}`;
        return make('li', {}, make('a', { href: root + address },
            make('b', {}, title), make('span', {}, ...excerpt(text, words))));
    }));
    results.hidden = false;
}

let timer = 0;
query.addEventListener('focus', () => search());
query.addEventListener('input', () => {
    clearTimeout(timer);
    timer = setTimeout(show, 120);
});
query.form.addEventListener('submit', async (event) => {
    event.preventDefault();
    await show();
    results.querySelector('a')?.click();
});
query.form.addEventListener('keydown', (event) => {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.key === 'Escape') {
        results.hidden = true;
        query.focus();
    } else if (by && !results.hidden) {
        event.preventDefault();
        const stops = [query, ...results.querySelectorAll('a')];
        stops[(stops.indexOf(document.activeElement) + by + stops.length) % stops.length].focus();
    }
});
document.addEventListener('keydown', (event) => {
    if (event.key === '/' && !event.target.closest('input, textarea, select')) {
        event.preventDefault();
        query.select();
    }
});
document.addEventListener('click', (event) => {
    // A result may lie on this very page: then nothing is loaded that would close the list.
    if (!query.form.contains(event.target) || event.target.closest('#results a')) {
        results.hidden = true;
    }
});

// Commands of a terminal can be taken along, without what they print.

document.querySelectorAll('.console').forEach((block) => {
    const commands = [...block.querySelectorAll('kbd')].map((each) => each.textContent).join('\n');
    const copy = make('button', { type: 'button' }, 'Copy');
    copy.addEventListener('click', async () => {
        await navigator.clipboard.writeText(commands);
        copy.textContent = 'Copied';
        setTimeout(() => (copy.textContent = 'Copy'), 1500);
    });
    block.querySelector('.bar').append(copy);
});

if (matchMedia('(max-width: 800px)').matches) {
    document.querySelector('.contents').open = false;
}
document.querySelector('.contents [aria-current]')?.scrollIntoView({ block: 'nearest' });
document.body.dataset.ready = '';
