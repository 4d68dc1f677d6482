package arcomat.diagram;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * What is to be pointed out in the picture of an automaton.
 *
 * @param states by index
 * @param transitions by index
 */
public record Highlights(
        Map<Integer, List<Highlight>> states, Map<Integer, List<Highlight>> transitions) {
    public static final Highlights NONE = new Highlights(Map.of(), Map.of());

    public Highlights {
        states = copy(states);
        transitions = copy(transitions);
    }

    private static Map<Integer, List<Highlight>> copy(Map<Integer, List<Highlight>> map) {
        Map<Integer, List<Highlight>> copy = new LinkedHashMap<>();
        map.forEach((index, list) -> copy.put(index, List.copyOf(list)));
        return copy;
    }

    /** How it looks, the gravest first. */
    public enum Kind {
        /** Wrong, or to be looked at. */
        PROBLEM,
        /** Never reached, never taken. */
        NEVER,
        /** A part of a run. */
        ACTIVE
    }

    /**
     * @param tag a word or two that stand in the picture, so that colour does not say it alone
     * @param story shown on request
     */
    public record Highlight(Kind kind, String tag, String story) {}

    /**
     * A mark has one style only: that of its gravest highlight, or the plain one.
     *
     * @param prefix of the style of a highlight
     */
    static Mark apply(Mark mark, List<Highlight> highlights, String plain, String prefix) {
        if (highlights.isEmpty()) {
            return mark.styled(plain);
        }
        Kind kind = Collections.min(highlights.stream().map(Highlight::kind).toList());
        Mark changed = mark.styled(prefix + kind.name().toLowerCase(Locale.ROOT));
        for (Highlight each : highlights) {
            changed = each.story().isEmpty() ? changed : changed.telling(each.story());
        }
        return changed;
    }

    /** The tags, each once, one below the other. */
    static List<Graph.Line> tags(List<Highlight> highlights) {
        return highlights.stream().map(Highlight::tag).distinct().map(Graph.Line::small).toList();
    }
}
