package mill;

import mill.Post.*;

testsuite CounterTest for Counter {
    test looksAtParcels {
        input {
            parcel: <Express(9, Label("Bonn", FAST), 7), Tk, Express(2, Label("Aachen", SLOW), 1), Tk, Tk>;
            most: <4, Tk, 4, Tk, 4, Tk>;
        }
        expect {
            heavy: <true, Tk, Tk, Tk>;
            rest: <6, Tk, Tk, Tk>;
            near: <Tk, true, Tk, Tk>;
            label: <Tk, Label("Aachen", SLOW), Tk, Tk>;
        }
    }
}
