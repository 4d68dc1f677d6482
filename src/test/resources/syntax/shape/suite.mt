package robot;
testsuite AvoidCrashTest for robot.AvoidCrash(3, fast) {
    Integer x = 5, y;
    @Before { x = 1; }
    test meeting {
        input { frontUS: <clear, 3*Tk, tooClose, Tk>; left.value: <>; }
        expect { cmd: <fwd, 2*(Tk, -1, (a, b)), Types.stop, Cup(3), p.Cup("x")>; }
        @After { if (x) { } }
    }
    test events {
        events { frontUS: clear; timerSig: 2*alert; x: <a, Tk, b>; state: -5; }
    }
    test test { }
}
