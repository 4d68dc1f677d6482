package wrong;

component Names {
    port in Boolean go, out Integer x;

    statemachine {
        initial working;

        state working {
            initial inner;
            state driving { initial waiting; state waiting; }
            state waiting;
        }

        state paused {
            state deeper;
        }

        wroking -> paused {go == true};
        paused -> elsewhere {go == false};
        paused -> deeper.history;
    }
}
