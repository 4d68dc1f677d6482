//// BadGuard.arc
component BadGuard {
  port in Boolean tooClose, out Integer speed;

  automaton {
    state driving;
    initial driving / {speed = 3};
    driving {tooClose == true} / {speed = alt {0, 1}};
//                                        ~~~~~~~~~~ error ARC0311: 'alt' says what is waited for; to leave open what is sent, write one transition for each of the 2 alternatives
  }
}

//// GoodGuard.arc
component GoodGuard {
  port in Boolean tooClose, out Integer speed;

  automaton {
    state driving;
    initial driving / {speed = 3};
    driving {tooClose == true} / {speed = 0};
    driving {tooClose == true} / {speed = 1};
  }
}
