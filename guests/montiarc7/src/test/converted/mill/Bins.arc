package mill;

/** Two bins in a row. */
component Bins {
    port in Integer i, out Integer o;
    component Bin<Integer>(1) left;
    component Bin<Integer>(2) right;
    connect i -> left.i;
    connect left.o -> right.i;
    connect right.o -> o;
}
