package coffee.meeting;

import coffee.types.Types.*;

/**
 * The world of Fig. 1: one line, and two fetchers that come towards each other on it. It turns
 * their commands into what their sensors see next.
 */
component Lane {
    port
        in MotorCmd emptyCmd,
        in MotorCmd loadedCmd,
        out Distance emptyFront,
        out Distance loadedFront,
        out LineStatus emptyLine,
        out LineStatus loadedLine;

    <<completion = "ignore">> automaton {
        state approaching, facing, makingRoom, passing, passed, alone;

        /** Slices until they meet. */
        variable Integer[0..2] gap = 2;

        initial approaching
                / {emptyFront = clear, loadedFront = clear, emptyLine = ok, loadedLine = ok};

        approaching [gap > 0] / {gap = gap - 1};
        approaching -> facing [gap == 0] / {emptyFront = tooClose, loadedFront = tooClose};
        facing -> makingRoom {emptyCmd == backRight} / {emptyLine = lost};
        makingRoom -> passing {emptyCmd == stop} / {loadedFront = clear};
        passing -> passed {loadedCmd == fwd} / {emptyFront = clear};
        passed -> alone {emptyCmd == fwd} / {emptyLine = ok};
    }
}
