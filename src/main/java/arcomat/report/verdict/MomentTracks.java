package arcomat.report.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.refinement.TraceReplay;
import arcomat.analysis.search.Moment;
import arcomat.model.Automaton;
import arcomat.report.page.Drawing;
import arcomat.report.page.Track;
import arcomat.report.page.Track.Kind;
import arcomat.report.run.AutomatonDrawing;
import arcomat.report.run.TraceTracks;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** A counterexample as tracks: ports, and where both sides are; with the automata of both. */
final class MomentTracks {
    private static final String BOTH = "both sides";
    private static final String WAY = " goes";

    private final Answered answered;
    private final AutomatonDrawing pictures;
    private final List<Moment> trace;
    private final List<Track> tracks = new ArrayList<>();
    private final List<Drawing> drawings = new ArrayList<>();

    MomentTracks(Answered answered, AutomatonDrawing pictures) {
        this.answered = answered;
        this.pictures = pictures;
        trace = answered.verdict().trace();
        if (!trace.isEmpty()) {
            tracks.addAll(TraceTracks.inputs(trace.stream().map(Moment::input).toList()));
            outputs();
            states();
        }
        for (int side = 0; side < answered.sides().size(); side++) {
            automata(side);
        }
    }

    List<Track> tracks() {
        return tracks;
    }

    /** Of both sides, also where there is nothing to step through: what is compared can be seen. */
    List<Drawing> drawings() {
        return drawings;
    }

    private void outputs() {
        Set<String> ports = new LinkedHashSet<>();
        trace.forEach(moment -> ports.addAll(moment.outputs().keySet()));
        for (String port : ports) {
            Track.Builder track = new Track.Builder(TraceTracks.OUTPUTS, port, Kind.PORT);
            for (Moment moment : trace) {
                String sent = text(moment.outputs().get(port));
                track.addUnlessEmpty(moment.error() && sent.isEmpty() ? "error" : sent);
            }
            tracks.add(track.build());
        }
    }

    private static String text(Sent sent) {
        return sent == null || sent.equals(Sent.SILENCE) ? "" : sent.toString();
    }

    private void states() {
        Terms terms = Terms.of(answered);
        Track.Builder left = new Track.Builder(BOTH, terms.left(), Kind.STATE);
        Track.Builder right = new Track.Builder(BOTH, terms.right(), Kind.STATE);
        for (int i = 0; i < trace.size(); i++) {
            Moment moment = trace.get(i);
            left.addUnlessEmpty(moment.left());
            boolean last = i == trace.size() - 1;
            String possible = String.join("  or  ", moment.right());
            right.addUnlessEmpty(possible.isEmpty() && last ? terms.end() : possible);
        }
        tracks.add(left.build());
        tracks.add(right.build());
    }

    private void automata(int position) {
        Promise side = answered.sides().get(position);
        for (Automaton automaton : side.automata()) {
            String sideName = position == 0 ? "left" : "right";
            String title = side.component().title(automaton);
            String name = sideName + ": " + title + WAY;
            tracks.add(
                    AutomatonDrawing.way(
                            name, TraceReplay.of(answered.sides(), position, automaton, trace)));
            drawings.add(
                    pictures.of(
                            sideName + ": " + title, side.component(), automaton, List.of(name)));
        }
    }
}
