package mill;

/** What it does is said elsewhere: the speed follows at once, the heat a slice later. */
component Shaft {
  port <<sync>> in int power, <<sync>> out int speed, <<sync, delayed>> out int heat;
}
