package mill;

import lamp.Colours.Colour;
import lamp.Colours.Wish;

/** A type of another package comes with its constants, or with one of them. */
component Paint {
    timing instant;
    port out Colour colour, in Wish wish;
    <<completion = "ignore">> automaton {
        state Dry;
        initial Dry;
        Dry -> Dry [wish == GO] / do {
            colour = GREEN;
        };
        Dry -> Dry [wish == -- || wish != GO] / do {
            colour = Colour.DARK;
        };
    }
}
