package arcomat.diagram;

import arcomat.diagram.Graph.Edge;
import arcomat.diagram.Graph.End;
import arcomat.diagram.Graph.Form;
import arcomat.diagram.Graph.Line;
import arcomat.diagram.Graph.Node;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Variable;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * An automaton as the paper draws it (its Figs. 3, 5 and 6). States, transitions and beginnings are
 * named by their index in the automaton.
 */
public final class AutomatonGraph {
    /** So many transitions hardly fit on a screen. */
    private static final int MANY = 25;

    private final Automaton automaton;
    private final Highlights highlights;

    private AutomatonGraph(Automaton automaton, Highlights highlights) {
        this.automaton = automaton;
        this.highlights = highlights;
    }

    public static Graph of(Component component, Automaton automaton) {
        return of(component, automaton, Highlights.NONE);
    }

    /** With the component's ports around it, and what else is said of the component. */
    public static Graph of(Component component, Automaton automaton, Highlights highlights) {
        List<Line> said = new ArrayList<>(ComponentHead.lines(component));
        if (PortMarks.showDelay(component)) {
            said.add(PortMarks.LEGEND);
        }
        return new AutomatonGraph(automaton, highlights)
                .graph(component.title(automaton), said, PortMarks.of(component, ""));
    }

    /**
     * The automaton alone.
     *
     * @param title above the picture
     */
    public static Graph of(String title, Automaton automaton, Highlights highlights) {
        return new AutomatonGraph(automaton, highlights).graph(title, List.of(), List.of());
    }

    private Graph graph(String title, List<Line> said, List<Graph.Port> ports) {
        List<Node> nodes = new ArrayList<>();
        List<Edge> edges = new ArrayList<>();
        for (int i = 0; i < automaton.initials().size(); i++) {
            Automaton.Initial initial = automaton.initials().get(i);
            nodes.add(Node.leaf(Mark.of("start", dot(i), initial.span()), Form.DOT, List.of()));
            edges.add(
                    new Edge(
                            Mark.unplaced("arrow", dot(i)).styled("edge"),
                            End.of(dot(i)),
                            End.of(state(initial.state())),
                            caption(
                                    Mark.of("initial", String.valueOf(i), initial.span()),
                                    TransitionText.label(initial))));
        }
        List<Meeting> meetings = meetings();
        nodes.addAll(nested(inOrderOfVisit(), 0));
        for (Meeting each : meetings) {
            add(each, nodes, edges);
        }
        edges.addAll(arrows(meetings));
        Node frame =
                new Node(
                        Mark.of("frame", "", automaton.span()),
                        Form.BOX,
                        head(title, said),
                        ports,
                        nodes,
                        edges,
                        0);
        return new Graph(title, List.of(frame), Graph.Flow.EITHER);
    }

    /**
     * States that stand in the same one are in a box of its name, where the first of them would be.
     *
     * @param depth how many boxes are around these
     */
    private List<Node> nested(Collection<Integer> states, int depth) {
        Map<String, List<Integer>> together = new LinkedHashMap<>();
        for (int state : states) {
            List<String> within = automaton.within().get(state);
            String key = within.size() > depth ? "within " + within.get(depth) : state(state);
            together.computeIfAbsent(key, each -> new ArrayList<>()).add(state);
        }
        List<Node> nodes = new ArrayList<>();
        together.forEach(
                (key, members) -> {
                    List<String> within = automaton.within().get(members.get(0));
                    nodes.add(
                            within.size() > depth
                                    ? box(within.get(depth), nested(members, depth + 1))
                                    : stateNode(members.get(0)));
                });
        return nodes;
    }

    private static Node box(String name, List<Node> states) {
        return new Node(
                Mark.unplaced("group", name).styled("frame"),
                Form.ROUND,
                List.of(Line.plain(name)),
                List.of(),
                states,
                List.of(),
                0);
    }

    private Node stateNode(int index) {
        List<Highlights.Highlight> found = highlights.states().getOrDefault(index, List.of());
        Mark mark = Mark.of("state", state(index), automaton.places().get(index));
        List<Line> lines = new ArrayList<>();
        lines.add(Line.plain(automaton.states().get(index)));
        lines.addAll(Highlights.tags(found));
        return Node.leaf(Highlights.apply(mark, found, "calm", ""), Form.ROUND, lines);
    }

    /** From the beginnings on, nearest first: so the picture is read. */
    private Set<Integer> inOrderOfVisit() {
        Set<Integer> order = new LinkedHashSet<>();
        automaton.initials().forEach(initial -> order.add(initial.state()));
        List<Integer> open = new ArrayList<>(order);
        for (int i = 0; i < open.size(); i++) {
            int state = open.get(i);
            automaton.transitions().stream()
                    .filter(each -> each.source() == state && order.add(each.target()))
                    .forEach(each -> open.add(each.target()));
        }
        IntStream.range(0, automaton.states().size()).forEach(order::add);
        return order;
    }

    /** Transitions into a state that say the same, out of several ones. */
    private record Meeting(int target, List<Integer> transitions) {
        String name() {
            return "into " + target + " " + transitions.get(0);
        }
    }

    private List<Meeting> meetings() {
        if (automaton.within().stream().anyMatch(within -> !within.isEmpty())) {
            return List.of(); // they lead out of boxes, which has an order of its own
        }
        Map<List<Object>, List<Integer>> same = new LinkedHashMap<>();
        for (int i = 0; i < automaton.transitions().size(); i++) {
            Automaton.Transition each = automaton.transitions().get(i);
            String label = TransitionText.full(each); // what is shown may be cut
            if (!label.isEmpty()) {
                List<Highlights.Highlight> found =
                        highlights.transitions().getOrDefault(i, List.of());
                same.computeIfAbsent(List.of(each.target(), label, found), k -> new ArrayList<>())
                        .add(i);
            }
        }
        return same.values().stream()
                .filter(this::comeFromSeveral)
                .map(each -> new Meeting(automaton.transitions().get(each.get(0)).target(), each))
                .toList();
    }

    /**
     * A loop at the state joins those that come from several others. Beside one other, two ways are
     * read more easily, unless there are so many labels that each of them is in the way.
     */
    private boolean comeFromSeveral(List<Integer> transitions) {
        boolean many = automaton.transitions().size() >= MANY;
        return transitions.stream()
                        .map(automaton.transitions()::get)
                        .filter(each -> many || each.source() != each.target())
                        .map(Automaton.Transition::source)
                        .distinct()
                        .count()
                > 1;
    }

    /** A junction in front of the state, to which each of them leads, and one arrow from there. */
    private void add(Meeting meeting, List<Node> nodes, List<Edge> edges) {
        Mark mark = Mark.unplaced("junction", meeting.name()).styled("start");
        Node junction = Node.leaf(mark, Form.JUNCTION, List.of());
        int before = 0;
        while (!nodes.get(before).name().equals(state(meeting.target()))) {
            before++;
        }
        nodes.add(before, junction);
        for (int index : meeting.transitions()) {
            Automaton.Transition each = automaton.transitions().get(index);
            edges.add(arrow(List.of(index), state(each.source()), junction.name(), List.of()));
        }
        edges.add(
                arrow(
                        meeting.transitions(),
                        junction.name(),
                        state(meeting.target()),
                        caption(meeting.transitions())));
    }

    /** Transitions between the same states share an arrow, named by all of them. */
    private List<Edge> arrows(List<Meeting> meetings) {
        Set<Integer> drawn =
                meetings.stream()
                        .flatMap(each -> each.transitions().stream())
                        .collect(Collectors.toSet());
        Map<String, List<Integer>> shared = new LinkedHashMap<>();
        for (int i = 0; i < automaton.transitions().size(); i++) {
            Automaton.Transition each = automaton.transitions().get(i);
            if (drawn.contains(i)) {
                continue;
            }
            shared.computeIfAbsent(each.source() + " " + each.target(), key -> new ArrayList<>())
                    .add(i);
        }
        return shared.values().stream().map(this::arrow).toList();
    }

    private Edge arrow(List<Integer> indices) {
        Automaton.Transition first = automaton.transitions().get(indices.get(0));
        List<Graph.Caption> captions = new ArrayList<>();
        indices.forEach(index -> captions.addAll(caption(List.of(index))));
        return arrow(indices, state(first.source()), state(first.target()), captions);
    }

    private Edge arrow(
            List<Integer> indices, String source, String target, List<Graph.Caption> captions) {
        Automaton.Transition first = automaton.transitions().get(indices.get(0));
        // The captions tell the story; the arrow only shows the colour.
        List<Highlights.Highlight> found = new ArrayList<>();
        indices.forEach(i -> found.addAll(highlights.transitions().getOrDefault(i, List.of())));
        found.replaceAll(each -> new Highlights.Highlight(each.kind(), each.tag(), ""));
        return new Edge(
                Highlights.apply(
                        Mark.of("arrow", name(indices), first.span()), found, "edge", "edge-"),
                End.of(source),
                End.of(target),
                captions);
    }

    private static String name(List<Integer> indices) {
        return indices.stream().map(String::valueOf).collect(Collectors.joining(" "));
    }

    private static List<Graph.Caption> caption(Mark mark, List<Line> lines) {
        return lines.isEmpty() ? List.of() : List.of(new Graph.Caption(mark, lines));
    }

    /** Of several transitions, what each of them says. */
    private List<Graph.Caption> caption(List<Integer> indices) {
        Automaton.Transition first = automaton.transitions().get(indices.get(0));
        List<Highlights.Highlight> found =
                highlights.transitions().getOrDefault(indices.get(0), List.of());
        Mark mark = Mark.of("transition", name(indices), first.span());
        for (int index : indices) {
            Automaton.Transition each = automaton.transitions().get(index);
            mark = mark.telling(automaton.arrow(each) + " " + TransitionText.full(each));
        }
        List<Line> lines = new ArrayList<>(TransitionText.label(first));
        lines.addAll(Highlights.tags(found));
        return caption(Highlights.apply(mark, found, "label", "label-"), lines);
    }

    private List<Line> head(String title, List<Line> said) {
        List<Line> lines = new ArrayList<>();
        lines.add(Line.bold(title));
        lines.addAll(said);
        for (Variable variable : automaton.variables()) {
            lines.add(Line.small(variable.type().simpleName() + " " + variable.name()));
        }
        lines.add(
                Line.small(
                        "completion: " + automaton.completion().name().toLowerCase(Locale.ROOT)));
        return lines;
    }

    private static String state(int index) {
        return String.valueOf(index);
    }

    private static String dot(int index) {
        return "initial " + index;
    }
}
