package rules;

testsuite OuterFirstTest for OuterFirst {
    test outerTransitionsComeFirst {
        input {
            event: <next, Tk>;
            go: <true, Tk>;
        }
        expect { took: <Tk, 1, Tk>; }
    }

    test theOthersAreTakenAlone {
        input {
            event: <Tk, next, Tk>;
            go: <true, Tk, Tk>;
        }
        expect { took: <Tk, 1, Tk, 2, Tk>; }
    }

    test whatIsDoneMeanwhileIsDoneOnAllLevelsAndComesLast {
        input { event: <Tk, next, Tk, Tk>; }
        expect {
            within: <Tk, true, 3*Tk>;
            around: <Tk, 1, 2*Tk, 1, Tk>;
            took: <2*Tk, 2, 2*Tk>;
        }
    }
}
