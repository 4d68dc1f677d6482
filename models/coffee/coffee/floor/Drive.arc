package coffee.floor;

import coffee.types.Types.*;

/**
 * Drives two wheels on a real floor. Three things are new against coffee.fetcher.Drive, with which
 * two fetchers in meeting.world stand and look at each other for ever:
 *
 * - Who has lost the line after a drift turns towards the side where it was seen last.
 * - Making room is a manoeuvre with an end: back in an arc to the right, straight back, and an arc
 *   the other way, so that the robot stands well beside the line, its nose a little towards it.
 * - Coming back, it crosses the line until only the right sensor sees it, and turns only then:
 *   turning at the first sight would turn it round.
 */
component Drive refines Brakes {
    timing instant;

    port
        in MotorCmd cmd,
        <<total>> in Drift drift,
        <<total>> in LineStatus ls,
        /** In degrees per second. */
        out Integer leftSpeed,
        /** In degrees per second. */
        out Integer rightSpeed;

    /** Straight on, in degrees per second. */
    Integer cruise = 360;

    /** The inner wheel in a bend, in degrees per second. */
    Integer slow = 120;

    /** Slices of the three parts of making room. */
    Integer outwards = 8;
    Integer backwards = 14;
    Integer inwards = 4;

    <<completion = "ignore">> automaton {
        state standing, onLine, leftOfLine, rightOfLine, swingingOut, backing, swingingIn, aside,
                returning, crossing;

        /** Slices of the part of the manoeuvre that are still to come. */
        variable Integer[0..100] more = 0;

        initial standing;

        standing {cmd == stop} / {leftSpeed = 0, rightSpeed = 0};
        standing -> onLine {cmd == fwd} / {leftSpeed = cruise, rightSpeed = cruise};
        standing -> swingingOut {cmd == backRight}
                / {leftSpeed = -cruise, rightSpeed = -slow, more = outwards};

        onLine -> standing {cmd == stop} / {leftSpeed = 0, rightSpeed = 0};
        onLine -> swingingOut {cmd == backRight}
                / {leftSpeed = -cruise, rightSpeed = -slow, more = outwards};
        onLine {cmd == --, ls == ok, drift == none} / {leftSpeed = cruise, rightSpeed = cruise};
        onLine -> leftOfLine {cmd == --, ls == ok, drift == left}
                / {leftSpeed = cruise, rightSpeed = slow};
        onLine -> rightOfLine {cmd == --, ls == ok, drift == right}
                / {leftSpeed = slow, rightSpeed = cruise};
        onLine {cmd == --, ls == lost} / {leftSpeed = cruise, rightSpeed = cruise};

        leftOfLine -> standing {cmd == stop} / {leftSpeed = 0, rightSpeed = 0};
        leftOfLine -> swingingOut {cmd == backRight}
                / {leftSpeed = -cruise, rightSpeed = -slow, more = outwards};
        leftOfLine -> onLine {cmd == --, ls == ok, drift == none}
                / {leftSpeed = cruise, rightSpeed = cruise};
        leftOfLine {cmd == --, ls == ok, drift == left} / {leftSpeed = cruise, rightSpeed = slow};
        leftOfLine -> rightOfLine {cmd == --, ls == ok, drift == right}
                / {leftSpeed = slow, rightSpeed = cruise};
        leftOfLine {cmd == --, ls == lost} / {leftSpeed = cruise, rightSpeed = 0};

        rightOfLine -> standing {cmd == stop} / {leftSpeed = 0, rightSpeed = 0};
        rightOfLine -> swingingOut {cmd == backRight}
                / {leftSpeed = -cruise, rightSpeed = -slow, more = outwards};
        rightOfLine -> onLine {cmd == --, ls == ok, drift == none}
                / {leftSpeed = cruise, rightSpeed = cruise};
        rightOfLine -> leftOfLine {cmd == --, ls == ok, drift == left}
                / {leftSpeed = cruise, rightSpeed = slow};
        rightOfLine {cmd == --, ls == ok, drift == right} / {leftSpeed = slow, rightSpeed = cruise};
        rightOfLine {cmd == --, ls == lost} / {leftSpeed = 0, rightSpeed = cruise};

        swingingOut [more > 1] {cmd == --} / {more = more - 1};
        swingingOut -> backing [more <= 1] {cmd == --}
                / {leftSpeed = -cruise, rightSpeed = -cruise, more = backwards};
        swingingOut -> aside {cmd == stop} / {leftSpeed = 0, rightSpeed = 0};
        swingingOut -> returning {cmd == fwd} / {leftSpeed = cruise, rightSpeed = cruise};

        backing [more > 1] {cmd == --} / {more = more - 1};
        backing -> swingingIn [more <= 1] {cmd == --}
                / {leftSpeed = -slow, rightSpeed = -cruise, more = inwards};
        backing -> aside {cmd == stop} / {leftSpeed = 0, rightSpeed = 0};
        backing -> returning {cmd == fwd} / {leftSpeed = cruise, rightSpeed = cruise};

        swingingIn [more > 1] {cmd == --} / {more = more - 1};
        swingingIn -> aside [more <= 1] {cmd == --} / {leftSpeed = 0, rightSpeed = 0, more = 0};
        swingingIn -> aside {cmd == stop} / {leftSpeed = 0, rightSpeed = 0};
        swingingIn -> returning {cmd == fwd} / {leftSpeed = cruise, rightSpeed = cruise};

        aside {cmd == stop} / {leftSpeed = 0, rightSpeed = 0};
        aside -> returning {cmd == fwd} / {leftSpeed = cruise, rightSpeed = cruise};
        aside -> swingingOut {cmd == backRight}
                / {leftSpeed = -cruise, rightSpeed = -slow, more = outwards};

        returning -> aside {cmd == stop} / {leftSpeed = 0, rightSpeed = 0};
        returning -> swingingOut {cmd == backRight}
                / {leftSpeed = -cruise, rightSpeed = -slow, more = outwards};
        returning {cmd == fwd} / {leftSpeed = cruise, rightSpeed = cruise};
        returning -> crossing {cmd == --, ls == ok} / {leftSpeed = cruise, rightSpeed = cruise};

        crossing -> aside {cmd == stop} / {leftSpeed = 0, rightSpeed = 0};
        crossing -> swingingOut {cmd == backRight}
                / {leftSpeed = -cruise, rightSpeed = -slow, more = outwards};
        crossing {cmd == fwd} / {leftSpeed = cruise, rightSpeed = cruise};
        // Only the right sensor sees it, or none does: the nose is across.
        crossing -> leftOfLine {cmd == --, ls == ok, drift == left}
                / {leftSpeed = cruise, rightSpeed = slow};
        crossing -> leftOfLine {cmd == --, ls == lost} / {leftSpeed = cruise, rightSpeed = 0};
    }
}
