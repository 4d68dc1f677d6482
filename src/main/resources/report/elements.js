// Elements. Whatever comes from a model becomes a text or an attribute, never markup.

const SVG = "http://www.w3.org/2000/svg";

/** An HTML element; properties that begin with "on" listen, false and null leave out. */
function element(name, properties = {}, ...children) {
  return fill(document.createElement(name), properties, children);
}

function shape(name, properties = {}, ...children) {
  return fill(document.createElementNS(SVG, name), properties, children);
}

function fill(made, properties, children) {
  for (const [key, value] of Object.entries(properties)) {
    if (key.startsWith("on")) {
      made.addEventListener(key.slice(2), value);
    } else if (value !== false && value !== null && value !== undefined) {
      made.setAttribute(key, value === true ? "" : value);
    }
  }
  made.append(...children.filter((child) => child !== null));
  return made;
}

function button(label, title, action, properties = {}) {
  return element("button", { type: "button", title, "aria-label": title, onclick: action, ...properties }, label);
}

/** Calls an action once before the browser draws next, however often it is asked for. */
function onceAFrame(action) {
  let asked = false;
  return () => {
    if (!asked) {
      asked = true;
      requestAnimationFrame(() => {
        asked = false;
        action();
      });
    }
  };
}

function clamp(value, low, high) {
  return Math.max(low, Math.min(high, value));
}
