package mill;
import mill.Signals.*;
component Mill {
  port sync in Switch press, sync in boolean blocked, sync out boolean open, sync out int count;
  Gate g(2);
  Pass<Boolean> p;
  press -> g.press; blocked -> g.blocked;
  g.open -> p.i; p.o -> open; g.count -> count;
}
