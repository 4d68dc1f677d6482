package mill;

import lamp.Colours.Colour.*;
import lamp.Colours.Wish.GO;
import lamp.Colours.Wish;

/** A type of another package comes with its constants, or with one of them. */
component Paint {
  port <<sync>> out Colour colour, <<sync>> in Wish wish;

  <<sync>> automaton {
    initial state Dry;
    Dry -> Dry [wish == GO] / { colour = GREEN; };
    Dry -> Dry / { colour = Colour.DARK; };
  }
}
