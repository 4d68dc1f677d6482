package p;

component Mind {
    timing untimed;

    port in Boolean pressed, <<state = "255">> in Integer[0..255] distance, in Boolean enough, out Integer speed;

    <<completion = "ignore">> automaton {
        state driving, backing, standing;

        initial driving / {speed = 360};

        driving -> backing [distance < 20] {pressed == true} / {speed = -360};
        backing -> driving {pressed == true} / {speed = 360};
        driving -> standing {enough == true} / {speed = 0};
        backing -> standing {enough == true} / {speed = 0};
    }
}
