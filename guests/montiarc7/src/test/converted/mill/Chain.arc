package mill;

/** Parts, parameters by name, and a component within. */
component Chain(Integer most, Integer offset = 1) extends Ends<Integer> {
    autoinstantiate off;
    autoconnect port;
    component Add(Integer by, Integer times = 1) {
        timing instant;
        port in Integer i, out Integer o;
        <<completion = "ignore">> compute {
            o = i + by * times;
        }
    }
    component Add(times = 2, by = offset) third;
    component Add(most) fourth;
    connect input -> third.i;
    connect third.o -> fourth.i;
    connect fourth.o -> output;
}
