package arcomat.brick.law;

import arcomat.source.Diagnostic;
import arcomat.source.Span;

/** There is room for so many of something, and for no more. */
abstract class Limit extends BrickLaw {
    /** From here on there is a warning: part of what there is room for. */
    static final double NEARLY = 0.8;

    private final String what;
    private final int room;
    private final String advice;

    /**
     * @param what of what there may be too much, in the plural
     * @param room how many there may be
     * @param advice what to do
     */
    Limit(String code, String what, int room, String advice) {
        super(code);
        this.what = what;
        this.room = room;
        this.advice = advice;
    }

    final boolean isExceededBy(int number) {
        return number > room;
    }

    /**
     * @param who what has too much
     */
    final Diagnostic excess(Span place, String who, int number) {
        return excess(place, who, number, room);
    }

    final Diagnostic excess(Span place, String who, int number, int limit) {
        return error(
                place,
                "%s has %d %s, but the brick has room for %d; %s",
                who,
                number,
                what,
                limit,
                advice);
    }
}
