package door.plan;

import door.Orders.Answer;
import door.Orders.Order;

/** What a door promises. */
component Door {
    timing instant;
    port in Order order, out Answer answer;
    <<completion = "ignore">> automaton {
        state Shut, Open;
        initial Shut;
        Shut -> Open [order == Order.OPEN] / do {
            answer = Answer.DONE;
        };
        Shut -> Shut [order == Order.SHUT] / do {
            answer = Answer.REFUSED;
        };
        Open -> Shut [order == Order.SHUT] / do {
            answer = Answer.DONE;
        };
        Open -> Open [order == Order.OPEN] / do {
            answer = Answer.REFUSED;
        };
    }
}
