package mill;

/** Carries at once, or first onto a heap; how much it carries is another matter. */
component Belt(Integer most) {
    feature slow;
    timing instant;
    port in Integer i, out Integer o;
    varif (slow) {
        component Bin<Integer>(0) heap;
        connect i -> heap.i;
        connect heap.o -> o;
    } else {
        <<completion = "ignore">> compute {
            o = i < most ? i : most;
        }
    }
}
