package arcomat.diagram;

import arcomat.diagram.Graph.Caption;
import arcomat.diagram.Graph.Edge;
import arcomat.diagram.Graph.End;
import arcomat.diagram.Graph.Form;
import arcomat.diagram.Graph.Line;
import arcomat.diagram.Graph.Node;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A run that one side makes and the other forbids: the run step by step, and below it both automata
 * with the way that it takes through them.
 */
public final class FailureGraph {
    private FailureGraph() {}

    /**
     * One step of the run.
     *
     * @param letters what goes in and what comes out, one port a line; of the first step only what
     *     is sent at the beginning
     * @param left where the left side is afterwards
     * @param right where the right side may be afterwards; empty where it allows no such step
     */
    public record Step(List<String> letters, String left, List<String> right) {
        public Step {
            letters = List.copyOf(letters);
            right = List.copyOf(right);
        }
    }

    /**
     * @param left the automaton of the left side; compositions have none
     */
    public static Graph of(
            String title, List<Step> steps, Optional<Graph> left, Optional<Graph> right) {
        List<Node> roots = new ArrayList<>();
        roots.add(run(title, steps));
        left.ifPresent(side -> roots.add(frame(side, "left", 1)));
        right.ifPresent(side -> roots.add(frame(side, "right", 2)));
        return new Graph(title, roots, Graph.Flow.EITHER);
    }

    private static Node frame(Graph side, String name, int rank) {
        Node root = side.roots().get(0);
        Mark mark = root.mark();
        return new Node(
                new Mark(mark.kind(), name, mark.styles(), mark.place(), mark.tooltip()),
                root.form(),
                root.lines(),
                root.ports(),
                root.children(),
                root.edges(),
                rank);
    }

    private static Node run(String title, List<Step> steps) {
        List<Node> nodes = new ArrayList<>();
        List<Edge> edges = new ArrayList<>();
        Mark start = Mark.unplaced("start", "run");
        nodes.add(Node.leaf(start, Form.DOT, List.of()));
        String before = start.name();
        for (int i = 0; i < steps.size(); i++) {
            Step step = steps.get(i);
            Node node = node(step, i);
            nodes.add(node);
            edges.add(
                    new Edge(
                            Mark.unplaced("arrow", "step " + i).styled("edge"),
                            End.of(before),
                            End.of(node.name()),
                            captions(step, i)));
            before = node.name();
        }
        return new Node(
                Mark.unplaced("frame", "run"),
                Form.BOX,
                List.of(Line.bold(title)),
                List.of(),
                nodes,
                edges,
                0);
    }

    private static List<Caption> captions(Step step, int number) {
        List<Line> lines = step.letters().stream().map(Line::small).toList();
        Mark mark = Mark.unplaced("letter", String.valueOf(number));
        return lines.isEmpty() ? List.of() : List.of(new Caption(mark, lines));
    }

    private static Node node(Step step, int number) {
        List<Line> lines = new ArrayList<>();
        lines.add(Line.bold(String.valueOf(number)));
        lines.add(Line.small("left: " + step.left()));
        boolean possible = !step.right().isEmpty();
        lines.add(
                Line.small(
                        "right: "
                                + (possible ? String.join(" or ", step.right()) : "not possible")));
        Mark mark = Mark.unplaced("step", String.valueOf(number));
        return Node.leaf(mark.styled(possible ? "active" : "problem"), Form.ROUND, lines);
    }
}
