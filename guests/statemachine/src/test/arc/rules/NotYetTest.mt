package rules;

testsuite NotYetTest for NotYet {
    test historyBegins {
        input { event: <resume, Tk>; }
        expect {
            began: <Tk, 1, Tk>;
            beganWithin: <Tk, 1, Tk>;
            entered: <Tk, 1, Tk>;
        }
    }

    test deepHistoryBeginsOnAllLevels {
        input { event: <jump, Tk>; }
        expect {
            began: <Tk, 1, Tk>;
            beganWithin: <Tk, 1, Tk>;
            entered: <Tk, 1, Tk>;
        }
    }

    test historyOfAnInnerStateBeginsThatOneAlone {
        input { event: <within, Tk>; }
        expect {
            began: <2*Tk>;
            beganWithin: <Tk, 1, Tk>;
            entered: <Tk, 1, Tk>;
        }
    }

    test afterThatHistoryBeginsTheStateWithin {
        input { event: <resume, Tk, leave, Tk, resume, Tk>; }
        expect {
            began: <Tk, 1, 3*Tk>;
            beganWithin: <Tk, 1, 2*Tk, 1, Tk>;
            entered: <Tk, 1, 2*Tk, 1, Tk>;
        }
    }

    test afterThatDeepHistoryBeginsNothing {
        input { event: <resume, Tk, leave, Tk, jump, Tk>; }
        expect {
            began: <Tk, 1, 3*Tk>;
            beganWithin: <Tk, 1, 3*Tk>;
            entered: <Tk, 1, 2*Tk, 1, Tk>;
        }
    }

    test fromWithinThereIsAlwaysALast {
        input { event: <resume, Tk, next, Tk, again, Tk>; }
        expect {
            began: <Tk, 1, 3*Tk>;
            beganWithin: <Tk, 1, 3*Tk>;
            entered: <Tk, 1, Tk, 2, Tk, 2, Tk>;
        }
    }
}
