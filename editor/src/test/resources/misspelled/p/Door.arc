package p;

component Door {
    port in Boolean pressed, out Boolean opens;

    automaton {
state   closed ;

        initial closed;

        closed {presed == true} / {opens = true};
    }
}
