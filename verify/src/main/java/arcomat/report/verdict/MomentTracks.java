package arcomat.report.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.TraceReplay;
import arcomat.analysis.search.Moment;
import arcomat.model.Automaton;
import arcomat.report.page.Story.Drawing;
import arcomat.report.page.Track;
import arcomat.report.page.Track.Kind;
import arcomat.report.run.RunDrawings;
import arcomat.report.run.TraceTracks;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.Visited;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** A counterexample as tracks: ports, and where both sides are; with the automata of both. */
final class MomentTracks {
    private static final String WAY = " goes";

    private final Answered answered;
    private final RunDrawings pictures;
    private final List<Moment> trace;
    private final Optional<TraceTracks> inside;
    private final Optional<RightSide> insideRight;
    private final List<Track> tracks = new ArrayList<>();
    private final List<Drawing> drawings = new ArrayList<>();

    MomentTracks(Answered answered, RunDrawings pictures) {
        this.answered = answered;
        this.pictures = pictures;
        trace = answered.verdict().trace();
        if (!trace.isEmpty()) {
            tracks.addAll(TraceTracks.inputs(trace.stream().map(Moment::input).toList()));
            outputs();
            states();
        }
        inside = CounterexampleRun.of(answered, 0);
        inside.ifPresent(run -> tracks.addAll(run.states()));
        insideRight = RightSide.of(answered);
        insideRight.ifPresent(right -> tracks.addAll(right.tracks()));
        architectures();
        if (answered.question() == Answered.Question.REFINEMENT) {
            for (int side = 0; side < answered.sides().size(); side++) {
                automata(side);
            }
        }
    }

    /** Whether it is told what parts of the left side do. */
    boolean tellsOfParts() {
        return inside.isPresent();
    }

    /** Whether it is told what parts of the right side do. */
    boolean tellsOfPartsOnTheRight() {
        return insideRight.isPresent();
    }

    List<Track> tracks() {
        return tracks;
    }

    /** Of both sides, also where there is nothing to step through: what is compared can be seen. */
    List<Drawing> drawings() {
        return drawings;
    }

    /** Of compositions; with what its wires carry where a run is told. */
    private void architectures() {
        for (int side = 0; side < answered.sides().size(); side++) {
            Promise each = answered.sides().get(side);
            List<Drawing> own =
                    told(side)
                            .orElseGet(
                                    () ->
                                            each.isComposition()
                                                    ? List.of(
                                                            pictures.parts(
                                                                    each.component(), Map.of()))
                                                    : List.of());
            String name = answered.sides().size() < 2 ? "" : name(side) + ": ";
            own.forEach(drawing -> drawings.add(drawing.titled(name + drawing.title())));
        }
    }

    private Optional<List<Drawing>> told(int side) {
        return side == 0
                ? inside.map(run -> run.drawings(pictures))
                : insideRight.map(right -> right.drawings(pictures));
    }

    private static String name(int side) {
        return side == 0 ? "left" : "right";
    }

    private void outputs() {
        Set<String> ports = new LinkedHashSet<>();
        trace.forEach(moment -> ports.addAll(moment.outputs().keySet()));
        for (String port : ports) {
            Stream<String> texts = trace.stream().map(moment -> text(moment, port));
            tracks.add(Track.of(TraceTracks.OUTPUTS, port, Kind.PORT, texts));
        }
    }

    private static String text(Moment moment, String port) {
        Sent sent = moment.outputs().getOrDefault(port, Sent.SILENCE);
        return !sent.equals(Sent.SILENCE) ? sent.toString() : moment.error() ? "error" : "";
    }

    private void states() {
        Terms terms = Terms.of(answered);
        List<String> possible = new ArrayList<>();
        trace.forEach(moment -> possible.add(String.join("  or  ", moment.right())));
        int last = trace.size() - 1;
        possible.set(last, possible.get(last).isEmpty() ? terms.end() : possible.get(last));
        Stream<String> left = trace.stream().map(Moment::left);
        tracks.add(Track.of(Terms.of(answered).sides(), terms.left(), Kind.STATE, left));
        tracks.add(
                Track.of(Terms.of(answered).sides(), terms.right(), Kind.STATE, possible.stream()));
    }

    /** Why nothing was enabled where nothing was; of one that always found something, nothing. */
    private void nearest(String side, String title, List<Visited> visited) {
        if (visited.stream().anyMatch(each -> !each.nearest().isEmpty())) {
            Stream<String> words = visited.stream().map(each -> nearest(side, each));
            tracks.add(
                    Track.of(
                            Terms.of(answered).sides(),
                            side + ": " + title + " why not",
                            Kind.REASON,
                            words));
        }
    }

    private static String nearest(String side, Visited visited) {
        return visited.nearest().stream()
                .map(each -> side + ": " + each.words())
                .distinct()
                .collect(Collectors.joining("  or  "));
    }

    private void automata(int position) {
        Promise side = answered.sides().get(position);
        for (Automaton automaton : side.automata()) {
            String sideName = name(position);
            String title = side.component().title(automaton);
            String name = sideName + ": " + title + WAY;
            List<Visited> visited = TraceReplay.of(answered.sides(), position, automaton, trace);
            tracks.add(RunDrawings.way(name, visited));
            nearest(sideName, title, visited);
            drawings.add(
                    pictures.of(
                            sideName + ": " + title, side.component(), automaton, List.of(name)));
        }
    }
}
