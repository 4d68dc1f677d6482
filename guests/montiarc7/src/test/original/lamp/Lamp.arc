package lamp;

import lamp.colours.Colour;
import lamp.colours.Wish;

/** States within states: what is left, what is entered, and which transition comes first. */
component Lamp {
  port <<sync>> in Wish wish;
  port <<sync>> out Colour colour, <<sync>> out boolean blink, <<sync>> out int left, <<sync>> out int entered;

  int exits = 0;
  int entries = 0;

  automaton {
    initial state Off {
      entry / { blink = false; }
      do / { colour = Colour.DARK; }
    };

    state On {
      entry / { entries = entries + 10; entered = entries; }
      exit / { exits++; left = exits; }

      initial state Red {
        exit / exits += 100;;
      };
      state Free {
        initial state Amber;
        state Green { entry / { entries++; } do / { blink = true; } };
      };
      // one that begins nowhere in it
      state Open {
        state Hidden;
      };

      Red -> Free [wish == Wish.GO];
      Amber -> Green / { colour = Colour.AMBER; };
      Green -> Red [wish.equals(Wish.STOP)] / { colour = Colour.RED; };
      Free -> Open [wish == Wish.STOP];
      Open -> Hidden [wish == Wish.GO];
    };

    Off -> On [wish == Wish.GO] / { colour = Colour.RED; };
    On -> Off [wish == Wish.OFF || wish == Wish.STOP];
  }
}
