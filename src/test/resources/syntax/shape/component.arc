package p.q;

import a.b.C;
import a.b.*;
import port.in.*;

/** Documented. */
<<deploy, layer = "logic">> abstract component Whole<T extends Number & Comparable<T>, K>(Integer n, T x = 5)
        extends Base<T, ?> refines p.Fig3, Fig5 {

    port in Integer a, b, <<total>> out p.Types.MotorCmd cmd, in Boolean, out List<? extends T>;
    ports in boolean port, out Integer[0..n + 1] out;
    <<state>> port in int[][] raw;

    component Sensor(1, "s") left, right [ value -> ctrl.in, other; <<suppress = "ARC0104: reason">> v -> x ];
    component Generic<Integer>;
    component p.Timer timer;

    component Inner in2 { }
    component Old[Integer n] { }
    component Empty { port in Integer state; autoinstantiate off; }

    connect a -> left.in, right.in;
    <<suppress = total>> connect x.y -> z;

    timing instant;
    timing <<x>> causalsync;
    behavior delayed;
    autoconnect port;
    autoconnect <<a>> type;
    autoinstantiate <<a = 0>> on;

    ocl inv limits: a < 5 & b |= "x;" ;
    java inv body: { if (a) { return '}'; } };
    inv plain: forall @pre;

    compute { x = f(1); }
    init first { y++; }
    var Integer counter = 0, k;
    Integer limit = 3 * n, m;
    List<Integer> more;
    implementation Impl { automaton { state A; initial A; } automaton Second { } }
    implementation { state A; initial A; A -> A; }
    implementation Nothing { }
}
