// Pictures: the core says what is to be placed, the layout places it, the core draws it.

function number(value) {
    return String(Math.round((value || 0) * 100) / 100);
}

function points(all) {
    return all.flatMap(({ x, y }) => [number(x), number(y)]);
}

/** Where each node lies, seen from an outer one. */
function offset(node, parents, holder) {
    let x = 0;
    let y = 0;
    for (let at = node; at && at !== holder; at = parents.get(at)) {
        x += (at.x || 0) + ((at.padding && at.padding.left) || 0);
        y += (at.y || 0) + ((at.padding && at.padding.top) || 0);
    }
    return { x, y };
}

/** Where a wire meets an own port on the side of what is inside; the layout places that before it moves the port. */
function inside(node, name, left) {
    const port = node.ports.find((each) => each.id === name);
    return { x: port.x + (left ? port.width : 0), y: port.y + port.height / 2 };
}

/** A line for each element, as the core reads them. */
export function linesOf(root) {
    const lines = [];
    const parents = new Map();
    const byName = new Map();
    const padded = (node) => ({
        x: (node.padding && node.padding.left) || 0,
        y: (node.padding && node.padding.top) || 0,
    });
    const learn = (node, parent) => {
        parents.set(node, parent);
        byName.set(node.id, node);
        (node.children || []).forEach((child) => learn(child, node));
    };
    learn(root, null);
    const write = (node, inset) => {
        const { id, x, y, width, height } = node;
        lines.push([id, number((x || 0) + inset.x), number((y || 0) + inset.y), number(width), number(height)]);
        (node.ports || []).forEach((port) =>
            lines.push([port.id, number(port.x), number(port.y), number(port.width), number(port.height)]));
        (node.children || []).forEach((child) => write(child, padded(node)));
        (node.edges || []).forEach((edge) => {
            const source = byName.get(edge.source);
            const from = source === node ? node : parents.get(source);
            const shift = offset(from, parents, node);
            const own = padded(from === node ? node : from);
            const moved = (point) => ({ x: point.x + shift.x + own.x, y: point.y + shift.y + own.y });
            const way = [edge.sourcePoint, ...(edge.bendPoints || []), edge.targetPoint].map(moved);
            if (source === node) {
                way[0] = inside(node, edge.sourcePort, true);
            }
            if (edge.target === node.id) {
                way[way.length - 1] = inside(node, edge.targetPort, false);
            }
            const label = (edge.labels || [{}])[0] || {};
            const at = moved({ x: label.x || 0, y: label.y || 0 });
            lines.push([edge.id, number(at.x), number(at.y), String(way.length),
                ...points(way), ...points((edge.junctionPoints || []).map(moved))]);
        });
    };
    write(root, { x: 0, y: 0 });
    return lines.map((line) => line.join(' ')).join('\n');
}

/** Draws a component, with some of its parts closed, or one of its automata: SVG of the tool's own, with names of states and ports on its elements. */
export async function draw(desk, layout, component, automaton, closed) {
    const question = await desk.ask('graph', component, automaton, closed);
    const graph = JSON.parse(question);
    if (graph.refused) {
        return null;
    }
    const placed = await layout.place(graph);
    return desk.ask('picture', linesOf(placed));
}

/** Lights up what is so now, and puts out the rest. */
export function light(picture, kind, names, style) {
    picture.querySelectorAll('.' + style).forEach((each) => each.classList.remove(style));
    for (const name of names) {
        picture
            .querySelectorAll(`[data-${kind}="${CSS.escape(name)}"]`)
            .forEach((each) => each.classList.add(style));
    }
}

/**
 * Shows pictures of the core in a panel, each in a window of its own. What was there before under the same names stays as large,
 * and where it was.
 *
 * @param names of what they show
 * @param folded told a picture's number and the parts of it that were closed
 */
export function hang(panel, pictures, names, folded = () => {}) {
    const key = JSON.stringify(names);
    if (panel.dataset.names === key) {
        pictures.forEach((picture, number) => panel.viewers[number].renew(elementOf(picture)));
        return;
    }
    panel.dataset.names = key;
    panel.viewers = pictures.map((picture, number) => viewer(picture, names[number], (closed) => folded(number, closed)));
    panel.replaceChildren(...panel.viewers.map((each) => each.element));
}

/** A picture of the core in a window. */
export function viewer(picture, name, folded) {
    return new PictureViewer(elementOf(picture), name, folded);
}

function elementOf(picture) {
    const made = document.createElement('template');
    made.innerHTML = picture; // written by the core: texts are escaped
    return made.content.firstElementChild;
}
