// What signs and colours mean: those that a picture has, and no others.

class Legend {
  /** A sign, how to find it in a picture, and what it says. */
  static SIGNS = [
    [".part.sensors", "box sensors", "sensors"],
    [".part.logic", "box logic", "logic"],
    [".part.actuators", "box actuators", "actuators"],
    [".port.instant", "port instant", "port that sends or takes at once"],
    [".port.delayed", "port delayed", "port that sends one slice later"],
    [".connector circle", "dot", "a wire forks; without it, wires only cross"],
    [".start:not(.junction)", "dot large", "begins here"],
    [".junction", "dot", "transitions that say the same go on as one"],
    [".group", "box group", "states within states"],
    [".enum", "box enum", "enumeration"],
    [".class", "box class", "class"],
    [".problem, .label-problem, .edge-problem", "box problem", "something is wrong"],
    [".never, .label-never, .edge-never", "box never", "never reached or taken"],
  ];

  static of(svg) {
    const list = document.createElement("ul");
    for (const [selector, sign, meaning] of Legend.SIGNS.filter(([each]) => svg.querySelector(each) !== null)) {
      const item = document.createElement("li");
      const mark = document.createElement("span");
      mark.className = `sign ${sign}`;
      item.append(mark, meaning);
      list.append(item);
    }
    return list;
  }
}
