package arcomat.report.brick;

import arcomat.report.page.Timeline;
import arcomat.report.page.Track;
import arcomat.report.page.Track.Kind;

import java.util.ArrayList;
import java.util.List;

/**
 * Tracks of slices, as tracks of the cycles that the slices begin in. A program begins one slice in
 * each round of its loop, and none in the last ones, in which it tidies up.
 */
final class CycleSteps {
    private static final int NONE = -1;

    private final List<Integer> begun = new ArrayList<>();
    private final List<Integer> last = new ArrayList<>();

    private CycleSteps(List<Long> cycles, List<Long> slices) {
        int next = 0;
        for (int cycle = 0; cycle < cycles.size(); cycle++) {
            int first = next;
            long end = cycle + 1 < cycles.size() ? cycles.get(cycle + 1) : Long.MAX_VALUE;
            while (next < slices.size() && slices.get(next) < end) {
                next++;
            }
            begun.add(next > first ? next - 1 : NONE);
            last.add(next - 1);
        }
    }

    /**
     * @param cycles when they begin, in milliseconds
     * @param slices with their times
     */
    static List<Track> of(List<Long> cycles, Timeline slices) {
        CycleSteps steps = new CycleSteps(cycles, slices.times());
        return slices.tracks().stream().map(steps::of).toList();
    }

    /** Who is somewhere stays there; a message is sent once. */
    private Track of(Track track) {
        boolean stays = track.kind() == Kind.STATE || track.kind() == Kind.VARIABLE;
        return track.at(stays ? last : begun);
    }
}
