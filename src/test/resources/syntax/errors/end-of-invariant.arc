/** What stands behind an invariant without its semicolon is no part of it. */
component InvariantEnd {
    port in Boolean on,
         out Boolean light;
    inv state: on == true implies light == true

    port in Boolean component;

    ocl inv second: component
            && port.in == 1
            && (state)
    <<deploy>> automaton {
        state s;
    }

    inv third: forall x
    ocl inv fourth: "text"
    component Inner {
        port in Boolean a;
    }

    java inv body: {
        component Inner
        port in
    };
    inv fine: on ==
        port
        || state
        component;
}
