package mill;

testsuite CodeTest for Code {
    test isAsInJava {
        input {
            a: <13, Tk, -13, Tk, -2147483648, Tk, 0, Tk, 4, Tk>;
            b: <13, Tk, 2, Tk, 2147483647, Tk, 0, Tk, 7, Tk>;
            c: <5000000000L, Tk, -1L, Tk, 2147483647L, Tk, 0L, Tk, 1L, Tk>;
            p: <true, Tk, true, Tk, false, Tk, false, Tk, true, Tk>;
            q: <true, Tk, false, Tk, true, Tk, false, Tk, true, Tk>;
        }
        expect {
            low: <5, Tk, 3, Tk, 0, Tk, 0, Tk, 4, Tk>;
            half: <6, Tk, -7, Tk, -1073741824, Tk, 0, Tk, 2, Tk>;
            more: <1073741824, Tk, -1073741824, Tk, 0, Tk, 0, Tk, 0, Tk>;
            upper: <0, Tk, 15, Tk, 8, Tk, 0, Tk, 0, Tk>;
            other: <-27, Tk, 10, Tk, 0, Tk, -1, Tk, -12, Tk>;
            far: <2L, Tk, 8589934591L, Tk, 0L, Tk, 0L, Tk, 0L, Tk>;
            both: <true, Tk, false, Tk, false, Tk, false, Tk, true, Tk>;
            one: <false, Tk, true, Tk, true, Tk, false, Tk, false, Tk>;
            any: <true, Tk, true, Tk, true, Tk, false, Tk, true, Tk>;
            high: <true, Tk, true, Tk, true, Tk, false, Tk, false, Tk>;
            same: <true, Tk, false, Tk, false, Tk, true, Tk, false, Tk>;
            clear: <false, Tk, false, Tk, false, Tk, true, Tk, false, Tk>;
            over: <false, Tk, false, Tk, false, Tk, false, Tk, false, Tk>;
            none: <true, Tk, false, Tk, false, Tk, true, Tk, true, Tk>;
            some: <true, Tk, true, Tk, true, Tk, true, Tk, true, Tk>;
            differ: <false, Tk, false, Tk, true, Tk, false, Tk, false, Tk>;
        }
    }

    test knowsSumsThatAreTooLarge {
        input {
            a: <2147483647, Tk, -2147483648, Tk, -5, Tk>;
            b: <1, Tk, -1, Tk, -6, Tk>;
            c: <-1L, Tk, 1L, Tk, 0L, Tk>;
            p: <true, Tk, true, Tk, true, Tk>;
            q: <true, Tk, true, Tk, true, Tk>;
        }
        expect {
            over: <true, Tk, true, Tk, false, Tk>;
            none: <true, Tk, false, Tk, false, Tk>;
            some: <true, Tk, false, Tk, false, Tk>;
            differ: <true, Tk, true, Tk, true, Tk>;
        }
    }
}
