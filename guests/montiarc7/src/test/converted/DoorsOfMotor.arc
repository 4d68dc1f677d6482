/** How the ports of Motor stand for those of Door. */
<<map>> component DoorsOfMotor {
    component Inputs {
        timing instant;
        port in Integer power, out door.Orders.Order order;
        <<completion = "ignore">> automaton {
            state mapping;
            initial mapping;
            mapping [power > 0] / {order = OPEN};
            mapping [power < 0] / {order = SHUT};
            mapping [power == 0] / {order = --};
        }
    }
    component Outputs {
        timing instant;
        port
            in Integer answerOfMotor,
            in Boolean stuck,
            out door.Orders.Answer answerOfDoor;
        <<completion = "ignore">> automaton {
            state mapping;
            initial mapping;
            mapping [stuck == true] / {answerOfDoor = REFUSED};
            mapping [(answerOfMotor != --) && (stuck == -- || stuck != true)]
                    / {answerOfDoor = DONE};
            mapping [answerOfMotor == -- && stuck == --] / {answerOfDoor = --};
        }
    }
}
