package mill;

/** What no feature decides is chosen when it is converted. */
component Settled {
  feature fast;

  varif (fast || 1 <= 2) {
    port <<sync>> in int a, <<sync>> out int b;

    varif (!true) {
      <<sync>> compute { b = 0; }
    } else varif (fast) {
      <<sync>> compute { b = 2; }
    } else {
      <<sync>> compute { b = a; }
    }
  }

  varif (fast && false) {
    port <<sync>> in Unknown never;
  }

  constraint (true && (fast implies 3 > 2));
}
