// The findings as a list: each goes to its place, and repairs itself where that is safe.

import { button, make } from './elements.js';

/** Shows findings; `go` opens a place, `repair` makes a repair. */
export function showFindings(list, findings, go, repair) {
    const focused = document.activeElement && list.contains(document.activeElement);
    list.replaceChildren(...findings.map((finding) => entry(finding, go, repair)));
    if (findings.length === 0) {
        list.append(make('li', { class: 'none' }, 'none'));
    }
    if (focused) {
        (list.querySelector('button') || list.closest('section')).focus();
    }
}

function entry(finding, go, repair) {
    const place = finding.path.split('/').pop() + ':' + finding.line;
    const entry = make('li', { class: finding.severity },
        button(`${finding.severity} ${finding.code}`, () => go(finding), {
            class: 'place',
            'aria-label': `${finding.severity} ${finding.code} at ${place}: ${finding.message}`,
        }),
        make('span', { class: 'where' }, ' ' + place + ' '),
        make('span', {}, finding.message + ' '));
    if (finding.fix) {
        entry.append(button(finding.fix.title, () => repair(finding.fix), { class: 'fix' }));
    }
    for (const related of finding.related) {
        entry.append(make('div', { class: 'related' },
            button(related.path.split('/').pop() + ':' + related.line, () => go(related), {}),
            ' ' + related.note));
    }
    return entry;
}
