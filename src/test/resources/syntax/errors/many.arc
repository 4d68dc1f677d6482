package p;
import a.b
component Broken {
    port in Integer a out Integer b;
    port Integer c;
    connect a -> b
    connect c > d;
    foo;
    automaton A {
        state x, y
        initial x / {cmd = };
        x -> y [a = b] {p == 1} / {q = 2};
        x -> y [a & b];
        x => y;
        x -> y {p = 1 / {q = 2};
        ) x;
        int z;
        variable new = 5;
        x -> y [a >] {b} / {c};
        x -> y [a b] {b} / {c};
        x -> y {a b};
        y -> x {if (a) b = 1;} / {c};
        x -> y;
    }
    timing fast;
    autoconnect ports;
    component Sub(1, 2 a;
    component Sub2 {
       port in;
    }
    component Inner { state A; }
    connect a -> ;
    ocl inv a b;
    port in Integer[0..] r;
    port in Integer#x r;
}
}
