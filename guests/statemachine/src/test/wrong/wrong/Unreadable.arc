package wrong;

component Unreadable {
    port in Boolean go, out Integer x;

    component MissingArrow {
        port in Boolean go, out Integer x;

        statemachine {
            initial one;
            state one, two;
            one > two {go == true};
        }
    }

    component EntryOutside {
        port in Boolean go, out Integer x;

        statemachine {
            entry / {x = 1};
            initial one;
            state one;
        }
    }

    component WordAsName {
        port in Boolean go, out Integer x;

        statemachine {
            initial exit;
            state exit;
        }
    }

    component UnknownHistory {
        port in Boolean go, out Integer x;

        statemachine {
            initial one;
            state one { initial two; state two; }
            one -> one.past;
        }
    }

    component EndsEarly {
        port in Boolean go, out Integer x;

        statemachine {
            initial one;
            state one { entry / {x = 1} }
        }
    }

    component LateVariable {
        port in Boolean go, out Integer x;

        statemachine {
            initial one;
            state one { var Integer n = 0; }
        }
    }

    component WhoComesFirst {
        port in Boolean go, out Integer x;

        statemachine {
            priority middle;
            initial one;
            state one;
        }
    }

    component Undecided {
        port in Boolean go, out Integer x;

        statemachine {
            priority inner;
            priority outer;
            initial one;
            state one;
        }
    }

    component DoesTwice {
        port in Boolean go, out Integer x;

        statemachine {
            initial one;
            state one { do / {x = 1}; do / {x = 2}; }
        }
    }

    component BothDo {
        port in Boolean go, out Integer x;

        statemachine {
            initial one;
            state one {
                do / {x = 1};
                initial two;
                state two { do / {x = 2}; }
            }
        }
    }
}
