package arcomat.pipeline.diagram;

import arcomat.diagram.Highlights;
import arcomat.diagram.Highlights.Highlight;
import arcomat.diagram.Highlights.Kind;
import arcomat.model.Automaton;
import arcomat.pipeline.diagram.MarkedFindings.Marked;
import arcomat.source.Diagnostic;
import arcomat.source.Diagnostic.Related;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Findings about an automaton, at the states and transitions that they are about. */
final class FindingHighlights {
    /** What never happens is drawn as if it were not there. */
    private static final Set<String> NEVER = Set.of("ARC1003", "ARC1004");

    /** Two transitions that overlap are both to be looked at. */
    private static final String OVERLAP = "ARC1001";

    /** The findings that people meet most, in a word. */
    private static final Map<String, String> WORDS =
            Map.of(
                    "ARC1001", "overlap",
                    "ARC1002", "inputs not handled",
                    "ARC1003", "never reached",
                    "ARC1004", "never taken");

    private final Automaton automaton;
    private final Map<Integer, List<Highlight>> states = new LinkedHashMap<>();
    private final Map<Integer, List<Highlight>> transitions = new LinkedHashMap<>();

    private FindingHighlights(Automaton automaton) {
        this.automaton = automaton;
    }

    /**
     * @param marked findings about any automata
     */
    static Highlights of(Automaton automaton, List<Marked> marked) {
        FindingHighlights highlights = new FindingHighlights(automaton);
        for (Marked each : marked) {
            if (each.automaton().span().equals(automaton.span())) {
                each.findings().forEach(highlights::add);
            }
        }
        return new Highlights(highlights.states, highlights.transitions);
    }

    private void add(Diagnostic diagnostic) {
        Kind kind = NEVER.contains(diagnostic.code()) ? Kind.NEVER : Kind.PROBLEM;
        String story = diagnostic.code() + ": " + diagnostic.message();
        Highlight highlight = new Highlight(kind, tag(diagnostic.code()), story);
        add(diagnostic.span(), highlight);
        if (diagnostic.code().equals(OVERLAP)) {
            diagnostic.related().stream()
                    .map(Related::span)
                    .forEach(place -> add(place, highlight));
        }
    }

    private static String tag(String code) {
        return WORDS.containsKey(code) ? code + " " + WORDS.get(code) : code;
    }

    private void add(Span place, Highlight highlight) {
        for (int i = 0; i < automaton.states().size(); i++) {
            if (automaton.places().get(i).equals(place)) {
                add(states, i, highlight);
            }
        }
        for (int i = 0; i < automaton.transitions().size(); i++) {
            if (automaton.transitions().get(i).span().equals(place)) {
                add(transitions, i, highlight);
            }
        }
    }

    /** Once, also where several instances of a component show it. */
    private static void add(Map<Integer, List<Highlight>> map, int index, Highlight highlight) {
        List<Highlight> list = map.computeIfAbsent(index, key -> new ArrayList<>());
        if (!list.contains(highlight)) {
            list.add(highlight);
        }
    }
}
