package house;

testsuite TwoKeyboardsTest for TwoKeyboards {
    test presses {
        input { key[0]: <true>; }
        expect { pressed[0]: <0>; }
    }
}
