package fetcher;

testsuite FetcherTest for Fetcher {
    test goesOnWhereItWas {
        input {
            cup: <true, Tk>;
            front: <Tk, tooClose, 4*Tk, clear, Tk>;
            button: <2*Tk, press, 2*Tk, press, Tk>;
        }
        expect {
            cmd: <fwd, Tk, fwd, Tk, stop, Tk, stop, 2*Tk, stop, Tk, fwd, Tk>;
            lamp: <green, 3*Tk, red, 2*Tk, green, Tk>;
        }
    }
}
