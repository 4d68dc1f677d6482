package mill;

testsuite DeskTest for Desk {
    test copies {
        input {
            number: <5, Tk, 6, Tk>;
        }
        expect {
            copy: <5, Tk, 6, Tk>;
        }
    }
}
