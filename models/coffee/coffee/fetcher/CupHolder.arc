package coffee.fetcher;

/**
 * Knows whether the fetcher carries coffee. A full cup is heavy enough to hold down the touch
 * sensor under it; two equal readings in a row are needed to change the verdict, so that a bump
 * on the way is not taken for a delivery.
 */
component CupHolder {
    port <<total>> in Boolean pressed, <<total>> out Boolean gotCoffee;

    automaton {
        state empty, settling, full, lifting;

        initial empty / {gotCoffee = false};

        empty {pressed == false} / {gotCoffee = false};
        empty -> settling {pressed == true} / {gotCoffee = false};
        settling -> empty {pressed == false} / {gotCoffee = false};
        settling -> full {pressed == true} / {gotCoffee = true};

        full {pressed == true} / {gotCoffee = true};
        full -> lifting {pressed == false} / {gotCoffee = true};
        lifting -> full {pressed == true} / {gotCoffee = true};
        lifting -> empty {pressed == false} / {gotCoffee = false};
    }
}
