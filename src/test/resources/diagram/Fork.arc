/** A wire that forks has a dot there; wires that only cross each other have none. */
component Fork {
    port in Integer a, in Integer b, out Integer c, out Integer d, out Integer e;

    component Twice {
        port in Integer x, out Integer y;
    }

    component Twice first;
    component Twice second;

    connect a -> first.x, second.x;
    connect b -> e;
    connect first.y -> d;
    connect second.y -> c;
}
