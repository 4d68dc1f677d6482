package door.plan;

import door.Orders.*;

/** What a door promises. */
component Door {
  port <<sync>> in Order order, <<sync>> out Answer answer;

  automaton {
    initial state Shut;
    state Open;

    Shut -> Open [order == Order.OPEN] / { answer = Answer.DONE; };
    Shut -> Shut [order == Order.SHUT] / { answer = Answer.REFUSED; };
    Open -> Shut [order == Order.SHUT] / { answer = Answer.DONE; };
    Open -> Open [order == Order.OPEN] / { answer = Answer.REFUSED; };
  }
}
