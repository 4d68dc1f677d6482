// The page: texts on the left, what they mean on the right; everything is asked of the core.

import { addressWriter, readAddress } from './address.js';
import { Desk, Layout } from './desk.js';
import { Editor } from './editor.js';
import { button, byId, make } from './elements.js';
import { showFindings } from './findings.js';
import { FloorView } from './floor.js';
import { draw, hang } from './picture.js';
import { ProveView, fill } from './prove.js';
import { RunView } from './run.js';

/** In the order of their tabs. */
const VIEWS = ['see', 'run', 'prove', 'floor'];

/** So many files have a button each. */
const FEW = 7;

/** Whoever types on does so within so many milliseconds. */
const PAUSE = 200;

class Page {
    constructor(start) {
        this.files = start.files;
        this.needed = start.needed || [];
        this.open = Math.min(start.open || 0, this.files.length - 1);
        this.view = start.view || 'see';
        this.desk = new Desk();
        this.layout = new Layout();
        this.components = [];
        this.findings = [];
        this.version = 0;
        this.typedAt = -PAUSE;
        this.editor = new Editor(byId('editor'), (text) => this.typed(text), (at) => this.moved(at), (...question) => this.ask(...question).then(JSON.parse));
        this.run = new RunView(byId('run'), this);
        this.prove = new ProveView(byId('prove'), this);
        this.floor = new FloorView(byId('floor'), this);
        this.wanted = start.component || '';
        if (start.run) {
            this.run.restore(start.run);
        }
        if (start.floor) {
            this.floor.restore(start.floor);
        }
        this.changed = addressWriter(() => this.state());
        this.listen();
        this.showFiles();
        this.openFile(this.open);
        this.select(this.view, false);
        this.floor.show();
        this.check();
    }

    state() {
        return {
            files: this.files, needed: this.needed, open: this.open, view: this.view,
            component: byId('component').value, run: this.run.state(), floor: this.floor.state(),
        };
    }

    listen() {
        byId('component').addEventListener('change', () => {
            this.wanted = byId('component').value;
            this.openText(this.component(this.wanted));
            this.refresh();
        });
        const tabs = [...byId('tabs').children];
        tabs.forEach((tab, number) => {
            tab.addEventListener('click', () => this.select(tab.id.slice(4), true));
            tab.addEventListener('keydown', (event) => {
                const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
                if (by) {
                    tabs[(number + by + tabs.length) % tabs.length].focus();
                    event.preventDefault();
                }
            });
        });
        byId('help-button').addEventListener('click', () => byId('help').showModal());
        document.addEventListener('keydown', (event) => this.key(event));
    }

    key(event) {
        const typing = event.target.closest('.cm-editor, input[type=text], input[type=number], textarea');
        if (event.key === '?' && !typing) {
            byId('help').showModal();
        } else if (event.altKey && '12345'.includes(event.key) && event.key !== '') {
            event.preventDefault();
            if (event.key === '1') {
                this.editor.focus();
            } else {
                this.select(VIEWS[Number(event.key) - 2], true);
                byId(this.view).focus();
            }
        }
    }

    // Files and text

    /** Buttons for a few files, a list for many. */
    showFiles() {
        const files = byId('files');
        if (this.files.length > FEW) {
            const list = make('select', { 'aria-label': 'File', onchange: () => this.openFile(Number(list.value)) },
                ...this.files.map((file, number) => make('option', { value: number }, file.path)));
            list.value = String(this.open);
            files.replaceChildren(list);
            return;
        }
        files.replaceChildren(...this.files.map((file, number) =>
            button(file.path.split('/').pop(), () => this.openFile(number), {
                title: file.path,
                'aria-current': number === this.open ? 'page' : null,
            })));
    }

    openFile(number) {
        this.open = number;
        const file = this.files[number];
        this.editor.open(file.path, file.text);
        this.editor.show(this.findings, (fix) => this.repair(fix));
        this.showFiles();
        this.changed();
    }

    /** The file of a component that was chosen; where the cursor stands is left alone. */
    openText(component) {
        const number = this.files.findIndex((each) => component && each.path === component.path);
        if (number >= 0 && number !== this.open) {
            this.openFile(number);
        }
    }

    typed(text) {
        this.typedAt = performance.now();
        this.files[this.open].text = text;
        this.check();
        this.changed();
    }

    /** The component at the cursor is the one that is looked at. */
    moved(at) {
        const path = this.files[this.open].path;
        const here = this.components.find((each) =>
            each.path === path && each.start <= at && at <= each.end);
        const chosen = byId('component');
        if (here && chosen.value !== here.name && this.editor.view.hasFocus) {
            chosen.value = here.name;
            this.wanted = here.name;
            this.refresh();
        }
    }

    texts() {
        const all = [...this.files, ...this.needed];
        return {
            paths: all.map((each) => each.path),
            texts: all.map((each) => each.text),
            needed: this.needed.map((each) => each.path),
        };
    }

    /** Checks what there is now; while that goes on, only the latest text waits. */
    async check() {
        if (this.checking) {
            this.again = true;
            return;
        }
        this.checking = true;
        do {
            this.again = false;
            const { paths, texts, needed } = this.texts();
            const begun = performance.now();
            try {
                const answer = JSON.parse(await this.desk.ask('check', paths, texts, needed));
                this.took = performance.now() - begun;
                if (!this.again) {
                    this.found(answer);
                    await this.meant(answer.whole);
                }
            } catch (problem) {
                byId('status').textContent = 'this went wrong in the page: ' + problem.message;
            }
        } while (this.again);
        this.checking = false;
    }

    found(answer) {
        this.findings = answer.findings;
        this.editor.show(this.findings, (fix) => this.repair(fix));
        showFindings(byId('findings'), this.findings, (place) => this.go(place), (fix) => this.repair(fix));
        const errors = this.findings.filter((each) => each.severity === 'error').length;
        const warnings = this.findings.length - errors;
        byId('status').textContent = `${plural(errors, 'error')}, ${plural(warnings, 'warning')}; checked in ${this.took.toFixed(0)} ms`;
        if (this.version === 0) {
            performance.mark('first answer');
        }
        document.body.dataset.found = String(++this.version);
    }

    /** What models mean is asked for when the findings are seen, and not at all behind another key. */
    async meant(whole) {
        const answer = JSON.parse(await this.desk.ask('components'));
        if (this.again) {
            return;
        }
        this.whole = whole;
        this.take(answer.components);
        if (whole) {
            this.prove.offer(this.components);
        }
        if (whole || ['see', 'floor'].includes(this.view)) {
            this.refreshInPause();
        }
        this.showAge();
        document.body.dataset.checked = String(this.version);
    }

    /** While there are errors, components that have some, or need what has, are as they were. */
    take(components) {
        const fresh = new Map(components.map((each) => [each.name, each]));
        const known = this.whole ? [] : this.components.map((each) => fresh.get(each.name) ?? each);
        const names = new Set(known.map((each) => each.name));
        this.components = [...known, ...components.filter((each) => !names.has(each.name))];
        this.fresh = fresh;
        const shown = this.components.filter((each) => !each.platform).map((each) => each.name);
        if (this.wanted) {
            byId('component').replaceChildren(make('option', {}, this.wanted));
        }
        fill(byId('component'), shown);
    }

    /** Says where what is shown is from before, and why. */
    showAge() {
        const name = byId('component').value;
        const ofSee = this.view === 'see';
        const isOld = ofSee ? name && !this.fresh?.has(name) : this.view !== 'floor';
        byId('stale').hidden = this.whole !== false || !isOld;
        byId('stale').textContent = ofSee
            ? `${name} has errors, or needs what has some: its picture is from before.`
            : 'The models have errors: what is shown here is from before.';
    }

    go(place) {
        const number = this.files.findIndex((each) => each.path === place.path);
        if (number >= 0) {
            if (number !== this.open) {
                this.openFile(number);
            }
            this.editor.select(place.start, place.end);
        }
    }

    repair(fix) {
        const path = fix.edits[0].path;
        const number = this.files.findIndex((each) => each.path === path);
        if (number < 0) {
            return;
        }
        if (number !== this.open) {
            this.openFile(number);
        }
        this.editor.change(fix.edits.filter((each) => each.path === path));
        this.editor.focus();
    }

    // What the views ask

    ask(question, ...args) {
        return this.desk.ask(question, ...args);
    }

    /** @param closed parts of a component that do not show what is inside */
    draw(component, automaton, closed = []) {
        this.drawing = (this.drawing || Promise.resolve()).catch(() => {})
            .then(() => draw(this.desk, this.layout, component, automaton, closed));
        return this.drawing;
    }

    component(name) {
        return this.components.find((each) => each.name === name);
    }

    /** A worker for what may take long. */
    prover() {
        this.second = this.second || new Desk();
        return this.second;
    }

    freeName(name) {
        const taken = new Set(this.files.map((each) => each.path.split('/').pop().split('.')[0]));
        let free = name;
        for (let number = 2; taken.has(free); number++) {
            free = name + number;
        }
        return free;
    }

    addTest(component, name, text) {
        const beside = this.component(component).path;
        const folder = beside.slice(0, beside.lastIndexOf('/') + 1);
        this.files.push({ path: folder + name + '.mt', text });
        this.openFile(this.files.length - 1);
        this.check();
        this.editor.focus();
    }

    // Views

    select(view, byHand) {
        this.view = view;
        for (const each of VIEWS) {
            byId(each).hidden = each !== view;
            const tab = byId('tab-' + each);
            tab.setAttribute('aria-selected', String(each === view));
            tab.tabIndex = each === view ? 0 : -1;
        }
        document.querySelector('.chooser').hidden = ['prove', 'floor'].includes(view);
        if (byHand) {
            this.refresh();
        }
        this.showAge();
    }

    /** What goes wrong is said; the page goes on. */
    async safely(action) {
        try {
            await action();
        } catch (problem) {
            byId('status').textContent = 'this went wrong in the page: ' + problem.message;
        }
    }

    /** A picture takes longer than a check: while somebody types on, the next key does not wait for one. */
    refreshInPause() {
        clearTimeout(this.refreshing);
        const since = performance.now() - this.typedAt;
        if (since < PAUSE) {
            this.refreshing = setTimeout(() => this.refresh(), PAUSE - since);
        } else {
            this.refresh();
        }
    }

    async refresh() {
        clearTimeout(this.refreshing);
        const name = byId('component').value;
        await this.safely(async () => {
            if (this.view === 'see') {
                await this.see(name);
            } else if (this.view === 'run') {
                await this.run.show(name);
            } else if (this.view === 'floor') {
                this.floor.show();
            }
        });
        this.showAge();
        this.changed();
    }

    async see(name) {
        const component = this.component(name);
        const panel = byId('see').firstElementChild;
        if (!this.fresh?.has(name) && panel.dataset.of === name) {
            return; // the picture from before
        }
        if (!component || !this.fresh?.has(name)) {
            panel.textContent = 'There is nothing to see yet.';
            delete panel.dataset.names;
            delete panel.dataset.of;
            return;
        }
        const wanted = component.composite || component.automata.length === 0 ? [-1] : [];
        component.automata.forEach((each, number) => wanted.push(number));
        const version = this.version;
        const pictures = [];
        if (this.closedIn !== name) {
            this.closedIn = name;
            this.closed = [];
        }
        for (const each of wanted) {
            pictures.push(await this.draw(name, each, this.closed));
        }
        if (version === this.version && pictures.every((each) => each !== null)) {
            const names = wanted.map((each) => (each < 0 ? name : `automaton ${each + 1} of ${name}`));
            hang(panel, pictures, names, (_, closed) => {
                this.closed = closed;
                this.refresh();
            });
            panel.dataset.of = name;
            document.body.dataset.drawn = String(version);
        }
    }
}

function plural(number, word) {
    return `${number} ${word}${number === 1 ? '' : 's'}`;
}

readAddress().then((said) => {
    window.page = new Page(said || JSON.parse(byId('models').textContent));
});
