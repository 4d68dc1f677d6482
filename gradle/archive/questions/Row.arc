component Row {
    port in Boolean i, out Boolean o;
    component Cell a, b, c;
    connect i -> a.i;
    connect a.o -> b.i;
    connect b.o -> c.i;
    connect c.o -> o;
}
