// profile: executable
//// Bad.arc
component Bad {
  component Motor {
    port in Integer power, out Integer turns;

    automaton {
      state s;
      initial s;
      s;
    }
  }

  component Motor left, right;
//                ~~~~ error ARC0110: input 'power' of 'left' has no sender; code needs to know what arrives there
//                      ~~~~~ warning ARC0109: output 'turns' of 'right' is read by nobody; connect it

  connect left.turns -> right.power;
}

//// Good.arc
component Good {
  port in Integer speed, out Integer turns;

  component Motor motor {
    port in Integer power, out Integer turns;

    automaton {
      state s;
      initial s;
      s;
    }
  }

  connect speed -> motor.power;
  connect motor.turns -> turns;
}
