package mill;

/** Parts, parameters by name, and a component within. */
component Chain(int most, int offset = 1) extends Ends<Integer> {
  autoconnect port;

  component Add(int by, int times = 1) {
    port sync in int i, sync out int o;

    compute { o = i + by * times; }
  }

  Add third(times = 2, by = offset), fourth(most);

  input -> third.i;
  third.o -> fourth.i;
  fourth.o -> output;
}
