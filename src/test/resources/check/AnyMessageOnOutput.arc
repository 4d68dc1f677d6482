// profile: executable
//// BadGuard.arc
component BadGuard {
  port in Boolean tooClose, out Integer speed;

  automaton {
    state driving;
    initial driving / {speed = 3};
    driving {tooClose == true} / {speed = ?};
//                                        ~ error ARC0333: '?' leaves open what is sent, so no code can be generated; write the message
  }
}

//// GoodGuard.arc
component GoodGuard {
  port in Boolean tooClose, out Integer speed;

  automaton {
    state driving;
    initial driving / {speed = 3};
    driving {tooClose == true} / {speed = 0};
  }
}
