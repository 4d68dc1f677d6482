package rules;

testsuite KnownTest for Known {
    test enteringGoesFromOuterToInner {
        input { event: <enter, Tk, within, Tk>; }
        expect {
            enteredOuter: <Tk, true, Tk, Tk>;
            entered: <Tk, 1, Tk, Tk>;
            sum: <Tk, Tk, 2, Tk>;
        }
    }

    test aStepInsideLeavesNothingAround {
        input { event: <enter, Tk, next, Tk, within, Tk>; }
        expect {
            leftOuter: <4*Tk>;
            enteredOuter: <Tk, true, 3*Tk>;
            left: <2*Tk, 1, 2*Tk>;
            entered: <Tk, 1, Tk, 2, 2*Tk>;
            sum: <3*Tk, 3, Tk>;
        }
    }

    test anInnerTransitionLeavesNothing {
        input { event: <enter, Tk, within, Tk>; }
        expect {
            left: <3*Tk>;
            leftOuter: <3*Tk>;
            sum: <Tk, Tk, 2, Tk>;
        }
    }

    test aLoopLeavesAndBeginsAnew {
        input { event: <enter, Tk, next, Tk, again, Tk>; }
        expect {
            left: <2*Tk, 1, Tk, 2, Tk>;
            leftOuter: <3*Tk, true, Tk>;
            enteredOuter: <Tk, true, 2*Tk, true, Tk>;
            entered: <Tk, 1, Tk, 2, Tk, 1, Tk>;
        }
    }

    test aStepFromAStateToOneInItLeavesItFirst {
        input { event: <enter, Tk, jump, Tk>; }
        expect {
            left: <2*Tk, 1, Tk>;
            leftOuter: <2*Tk, true, Tk>;
            enteredOuter: <Tk, true, Tk, true, Tk>;
            entered: <Tk, 1, Tk, 2, Tk>;
        }
    }

    test aStepToAStateAroundLeavesItToo {
        input { event: <enter, Tk, next, Tk, up, Tk>; }
        expect {
            leftOuter: <3*Tk, true, Tk>;
            enteredOuter: <Tk, true, 2*Tk, true, Tk>;
            entered: <Tk, 1, Tk, 2, Tk, 1, Tk>;
        }
    }

    test historyGoesOnWithTheLast {
        input { event: <enter, Tk, next, Tk, leave, Tk, resume, Tk>; }
        expect {
            entered: <Tk, 1, Tk, 2, 2*Tk, 2, Tk>;
            sum: <3*Tk, 3, 2*Tk>;
        }
    }

    test whatWasNeverInBegins {
        input { event: <resume, Tk>; }
        expect { entered: <Tk, 1, Tk>; }
    }

    test enteringBeginsAnew {
        input { event: <enter, Tk, next, Tk, leave, Tk, enter, Tk>; }
        expect { entered: <Tk, 1, Tk, 2, 2*Tk, 1, Tk>; }
    }
}
