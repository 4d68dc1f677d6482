component House {
    port in Boolean main, in Boolean bell, out Boolean window, out Boolean ring;

    component Fuse {
        port in Boolean plug, <<delay = "1">> out Boolean socket;

        automaton {
            state on;
            initial on;
            on {plug == true} / {socket = true};
        }
    }

    component Room {
        port in Boolean power, out Boolean light;
        component Fuse lamp;
        connect power -> lamp.plug;
        connect lamp.socket -> light;
    }

    component Fuse fuse;
    component Room room;
    connect main -> fuse.plug;
    connect fuse.socket -> room.power;
    connect room.light -> window;
    connect bell -> ring;
}
