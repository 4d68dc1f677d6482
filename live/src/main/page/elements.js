// Pieces of the page. Texts of models are texts, never markup.

/** An element with attributes and children; texts become text. */
export function make(name, attributes, ...children) {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes || {})) {
        if (key.startsWith('on')) {
            element.addEventListener(key.slice(2), value);
        } else if (value === true) {
            element.setAttribute(key, '');
        } else if (value !== false && value !== null && value !== undefined) {
            element.setAttribute(key, value);
        }
    }
    element.append(...children);
    return element;
}

export function byId(id) {
    return document.getElementById(id);
}

export function button(label, action, attributes) {
    return make('button', { type: 'button', onclick: action, ...attributes }, label);
}
