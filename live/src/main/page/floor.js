// A world runs in a worker of its own, which can be stopped, and is played by what plays it on pages of `arcomat world`.

import { Desk } from './desk.js';
import { button, make } from './elements.js';
import { fill } from './prove.js';

const ENDING = '.world';
const NO_WORLD = 'There is no world among the files: a text that says what stands on a floor and which robots drive there. '
    + 'arcomat live brings along those that lie in the folders that it is given.';

export class FloorView {
    constructor(panel, page) {
        this.page = page;
        this.panel = panel;
        this.desk = null;
        this.world = make('select', { id: 'floor-world' });
        this.seed = make('input', { id: 'floor-seed', type: 'number', min: '0', max: '999999', value: '1' });
        this.runner = button('Run', () => this.run(), { class: 'main' });
        this.stopper = button('Stop', () => this.stop(), { disabled: true });
        this.message = make('p', { role: 'status', class: 'verdict' });
        this.stale = make('p', { class: 'stale', hidden: true }, 'The texts have changed since this run.');
        this.stage = make('div', { class: 'replay', role: 'region', 'aria-label': 'The run', tabindex: '0', hidden: true });
        this.form = make('form', { class: 'acts' },
            make('label', { for: 'floor-world' }, 'World'), this.world,
            make('label', { for: 'floor-seed' }, 'Seed'), this.seed, this.runner, this.stopper);
        this.form.addEventListener('submit', (event) => {
            event.preventDefault();
            this.run();
        });
        this.seed.addEventListener('change', () => page.changed());
        this.world.addEventListener('change', () => {
            page.openText({ path: this.world.value });
            page.changed();
        });
        panel.addEventListener('keydown', (event) => {
            if (this.played && !event.target.closest('form')) {
                this.played.key(event);
            }
        });
        panel.append(this.form, this.message, this.stale, this.stage);
    }

    state() {
        return { world: this.world.value, seed: this.seed.value };
    }

    restore({ world, seed }) {
        this.world.replaceChildren(make('option', {}, world));
        this.seed.value = seed;
    }

    /** Offers the worlds that there are now. */
    show() {
        const worlds = this.page.files.map((each) => each.path).filter((path) => path.endsWith(ENDING));
        fill(this.world, worlds);
        this.form.hidden = worlds.length === 0;
        if (worlds.length === 0) {
            this.message.textContent = NO_WORLD;
        } else if (!this.played && !this.desk) {
            this.message.textContent = '';
        }
        this.stale.hidden = !this.played || this.ran === this.text();
    }

    text() {
        return JSON.stringify(this.page.texts());
    }

    async run() {
        this.stop();
        const desk = this.worker();
        this.desk = desk;
        const { paths, texts, needed } = this.page.texts();
        const ran = this.text();
        this.busy(true);
        this.message.textContent = 'running';
        try {
            await desk.ask('check', paths, texts, needed);
            const answer = JSON.parse(await desk.ask('floor', this.world.value, Number(this.seed.value)));
            if (this.desk === desk) {
                this.ran = ran;
                this.take(answer);
            }
        } catch (problem) {
            this.message.textContent = problem.message === 'stopped'
                ? 'stopped'
                : 'this went wrong in the page: ' + problem.message;
        } finally {
            if (this.desk === desk) {
                this.busy(false);
                this.desk = null;
            }
        }
    }

    worker() {
        this.kept = this.kept || new Desk();
        return this.kept;
    }

    busy(now) {
        this.stopper.disabled = !now;
        this.stage.toggleAttribute('aria-busy', now);
    }

    stop() {
        if (this.desk) {
            const desk = this.desk;
            this.desk = null;
            this.busy(false);
            desk.stop();
        }
    }

    take(answer) {
        if (this.played && this.played.player.isPlaying) {
            this.played.player.toggle();
        }
        this.stale.hidden = true;
        this.stage.hidden = Boolean(answer.refused);
        if (answer.refused) {
            this.played = null;
            this.message.textContent = answer.refused;
            return;
        }
        this.message.textContent = `${answer.headline} (as arcomat world --no-limits --seed ${this.seed.value})`;
        this.message.classList.toggle('bad', !answer.good);
        this.play(new replay.Stage(new replay.Recording(answer.recording)));
    }

    play(stage) {
        this.played = stage;
        this.stage.replaceChildren(
            make('section', { 'aria-label': 'Floor' },
                make('div', { id: 'scene' }, stage.floor.svg),
                make('div', { id: 'player' }, ...stage.player.elements())),
            make('section', { id: 'events', 'aria-label': 'What happened' },
                make('h2', {}, 'What happened'), stage.happenings.list),
            make('section', { id: 'robots', 'aria-label': 'Robots' }, ...stage.cards.cards.map((each) => each.card)));
        stage.player.go(0);
        document.body.dataset.floor = String(stage.recording.events.length);
    }
}
