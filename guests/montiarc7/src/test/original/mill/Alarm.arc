package mill;
import mill.Signals.Switch;

/** Nobody says yet which pipes the horns have, but for one. */
component Alarm {
  feature loud;
  port sync in int i, sync out int siren, rest, horn, second;

  constraint (loud implies left.high);
  constraint (right.low == loud);

  Siren siren1(3, Switch.ON), siren2(power = Switch.OFF, tone = 4);
  Horn left, right;

  i -> siren1.i, siren2.i, left.i, right.i;
  siren1.o -> siren;
  siren2.o -> rest;
  left.o -> horn;
  right.o -> second;
}
