//// BadValue.arc
component BadValue {
  port in Integer step, in Boolean go, out Integer count;

  automaton {
    variable Integer sum = 0;
    state counting;
    initial counting;
    counting / do {
      sum = step / sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      count = sum + sum;
//            ~~~~~~~~~ error ARC0345: written out with what was assigned before, this value has 2047 parts, and at most 2000 are looked at where something may go wrong or be missing; keep something in between in a variable of the automaton, and go on in the next step
    };
  }
}

//// GoodChoices.arc
component GoodChoices {
  port in Integer step, in Boolean go, out Integer count;

  automaton {
    variable Integer sum = 0;
    state counting;
    initial counting;
    counting / do {
      sum = 100 / sum;
      if (go == true) { sum = sum + sum; }
      if (go == true) { sum = sum + sum; }
      if (go == true) { sum = sum + sum; }
      if (go == true) { sum = sum + sum; }
      if (go == true) { sum = sum + sum; }
      count = sum + sum;
    };
  }
}

//// BadStart.arc
component BadStart {
  port in Integer step, in Boolean go, out Integer count;

  automaton {
    variable Integer sum = 0;
    state counting;
    initial counting / do {
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
//          ~~~~~~~~~ error ARC0345: written out with what was assigned before, this value has 2047 parts, and at most 2000 are looked at before the first slice; compute it in a transition
    };
    counting;
  }
}

//// Good.arc
component Good {
  port in Integer step, in Boolean go, out Integer count;

  automaton {
    variable Integer sum = 0;
    state counting;
    initial counting;
    counting / do {
      if (step > 0) { sum = sum + 0; }
      if (step > 1) { sum = sum + 1; }
      if (step > 2) { sum = sum + 2; }
      if (step > 3) { sum = sum + 3; }
      if (step > 4) { sum = sum + 4; }
      if (step > 5) { sum = sum + 5; }
      if (step > 6) { sum = sum + 6; }
      if (step > 7) { sum = sum + 7; }
      if (step > 8) { sum = sum + 8; }
      if (step > 9) { sum = sum + 9; }
      if (step > 10) { sum = sum + 10; }
      if (step > 11) { sum = sum + 11; }
      if (step > 12) { sum = sum + 12; }
      if (step > 13) { sum = sum + 13; }
      if (step > 14) { sum = sum + 14; }
      if (step > 15) { sum = sum + 15; }
      if (step > 16) { sum = sum + 16; }
      if (step > 17) { sum = sum + 17; }
      if (step > 18) { sum = sum + 18; }
      if (step > 19) { sum = sum + 19; }
      if (step > 20) { sum = sum + 20; }
      if (step > 21) { sum = sum + 21; }
      if (step > 22) { sum = sum + 22; }
      if (step > 23) { sum = sum + 23; }
      if (step > 24) { sum = sum + 24; }
      if (step > 25) { sum = sum + 25; }
      if (step > 26) { sum = sum + 26; }
      if (step > 27) { sum = sum + 27; }
      if (step > 28) { sum = sum + 28; }
      if (step > 29) { sum = sum + 29; }
      if (step > 30) { sum = sum + 30; }
      if (step > 31) { sum = sum + 31; }
      if (step > 32) { sum = sum + 32; }
      if (step > 33) { sum = sum + 33; }
      if (step > 34) { sum = sum + 34; }
      if (step > 35) { sum = sum + 35; }
      if (step > 36) { sum = sum + 36; }
      if (step > 37) { sum = sum + 37; }
      if (step > 38) { sum = sum + 38; }
      if (step > 39) { sum = sum + 39; }
    };
  }
}

//// GoodValue.arc
component GoodValue {
  port in Integer step, in Boolean go, out Integer count;

  automaton {
    variable Integer sum = 0;
    state counting;
    initial counting;
    counting / do {
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      sum = sum + sum;
      count = sum;
    };
  }
}
