/** How the ports of WeakMotor stand for those of Door. */
<<map>> component DoorsOfWeakMotor {
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
            in Integer answerOfWeakMotor,
            in Boolean stuck,
            out door.Orders.Answer answerOfDoor;
        <<completion = "ignore">> automaton {
            state mapping;
            initial mapping;
            mapping [stuck == true] / {answerOfDoor = REFUSED};
            mapping [(answerOfWeakMotor != --) && (stuck == -- || stuck != true)]
                    / {answerOfDoor = DONE};
            mapping [answerOfWeakMotor == -- && stuck == --] / {answerOfDoor = --};
        }
    }
}
