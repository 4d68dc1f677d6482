package arcomat.diagram;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What is to be drawn: nested nodes with ports and labelled edges, without places.
 *
 * @param title of the whole picture
 * @param roots the outermost nodes
 * @param flow where edges lead
 */
public record Graph(String title, List<Node> roots, Flow flow) {
    public Graph {
        roots = List.copyOf(roots);
    }

    public enum Flow {
        RIGHT,
        /** To the right or down, whichever makes a picture that fits a page better. */
        EITHER
    }

    /** How a node is drawn. */
    public enum Form {
        /** A rectangle. */
        BOX,
        /** A rectangle with round corners. */
        ROUND,
        /** A dot where an automaton begins. */
        DOT,
        /** A small dot where edges meet to go on as one. */
        JUNCTION,
        /** A rectangle with a title and, below a line, all plain lines. */
        CARD
    }

    /**
     * @param lines texts inside, above the children
     * @param rank nodes of a lower rank stand on the left of those of a higher
     * @param edges between its children and its own ports
     */
    public record Node(
            Mark mark,
            Form form,
            List<Line> lines,
            List<Port> ports,
            List<Node> children,
            List<Edge> edges,
            int rank) {
        public Node {
            lines = List.copyOf(lines);
            ports = List.copyOf(ports);
            children = List.copyOf(children);
            edges = List.copyOf(edges);
        }

        static Node leaf(Mark mark, Form form, List<Line> lines) {
            return new Node(mark, form, lines, List.of(), List.of(), List.of(), 0);
        }

        public String name() {
            return mark.name();
        }

        /** Whether it is drawn around others, and edges lead from inside to outside. */
        public boolean isBox() {
            return form == Form.ROUND && !children.isEmpty();
        }

        /** Its children, and those of boxes among them. */
        public List<Node> inside() {
            List<Node> all = new ArrayList<>();
            for (Node child : children) {
                all.add(child);
                if (child.isBox()) {
                    all.addAll(child.inside());
                }
            }
            return all;
        }

        /** Whether it shows what is inside. */
        public boolean isOpen() {
            return !children.isEmpty() || !edges.isEmpty();
        }
    }

    /** A line of text. */
    public record Line(String text, Lettering lettering) {
        static Line plain(String text) {
            return new Line(text, Lettering.PLAIN);
        }

        static Line bold(String text) {
            return new Line(text, Lettering.BOLD);
        }

        static Line small(String text) {
            return new Line(text, Lettering.SMALL);
        }
    }

    /**
     * @param left whether it stands on the left side, as inputs do
     */
    public record Port(Mark mark, boolean left, String label) {}

    /**
     * @param captions beside it, one below the other; may be empty
     */
    public record Edge(Mark mark, End source, End target, List<Caption> captions) {
        public Edge {
            captions = List.copyOf(captions);
        }
    }

    /** Lines that belong together, such as the label of a transition. */
    public record Caption(Mark mark, List<Line> lines) {
        public Caption {
            lines = List.copyOf(lines);
        }
    }

    /**
     * Where an edge begins or ends.
     *
     * @param node by name; empty for the node that holds the edge
     * @param port by name; empty for the node itself
     */
    public record End(Optional<String> node, Optional<String> port) {
        /** The node it means, of who holds the edge and of those inside. */
        public Node in(Node holder) {
            return node.isEmpty()
                    ? holder
                    : holder.inside().stream()
                            .filter(each -> each.name().equals(node.get()))
                            .findFirst()
                            .orElseThrow();
        }

        /** Of the port, or of the node where it has none. */
        String name(Node holder) {
            return port.or(() -> node).orElse(holder.name());
        }

        static End of(String node) {
            return new End(Optional.of(node), Optional.empty());
        }
    }
}
