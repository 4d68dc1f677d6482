package mill;

component PressHall {
  feature careful, twice;
  constraint (careful != twice);

  port sync in int weight;
  port sync out int pressed;

  Press first(9);
  constraint (first.slow == careful && !first.counting);

  weight -> first.weight;
  varif (twice) {
    Press second(counting = false);
    constraint (second.slow);
    first.pressed -> second.weight;
    second.pressed -> pressed;
  }
  varif (careful) first.pressed -> pressed;
}
