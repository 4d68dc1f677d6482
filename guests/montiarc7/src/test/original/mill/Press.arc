package mill;

/* Presses what comes, at once or one slice later. */
component Press(int most = 5) {
  feature slow, counting;

  // Counting takes its time.
  constraint (counting implies slow);

  port sync in int weight;

  varif (slow) {
    port sync out int pressed;
    init { pressed = 0; }
    <<delayed>> compute {
      if (weight > most) { pressed = most; } else { pressed = weight; }
    }
  } else varif (counting == slow) {
    port sync out int pressed;
    compute { pressed = weight; }
  }
}
