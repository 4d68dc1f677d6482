package arcomat.report.run;

import arcomat.diagram.AutomatonGraph;
import arcomat.diagram.ComponentGraph;
import arcomat.diagram.LayeredLayout;
import arcomat.diagram.SvgText;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.report.page.Story.Drawing;
import arcomat.report.page.Track;
import arcomat.report.page.Track.Kind;
import arcomat.semantics.automaton.Visited;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Pictures beside runs, of automata and of architectures; each is laid out once. */
public final class RunDrawings {
    /** More parts than that are not told apart in a picture beside a run. */
    private static final int MOST_PARTS = 40;

    private static final int DEEPEST = 3;

    private final Map<Automaton, String> pictures = new IdentityHashMap<>();
    private final Map<Component, String> architectures = new IdentityHashMap<>();

    /**
     * @param tracks that are marked in it
     */
    public Drawing of(String title, Component component, Automaton automaton, List<String> tracks) {
        String svg = pictures.computeIfAbsent(automaton, each -> picture(component, each));
        return new Drawing(title, svg, tracks);
    }

    /**
     * A component with its parts, as deep as they have room.
     *
     * @param carried by their paths, the tracks that say what ports carry
     */
    public Drawing parts(Component component, Map<String, String> carried) {
        String svg = architectures.computeIfAbsent(component, RunDrawings::picture);
        return new Drawing(component.qualifiedName(), svg, List.of(), carried);
    }

    private static String picture(Component component) {
        int depth = 1;
        while (depth < DEEPEST && parts(component, depth + 1) <= MOST_PARTS) {
            depth++;
        }
        return SvgText.embedded(LayeredLayout.of(ComponentGraph.of(component, depth)));
    }

    /** How many there are, down to a level. */
    private static int parts(Component component, int depth) {
        return depth > 0 && component.body() instanceof Component.Composite composite
                ? composite.parts().stream()
                        .mapToInt(part -> 1 + parts(part.component(), depth - 1))
                        .sum()
                : 0;
    }

    private static String picture(Component component, Automaton automaton) {
        return SvgText.embedded(LayeredLayout.of(AutomatonGraph.of(component, automaton)));
    }

    /** A track that only drawings show: where an automaton goes. */
    public static Track way(String name, List<Visited> visited) {
        Track.Builder track = new Track.Builder("", name, Kind.PATH);
        for (Visited moment : visited) {
            List<String> elements = new ArrayList<>();
            moment.states().forEach(each -> elements.add(state(each)));
            moment.transitions().forEach(each -> elements.add(transition(each)));
            moment.initials().forEach(each -> elements.add("initial " + each));
            track.add("", elements);
        }
        return track.build();
    }

    static String state(int index) {
        return "state " + index;
    }

    static String transition(int index) {
        return "transition " + index;
    }

    /** A part of a part, by its path; empty for the whole. */
    static Optional<Component> part(Component whole, String path) {
        Component found = whole;
        for (String name : path.isEmpty() ? List.<String>of() : Arrays.asList(path.split("\\."))) {
            Optional<Component.Part> part =
                    found.body() instanceof Component.Composite composite
                            ? composite.parts().stream()
                                    .filter(each -> each.name().equals(name))
                                    .findFirst()
                            : Optional.empty();
            if (part.isEmpty()) {
                return Optional.empty();
            }
            found = part.get().component();
        }
        return Optional.of(found);
    }
}
