// Step by step: what goes in is chosen, a choice that the model leaves open is made, and steps are taken back.

import { button, make } from './elements.js';
import { hang, light } from './picture.js';

export class RunView {
    /**
     * @param {object} page asks the core, keeps the state, opens places, and adds files
     */
    constructor(panel, page) {
        this.panel = panel;
        this.page = page;
        this.letters = [];
        this.choices = [];
        this.component = '';
        this.form = make('form', { class: 'letter', 'aria-label': 'Input of the next step' });
        this.form.addEventListener('submit', (event) => {
            event.preventDefault();
            this.page.safely(() => this.take());
        });
        this.choice = make('div', { class: 'choice', role: 'group' });
        this.table = make('div', { class: 'steps', tabindex: '0', role: 'region', 'aria-label': 'Steps so far' });
        this.message = make('p', { role: 'status' });
        this.pictures = make('div', { class: 'pictures', role: 'group', 'aria-label': 'Pictures of the run' });
        panel.append(this.form, this.choice, this.message, this.table, this.pictures);
        panel.addEventListener('keydown', (event) => {
            if (event.altKey && event.key === 'Backspace') {
                event.preventDefault();
                this.page.safely(() => this.back());
            }
        });
    }

    /** The state, for the address. */
    state() {
        return { component: this.component, letters: this.letters, choices: this.choices };
    }

    restore({ component, letters, choices }) {
        this.component = component;
        this.letters = letters;
        this.choices = choices;
    }

    /** Shows the run of a component; of another one a new run. */
    async show(component) {
        if (component !== this.component) {
            this.restore({ component, letters: [], choices: [] });
        }
        await this.refresh();
    }

    async refresh() {
        if (!this.component) {
            this.message.textContent = 'There is no component to run.';
            return;
        }
        const answer = JSON.parse(await this.page.ask('run', this.component, this.letters, this.choices));
        if (answer.refused) {
            this.message.textContent = answer.refused;
            return;
        }
        this.answer = answer;
        this.showForm(answer);
        this.showChoice(answer.open);
        this.showSteps(answer);
        await this.showPicture(answer);
        this.page.changed();
    }

    showForm(answer) {
        const kept = this.ports === JSON.stringify(answer.inputs);
        this.ports = JSON.stringify(answer.inputs);
        const done = Boolean(answer.open || answer.failure);
        if (!kept) {
            this.form.replaceChildren(
                ...answer.inputs.map((input) => this.field(input)),
                make('div', { class: 'acts' },
                    make('button', { type: 'submit', class: 'main' }, 'Step'),
                    button('Back', () => this.page.safely(() => this.back()), { class: 'back' }),
                    button('From the beginning', () => this.page.safely(() => this.again()), {}),
                    button('Record as a stream test', () => this.page.safely(() => this.record()), {})));
        }
        this.form.querySelector('[type=submit]').disabled = done;
        this.form.querySelector('.back').disabled = this.letters.length === 0;
    }

    /** Buttons for few values, a text for many. */
    field(input) {
        const name = 'in ' + input.name;
        const group = make('fieldset', {}, make('legend', {}, input.name + ': ' + input.type));
        if (input.values.length > 0) {
            const all = input.total ? input.values : ['', ...input.values];
            const chosen = input.total ? input.first : '';
            all.forEach((value) => group.append(make('label', {},
                make('input', { type: 'radio', name, value, checked: value === chosen }),
                make('span', {}, value === '' ? 'silence' : value))));
        } else {
            group.append(make('input', {
                type: 'text', name, value: input.total ? input.first : '',
                placeholder: input.total ? '' : 'silence', 'aria-label': input.name,
            }));
        }
        return group;
    }

    letter() {
        return [...new FormData(this.form)]
            .filter(([, value]) => value !== '')
            .map(([name, value]) => name.slice(3) + ' = ' + value)
            .join('\n');
    }

    async take() {
        if (this.answer && (this.answer.open || this.answer.failure)) {
            return;
        }
        this.letters.push(this.letter());
        const before = this.letters.length;
        await this.refresh();
        if (this.answer.steps.length < before && !this.answer.open && !this.answer.failure) {
            this.letters.pop();
        }
    }

    async back() {
        if (this.letters.length > 0) {
            this.letters.pop();
            this.choices = this.madeBefore(this.letters.length);
            await this.refresh();
        }
    }

    /** Choices that were made in the steps before one. */
    madeBefore(step) {
        const kept = (this.madeIn || []).filter((each) => each < step).length;
        this.madeIn = (this.madeIn || []).slice(0, kept);
        return this.choices.slice(0, kept);
    }

    async again() {
        this.letters = [];
        this.choices = [];
        this.madeIn = [];
        await this.refresh();
    }

    showChoice(open) {
        this.choice.replaceChildren();
        if (!open) {
            return;
        }
        const who = open.instance ? ' in ' + open.instance : '';
        this.choice.append(make('p', {}, `Step ${open.step}: the model leaves open what happens${who}.`));
        open.alternatives.forEach((text, number) => this.choice.append(
            button(text, () => this.page.safely(async () => {
                this.madeIn = this.madeIn || [];
                this.madeIn[this.choices.length] = open.step;
                this.choices.push(number);
                await this.refresh();
                (this.choice.querySelector('button') || this.form.querySelector('[type=submit]')).focus();
            }), {})));
        this.choice.querySelector('button').focus();
    }

    showSteps(answer) {
        this.message.textContent = answer.failure || '';
        const head = make('tr', {}, ...['step', 'input', 'output', 'state', 'because']
            .map((each) => make('th', { scope: 'col' }, each)));
        const rows = answer.steps.map((step, number) => make('tr', {},
            make('th', { scope: 'row' }, String(number)),
            make('td', {}, step.inputs.join('\n') || 'silence'),
            make('td', {}, step.outputs.join('\n') || ''),
            make('td', {}, step.activities.map(stateOf).join('\n')),
            make('td', {}, ...step.activities.flatMap((each) => this.because(each)))));
        this.table.replaceChildren(rows.length === 0
            ? make('p', { class: 'none' }, 'No step yet: choose what goes in, then Step.')
            : make('table', {}, make('thead', {}, head), make('tbody', {}, ...rows)));
        this.table.scrollTop = this.table.scrollHeight;
    }

    because(activity) {
        return activity.path
            ? [button(activity.cause, () => this.page.go(activity), { class: 'place' }), make('br')]
            : [activity.cause, make('br')];
    }

    /** The automaton that runs, with its state; a component with parts, with what it sends. */
    async showPicture(answer) {
        const component = this.page.component(this.component);
        const automata = component ? component.automata : [];
        const key = this.component + this.page.version;
        if (this.drawn !== key) {
            this.drawn = key;
            const all = automata.length > 0 ? automata.map((each, number) => number) : [-1];
            const pictures = [];
            for (const each of all) {
                pictures.push(await this.page.draw(this.component, each));
            }
            hang(this.pictures, pictures, pictures.map(() => this.component));
        }
        const last = answer.steps[answer.steps.length - 1];
        const own = last ? last.activities.filter((each) => each.instance === '') : [];
        [...this.pictures.children].forEach((picture, number) => {
            const activity = own[number];
            const names = automata[number] ? automata[number].states : [];
            const state = activity ? names.indexOf(activity.after) : -1;
            light(picture, 'state', state < 0 ? [] : [String(state)], 'now');
        });
    }

    async record() {
        const simple = this.component.split('.').pop().replace(/[^\p{L}\p{N}_].*/u, '');
        const name = this.page.freeName(simple + 'Recorded');
        const text = await this.page.ask('record', this.component, this.letters, this.choices, name);
        this.page.addTest(this.component, name, text);
    }
}

function stateOf(activity) {
    const who = [activity.instance, activity.automaton].filter((each) => each).join('.');
    const way = activity.before === activity.after
        ? activity.after
        : activity.before + ' \u2192 ' + activity.after;
    const values = activity.variables.length ? ' (' + activity.variables.join(', ') + ')' : '';
    return (who ? who + ': ' : '') + way + values;
}
