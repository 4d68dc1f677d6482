package floor;

component Cart {
    port in Boolean notBlocked, out Boolean note;

    automaton {
        state rolling, s2;

        initial rolling;

        rolling -> s2 {notBlocked == false} / {note = true};
        s2 -> rolling {notBlocked == true};
    }
}
