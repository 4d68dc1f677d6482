package arcomat.report.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.model.Port;
import arcomat.report.page.Story.Drawing;
import arcomat.report.page.Track;
import arcomat.report.run.RunDrawings;
import arcomat.report.run.TraceTracks;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * What the parts of the right side do in a counterexample, under names of their own: both sides may
 * have parts of one name.
 *
 * @param rows as the run has them
 * @param outputs of the whole: their rows tell of the left side
 */
record RightSide(TraceTracks run, List<Track> rows, Set<String> outputs) {
    private static final String RIGHT = "right: ";

    static Optional<RightSide> of(Answered answered) {
        return CounterexampleRun.of(answered, 1)
                .map(
                        run ->
                                new RightSide(
                                        run,
                                        run.states(),
                                        answered.sides().get(1).component().outputs().stream()
                                                .map(Port::name)
                                                .collect(Collectors.toSet())));
    }

    List<Track> tracks() {
        return rows.stream().map(RightSide::named).toList();
    }

    private static Track named(Track track) {
        boolean ofPart = track.group().startsWith(Track.PART);
        String place = ofPart ? track.group().substring(Track.PART.length()) : track.group();
        return track.called((ofPart ? Track.PART : "") + RIGHT + place, RIGHT + track.name());
    }

    List<Drawing> drawings(RunDrawings pictures) {
        return run.drawings(pictures).stream().map(this::named).toList();
    }

    private Drawing named(Drawing drawing) {
        Map<String, String> carried = new LinkedHashMap<>();
        drawing.carried()
                .forEach(
                        (port, row) -> {
                            if (!outputs.contains(row)) {
                                carried.put(port, named(row));
                            }
                        });
        List<String> tracks = drawing.tracks().stream().map(this::named).toList();
        return new Drawing(drawing.title(), drawing.svg(), tracks, carried);
    }

    /** Inputs are those of both sides. */
    private String named(String row) {
        return rows.stream().anyMatch(each -> each.name().equals(row)) ? RIGHT + row : row;
    }
}
