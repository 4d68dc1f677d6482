package lamp;

import lamp.Colours.Colour;
import lamp.Colours.Wish;

/** States within states: what is left, what is entered, and which transition comes first. */
component Lamp {
    timing instant;
    port in Wish wish;
    port out Colour colour, out Boolean blink, out Integer left, out Integer entered;
    Integer exits = 0;
    Integer entries = 0;
    <<completion = "ignore">> automaton {
        state OffAtFirst, Off, Red, Amber, Green, Open, Hidden;
        initial OffAtFirst;
        OffAtFirst -> Red [wish == Wish.GO] / do {
            blink = false;
            colour = Colour.RED;
            entries = entries + 10;
            entered = entries;
        };
        OffAtFirst -> Off [wish == -- || wish != Wish.GO] / do {
            blink = false;
            colour = Colour.DARK;
        };
        Off -> Red [wish == Wish.GO] / do {
            colour = Colour.RED;
            entries = entries + 10;
            entered = entries;
        };
        Off -> Off [wish == -- || wish != Wish.GO] / do {
            colour = Colour.DARK;
        };
        Red -> Amber [wish == Wish.GO] / do {
            exits += 100;
        };
        Red -> Off [(wish == Wish.OFF || wish == Wish.STOP) && (wish == -- || wish != Wish.GO)]
                / do {
            exits += 100;
            exits++;
            left = exits;
            blink = false;
            colour = Colour.DARK;
        };
        Amber -> Green / do {
            colour = Colour.AMBER;
            entries++;
            blink = true;
        };
        Green -> Red [wish == Wish.STOP] / do {
            colour = Colour.RED;
        };
        Green -> Off [(wish == Wish.OFF || wish == Wish.STOP)
                && (wish == -- || !(wish == Wish.STOP)) && (wish == -- || wish != Wish.STOP)] / do {
            exits++;
            left = exits;
            blink = false;
            colour = Colour.DARK;
        };
        Green -> Green [(wish == -- || !(wish == Wish.STOP)) && (wish == -- || wish != Wish.STOP)
                && ((wish == -- || wish != Wish.OFF) && (wish == -- || wish != Wish.STOP))] / do {
            blink = true;
        };
        Open -> Hidden [wish == Wish.GO];
        Open -> Off [(wish == Wish.OFF || wish == Wish.STOP) && (wish == -- || wish != Wish.GO)]
                / do {
            exits++;
            left = exits;
            blink = false;
            colour = Colour.DARK;
        };
        Hidden -> Hidden [wish == Wish.GO];
        Hidden -> Off [(wish == Wish.OFF || wish == Wish.STOP) && (wish == -- || wish != Wish.GO)]
                / do {
            exits++;
            left = exits;
            blink = false;
            colour = Colour.DARK;
        };
    }
}
