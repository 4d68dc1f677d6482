package mill;
import mill.Signals.*;

/** Loud at once, or not at all. */
component Siren(int tone, Switch power = Switch.OFF) {
  port sync in int i, sync out int o;

  varif (power == Switch.ON) {
    compute { o = i + tone; }
  }
  varif (Switch.OFF == power) {
    compute { o = 0; }
  }
}
