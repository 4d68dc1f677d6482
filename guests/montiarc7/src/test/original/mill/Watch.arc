package mill;

/** Says how often the mill ran too fast, and what it has to say goes to a terminal, too. */
<<test, ticks = 3, speeds = [5, -1], expected = {[Untimed<5, -1>]}, failure = java.lang.Error.class>>
component Watch {
  port sync in int speed, sync out boolean alarm;
  int turns = 0;

  ------------
  pre: speed >= 0;
  post: alarm == true;

  automaton {
    initial state Calm [turns < 3];
    state Loud [turns == 3] {
      entry / { System.out.println("too often"); }
    }

    Calm -> Calm [speed > 9 && turns < 2] / {
      turns++;
      Log.info("turn " + turns);
      alarm = false;
    }
    Calm -> Loud [speed > 9] / { turns++; alarm = true; }
    Loud -> Calm [speed <= 9] / { turns = 0; alarm = false; }
  }
}
