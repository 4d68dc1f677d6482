// The text, with colours, findings at their places, and repairs.

import { make } from './elements.js';

const { EditorState, Compartment, StateEffect, StateField } = require('@codemirror/state');
const {
    EditorView, keymap, lineNumbers, highlightActiveLine, drawSelection, highlightSpecialChars, hoverTooltip,
    showTooltip,
} = require('@codemirror/view');
const { history: undoHistory, historyKeymap, defaultKeymap } = require('@codemirror/commands');
const {
    StreamLanguage, syntaxHighlighting, HighlightStyle, bracketMatching, indentUnit,
} = require('@codemirror/language');
const { setDiagnostics, nextDiagnostic, lintGutter, forEachDiagnostic } = require('@codemirror/lint');
const { searchKeymap } = require('@codemirror/search');
const {
    autocompletion, completionKeymap, closeBrackets, closeBracketsKeymap, snippetCompletion, pickedCompletion,
} = require('@codemirror/autocomplete');
const { tags } = require('@lezer/highlight');

const WORDS = new Set(('abstract association autoconnect automaton class classdiagram component '
    + 'connect deploy else enum expect extends feature final if implementation implements import in '
    + 'init initial input inv out package port refines state table test testsuite then timing '
    + 'events instant delayed var varif alt call inputs outputs constraint derived do').split(' '));
const VALUES = new Set(['true', 'false', 'null', 'Tk']);

function token(stream, state) {
    if (state.comment) {
        if (stream.skipTo('*/')) {
            stream.match('*/');
            state.comment = false;
        } else {
            stream.skipToEnd();
        }
        return 'comment';
    }
    if (stream.eatSpace()) {
        return null;
    }
    if (stream.match('//')) {
        stream.skipToEnd();
        return 'comment';
    }
    if (stream.match('/*')) {
        state.comment = true;
        return 'comment';
    }
    if (stream.match(/^"([^"\\]|\\.)*"?/) || stream.match(/^'([^'\\]|\\.)*'/)) {
        return 'string';
    }
    if (stream.match(/^\d[\w.]*/)) {
        return 'number';
    }
    if (stream.match(/^<<|^>>|^->/)) {
        return 'meta';
    }
    const word = stream.match(/^[\p{L}_$][\p{L}\p{N}_$]*/u);
    if (word) {
        const text = word[0];
        return WORDS.has(text) ? 'keyword'
            : VALUES.has(text) ? 'atom'
                : /^\p{Lu}/u.test(text) ? 'typeName' : null;
    }
    stream.next();
    return null;
}

const language = StreamLanguage.define({
    name: 'arcomat',
    startState: () => ({ comment: false }),
    token,
    languageData: { commentTokens: { line: '//', block: { open: '/*', close: '*/' } } },
});

const WORLD_WORDS = new Set(('at bend body brews bumper chute component coffee cup cups device diameter distance drinker every '
    + 'facing feeler finger floor goal heading holder in jar kind lamp light line magazine noise none parameter place program '
    + 'ring robot robots seconds slide step track ultrasonic wall wheels width with').split(' '));

const worldLanguage = StreamLanguage.define({
    name: 'world',
    token(stream) {
        if (stream.eatSpace()) {
            return null;
        }
        if (stream.match('#')) {
            stream.skipToEnd();
            return 'comment';
        }
        if (stream.match(/^-?\.?\d[\w.]*/)) {
            return 'number';
        }
        if (stream.match(/^\$\w+/)) {
            return 'atom';
        }
        const word = stream.match(/^[\p{L}\p{N}_.]+/u);
        if (word) {
            return WORLD_WORDS.has(word[0]) ? 'keyword' : null;
        }
        stream.next();
        return null;
    },
    languageData: { commentTokens: { line: '#' } },
});

function languageOf(path) {
    return path.endsWith('.world') ? worldLanguage : language;
}

const colours = HighlightStyle.define([
    { tag: tags.keyword, class: 'w-keyword' },
    { tag: tags.comment, class: 'w-comment' },
    { tag: tags.string, class: 'w-string' },
    { tag: tags.number, class: 'w-number' },
    { tag: tags.atom, class: 'w-number' },
    { tag: tags.typeName, class: 'w-type' },
    { tag: tags.meta, class: 'w-sign' },
]);

function repairHere(view) {
    const at = view.state.selection.main.head;
    const line = view.state.doc.lineAt(at);
    let chosen = null;
    forEachDiagnostic(view.state, (each, from, to) => {
        const near = from <= at && at <= to;
        const sameLine = from <= line.to && line.from <= to;
        if (each.actions && each.actions.length && (near || (sameLine && !chosen))) {
            chosen = each;
        }
    });
    if (chosen) {
        chosen.actions[0].apply(view);
    }
    return chosen !== null;
}

/** What was asked for by a key; gone with the next one. */
const setTold = StateEffect.define();
const told = StateField.define({
    create: () => null,
    update(shown, change) {
        const said = change.effects.find((each) => each.is(setTold));
        return said ? said.value : change.selection || change.docChanged ? null : shown;
    },
    provide: (field) => showTooltip.from(field),
});

const WORD = /^[\p{L}\p{N}_$]*$/u;
const WORD_BEFORE = /[\p{L}\p{N}_$.]/u;

/** Names before words; one that needs an import brings it along. */
function named({ label, detail, kind, edits }) {
    const option = { label, detail, type: kind, boost: 1 };
    if (edits.length > 0) {
        option.apply = (view, completion, from, to) => view.dispatch({
            changes: [
                { from, to, insert: label },
                ...edits.map((edit) => ({ from: edit.start, to: edit.end, insert: edit.text })),
            ],
            annotations: pickedCompletion.of(completion),
        });
    }
    return option;
}

/** Places to be filled in are written otherwise here. */
function places(text) {
    return text.replace(/\$0/g, '${}').replace(/\$(\d)/g, '${$1}');
}

/** Of the Markdown that editors get what the core writes: a line of code, prose, a list, and words as code. */
function paragraphs(text) {
    const [, code, rest] = /^```arcomat\n(.*)\n```\n*([^]*)$/.exec(text);
    return [make('code', {}, code), ...rest.split('\n').filter((line) => line.trim()).map((line) => {
        const item = line.startsWith('* ');
        const words = (item ? line.slice(2) : line).split('`');
        return make(item ? 'li' : 'p', {}, ...words.map((word, number) => number % 2
            ? make('code', {}, word)
            : word.replace(/\\(.)/g, '$1')));
    })];
}

/** The editor of one file at a time; each keeps its own history. */
export class Editor {
    /**
     * @param {function} ask asks the core
     */
    constructor(parent, changed, moved, ask) {
        this.ask = ask;
        this.changed = changed;
        this.states = new Map();
        this.label = new Compartment();
        this.extensions = [
            lineNumbers(), highlightSpecialChars(), undoHistory(), drawSelection(),
            bracketMatching(), closeBrackets(), highlightActiveLine(), lintGutter(), told,
            EditorState.tabSize.of(4), indentUnit.of('    '), syntaxHighlighting(colours),
            autocompletion({ override: [(context) => this.offers(context)], icons: false }),
            hoverTooltip((view, at) => this.facts(at)),
            keymap.of([
                { key: 'Mod-.', run: repairHere },
                { key: 'F8', run: nextDiagnostic },
                { key: 'Mod-i', preventDefault: true, run: () => this.tell() },
                ...closeBracketsKeymap, ...completionKeymap, ...searchKeymap, ...historyKeymap,
                ...defaultKeymap,
            ]),
            EditorView.updateListener.of((update) => {
                if (update.docChanged) {
                    this.changed(update.state.doc.toString());
                }
                if (update.selectionSet || update.docChanged) {
                    moved(update.state.selection.main.head);
                }
            }),
        ];
        this.view = new EditorView({ parent });
    }

    open(path, text) {
        if (this.path !== undefined) {
            this.states.set(this.path, this.view.state);
        }
        this.path = path;
        const kept = this.states.get(path);
        this.view.setState(kept && kept.doc.toString() === text
            ? kept
            : EditorState.create({
                doc: text,
                extensions: [
                    this.extensions,
                    languageOf(path),
                    EditorView.contentAttributes.of({ 'aria-label': 'Text of ' + path }),
                ],
            }));
    }

    /** Findings of the file that is open; repairs go by the whole page. */
    show(findings, repair) {
        const length = this.view.state.doc.length;
        const diagnostics = findings
            .filter((each) => each.path === this.path && each.end <= length)
            .map((each) => ({
                from: each.start,
                to: each.end,
                severity: each.severity,
                source: each.code,
                message: each.message,
                actions: each.fix
                    ? [{ name: each.fix.title, apply: () => repair(each.fix) }]
                    : [],
            }));
        this.view.dispatch(setDiagnostics(this.view.state, diagnostics));
    }

    /** Edits of the file that is open, as one that can be taken back. */
    change(edits) {
        this.view.dispatch({
            changes: edits.map(({ start, end, text }) => ({ from: start, to: end, insert: text })),
        });
    }

    /** What could be written here, as editors offer it: names first, then words, then whole pieces. */
    async offers(context) {
        const asked = WORD_BEFORE.exec(context.state.sliceDoc(Math.max(0, context.pos - 1), context.pos));
        if (!context.explicit && !asked) {
            return null;
        }
        const found = await this.ask('complete', this.path, context.state.doc.toString(), context.pos);
        if (context.aborted || found.from === undefined) {
            return null;
        }
        return {
            from: found.from,
            validFor: WORD,
            options: [
                ...found.names.map(named),
                ...found.words.map((word) => ({ label: word, type: 'keyword', boost: 0 })),
                ...found.pieces.map(({ label, detail, text }) =>
                    snippetCompletion(places(text), { label, detail, type: 'piece', boost: -1 })),
            ],
        };
    }

    /** What is known of the name at a place, as editors show it. */
    async facts(at) {
        if (languageOf(this.path) !== language) {
            return null;
        }
        const found = await this.ask('facts', this.path, at);
        return found.text === undefined ? null : {
            pos: found.start,
            end: found.end,
            create: () => ({ dom: make('div', { class: 'facts', role: 'tooltip' }, ...paragraphs(found.text)) }),
        };
    }

    /** The same by a key, for who has no mouse; another key takes it away. */
    tell() {
        this.facts(this.view.state.selection.main.head)
            .then((found) => this.view.dispatch({ effects: setTold.of(found) }));
        return true;
    }

    select(start, end) {
        this.view.dispatch({
            selection: { anchor: start, head: end },
            effects: EditorView.scrollIntoView(start, { y: 'center' }),
        });
        this.view.focus();
    }

    focus() {
        this.view.focus();
    }
}
