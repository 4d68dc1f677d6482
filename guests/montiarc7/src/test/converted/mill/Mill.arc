package mill;

import mill.Signals.Switch;

component Mill {
    port in Switch press, in Boolean blocked, out Boolean open, out Integer count;
    component Gate(2) g;
    component Pass<Boolean> p;
    connect press -> g.press;
    connect blocked -> g.blocked;
    connect g.open -> p.i;
    connect p.o -> open;
    connect g.count -> count;
}
