// Questions about promises, in a worker of their own that can be stopped; a counterexample is stepped through.

import { button, make } from './elements.js';
import { light, viewer } from './picture.js';

const MILLISECONDS = 120000;

const NOTHING = { test: 'there is no stream test', analyze: 'there is no automaton' };

/** How answers are called, by question. */
const CALLED = {
    analyze: { holds: 'without findings', fails: 'with findings', unknown: 'not decided' },
    test: { passed: 'passed', failed: 'failed' },
    other: { holds: 'hold', fails: 'fail', unknown: 'unknown' },
};

function summary(answers, question) {
    const words = CALLED[question] || CALLED.other;
    const count = (word) => answers.filter((each) => each.answer === word).length;
    return [...new Set([...Object.keys(words), ...answers.map((each) => each.answer)])]
        .map((word) => `${count(word)} ${words[word] || word}`)
        .join(', ');
}

export class ProveView {
    constructor(panel, page) {
        this.page = page;
        this.prover = null;
        this.left = make('select', { id: 'prove-left' });
        this.right = make('select', { id: 'prove-right' });
        this.subject = make('select', { id: 'prove-subject' });
        this.stopper = button('Stop', () => this.stop(), { class: 'stop', disabled: true });
        this.message = make('p', { role: 'status', class: 'verdict' });
        this.answers = make('div', { class: 'answers' });
        const ask = (label, action) => button(label, action, {});
        panel.append(
            make('div', { class: 'questions' },
                make('p', {},
                    ask('Verify all promises', () => this.ask('verify')), ' ',
                    ask('Analyze the automata', () => this.ask('analyze')), ' ',
                    ask('Run the stream tests', () => this.ask('test')), ' ', this.stopper),
                make('p', {},
                    make('label', { for: 'prove-left' }, 'Does '), this.left,
                    make('label', { for: 'prove-right' }, ' refine '), this.right, ' ',
                    ask('Prove', () => this.ask('refines', this.left.value, this.right.value))),
                make('p', {},
                    make('label', { for: 'prove-subject' }, 'Can all requirements be kept on '),
                    this.subject, ' ',
                    ask('Ask', () => this.ask('contradictions', this.subject.value)))),
            this.message, this.answers);
    }

    /** Offers what can be asked about. */
    offer(components) {
        const names = components.filter((each) => !each.platform).map((each) => each.name);
        const automata = components
            .filter((each) => each.automata.length > 0 && !each.platform)
            .map((each) => each.name);
        fill(this.left, names);
        fill(this.right, names, 1);
        fill(this.subject, automata);
    }

    async ask(question, ...names) {
        this.stop();
        const { paths, texts, needed } = this.page.texts();
        const prover = this.page.prover();
        this.prover = prover;
        this.stopper.disabled = false;
        this.message.textContent = 'looking for an answer';
        this.answers.replaceChildren();
        const begun = performance.now();
        try {
            await prover.ask('check', paths, texts, needed);
            const limits = question === 'test' ? [] : [MILLISECONDS];
            const answer = JSON.parse(await prover.ask(question, ...names, ...limits));
            const took = Math.round(performance.now() - begun);
            if (this.prover === prover) {
                this.show(answer, question, names, took);
            }
        } catch (problem) {
            this.message.textContent = problem.message === 'stopped'
                ? 'stopped: nothing is known'
                : 'this went wrong in the page: ' + problem.message;
        } finally {
            if (this.prover === prover) {
                this.stopper.disabled = true;
                this.prover = null;
            }
        }
    }

    stop() {
        if (this.prover) {
            this.prover.stop();
            this.prover = null;
            this.stopper.disabled = true;
        }
    }

    show(answer, question, names, took) {
        if (answer.refused) {
            this.message.textContent = answer.refused;
            return;
        }
        this.message.textContent = answer.answers.length === 0
            ? NOTHING[question] || 'there is nothing to prove'
            : `${summary(answer.answers, question)}; ${took} ms`;
        this.answers.replaceChildren(
            ...answer.answers.map((each) => this.answer(each)),
            ...(answer.open || []).map((each) => make('pre', {}, each)));
    }

    answer(each) {
        const lines = each.text.split('\n');
        const fine = ['holds', 'passed'].includes(each.answer);
        const details = make('details', { class: each.answer, open: !fine },
            make('summary', {}, lines[0]),
            make('pre', { tabindex: '0' }, lines.slice(1).join('\n').trim()));
        for (const place of each.places || (each.path ? [each] : [])) {
            details.append(button(place.path.split('/').pop() + ':' + place.line,
                () => this.page.go(place), { class: 'place' }), ' ');
        }
        if (each.moments && each.moments.length > 0) {
            details.append(this.counterexample(each));
        }
        return details;
    }

    /** Both automata under one cursor. */
    counterexample({ left, right, moments }) {
        const cursor = make('input', {
            type: 'range', min: '0', max: String(moments.length - 1), value: String(moments.length - 1),
            'aria-label': 'Step of the counterexample',
        });
        const words = make('p', { class: 'moment', 'aria-live': 'polite' });
        const pictures = make('div', { class: 'pictures' });
        const show = () => {
            const moment = moments[Number(cursor.value)];
            const went = moment.inputs.join(', ') || (cursor.value === '0' ? 'at the start' : 'silence');
            words.textContent = `step ${cursor.value}: ${went}; out: ${moment.outputs.join(', ') || 'nothing'}; `
                + `left is ${moment.left}; right is ${moment.right.join(' or ') || 'not possible'}`;
            cursor.setAttribute('aria-valuetext', words.textContent);
            pictures.querySelectorAll('figure').forEach((figure) => {
                const now = figure.dataset.side === 'left' ? [moment.left] : moment.right;
                const names = JSON.parse(figure.dataset.states);
                const lit = names
                    .map((name, number) => (now.some((each) => each === name || each.startsWith(name + ' '))
                        ? String(number) : null))
                    .filter((each) => each !== null);
                light(figure, 'state', lit, 'now');
                figure.classList.toggle('stuck', now.length === 0);
            });
        };
        cursor.addEventListener('input', show);
        this.sides(left, right).then((figures) => {
            pictures.replaceChildren(...figures);
            show();
        });
        show();
        return make('div', { class: 'counterexample' }, cursor, words, pictures);
    }

    async sides(left, right) {
        const figures = [];
        for (const [side, title] of [['left', left], ['right', right]]) {
            const name = title.replace(/[(#].*/, '');
            const component = this.page.component(name);
            if (component && component.automata.length === 1) {
                const figure = make('figure', { 'data-side': side },
                    make('figcaption', {}, `${side}: ${title}`));
                figure.dataset.states = JSON.stringify(component.automata[0].states);
                figure.append(viewer(await this.page.draw(name, 0), `${side}: ${title}`).element);
                figures.push(figure);
            }
        }
        return figures;
    }
}

/** Options by name; what was chosen stays. */
export function fill(select, names, otherwise = 0) {
    const chosen = select.value;
    select.replaceChildren(...names.map((name) => make('option', {}, name)));
    select.value = names.includes(chosen) ? chosen : names[Math.min(otherwise, names.length - 1)] || '';
}
