// Texts of a page that stand out too little against what is behind them: each with its contrast, as WCAG 2.1 defines it.

const channels = (colour) => {
  const numbers = colour.match(/[\d.]+/g).map(Number);
  return numbers.length > 3 ? numbers : [...numbers, 1];
};
const linear = (value) => (value / 255 <= 0.04045 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4);
const luminance = ([red, green, blue]) => 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue);
const over = (top, below) => [0, 1, 2].map((each) => top[each] * top[3] + below[each] * (1 - top[3]));

/** What an element paints behind all that lies above it; empty for what is only a line or a text. */
function painted(element) {
  const style = getComputedStyle(element);
  const isShape = element instanceof SVGElement && element.tagName !== "svg";
  const colour = isShape ? (element.tagName === "rect" ? style.fill : "none") : style.backgroundColor;
  return colour === "none" ? [] : [channels(colour)].filter((each) => each[3] > 0);
}

function ground(element, stack) {
  const isText = element instanceof SVGElement;
  const layers = stack.slice(stack.indexOf(element) + (isText ? 1 : 0)).flatMap(painted);
  const paper = matchMedia("(prefers-color-scheme: dark)").matches ? [18, 18, 18] : [255, 255, 255];
  return layers.reverse().reduce((below, top) => over(top, below), paper);
}

const faint = [];
let measured = 0;
for (const element of document.querySelectorAll("body *:not(script, style, template, noscript, title)")) {
  const says = [...element.childNodes].some((each) => each.nodeType === Node.TEXT_NODE && each.textContent.trim() !== "");
  const { x, y, width, height } = element.getBoundingClientRect();
  const stack = says && width > 0 ? document.elementsFromPoint(x + width / 2, y + height / 2) : [];
  if (stack.includes(element)) {
    const style = getComputedStyle(element);
    const behind = ground(element, stack);
    const text = over(channels(element instanceof SVGElement ? style.fill : style.color), behind);
    const [dark, light] = [luminance(text), luminance(behind)].sort((one, other) => one - other);
    const contrast = (light + 0.05) / (dark + 0.05);
    measured++;
    if (contrast < 4.5) {
      faint.push(`${contrast.toFixed(2)}: '${element.textContent.trim()}' in ${element.parentElement.className.baseVal || element.parentElement.className}`);
    }
  }
}
return measured < 5 ? ["no texts were measured"] : faint;
