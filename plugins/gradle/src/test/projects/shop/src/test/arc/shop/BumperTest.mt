package shop;

testsuite BumperTest for shop.Bumper {
    test stops {
        input {
            wall: <true, 2*Tk>;
        }
        expect {
            wheels: <go, Tk, halt, Tk>;
        }
    }
}
