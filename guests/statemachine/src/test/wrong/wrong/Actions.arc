package wrong;

component Actions {
    port in Boolean go, out Integer x;

    component Twice {
        port in Boolean go, out Integer x;

        statemachine {
            initial one;
            state one { entry / {x = 0}; entry / {x = 1}; }
        }
    }

    component Short {
        port in Boolean go, out Integer x;

        statemachine {
            initial one;
            state one;
            one {go == true} / {3};
        }
    }

    component TwoMessages {
        port in Boolean go, out Integer x;

        statemachine {
            initial one;
            state one { exit / {x = 0}; }
            state two { entry / {x = 1}; }
            one -> two {go == true};
            one -> two {go == false} / {x = 3};
            two {go == true} / {x = 3, x = 4};
        }
    }

    component ReadBack {
        port in Boolean go, out Integer x;

        statemachine {
            variable Integer n = 0, unused;
            initial one;
            state one { exit / {n = n + 1}; }
            state two { entry / {n = 0}; }
            one -> two {go == true} / {x = n};
            two -> one {go == true} / {n = 1, unused = n};
        }
    }

    component TwoOnTheFirstTime {
        port in Boolean go, out Integer x;

        statemachine {
            initial outside;
            state outside;
            state around {
                initial one / {x = 0};
                state one;
            }
            outside -> around.history {go == true} / {x = 1};
            around -> outside {go == true};
        }
    }

    component OneOnAllLaterTimes {
        port in Boolean go, out Integer x;

        statemachine {
            initial around;
            state outside;
            state around {
                initial one / {x = 0};
                state one;
            }
            outside -> around.history {go == true} / {x = 1};
            around -> outside {go == true};
        }
    }
}
