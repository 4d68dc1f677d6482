package mill;

/** Three belts, of which one is there in slow mills only. */
component Belts {
    feature slow;
    feature easy;
    port in Integer i, out Integer o, out Integer waiting;
    constraint (slow || !easy);
    varif (slow) {
        port out Integer late;
        component Belt(9, slow = true) last;
        connect i -> last.i;
        connect last.o -> late;
    }
    component Belt(5, slow = false) first;
    component Belt(most = 7, slow = easy) second;
    connect i -> first.i, second.i;
    connect first.o -> o;
    connect second.o -> waiting;
}
