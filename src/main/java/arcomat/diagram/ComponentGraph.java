package arcomat.diagram;

import arcomat.diagram.Graph.Edge;
import arcomat.diagram.Graph.End;
import arcomat.diagram.Graph.Form;
import arcomat.diagram.Graph.Line;
import arcomat.diagram.Graph.Node;
import arcomat.model.Component;
import arcomat.model.Component.Part;
import arcomat.model.ExpressionText;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * A component with its parts, ports and connectors as the paper draws them (its Fig. 2): inputs on
 * the left, outputs on the right, sensors before logic before actuators. Parts and ports are named
 * by their path from the component.
 */
public final class ComponentGraph {
    private final int depth;

    /** Paths of parts that do not show what is inside. */
    private final Set<String> closed;

    private ComponentGraph(int depth, Set<String> closed) {
        this.depth = depth;
        this.closed = Set.copyOf(closed);
    }

    /**
     * @param depth how many levels of parts are shown: 1 for the parts as closed boxes
     */
    public static Graph of(Component component, int depth) {
        return of(component, depth, Set.of());
    }

    /**
     * As above.
     *
     * @param closed paths of parts that do not show what is inside, and say so
     */
    public static Graph of(Component component, int depth, Set<String> closed) {
        ComponentGraph drawing = new ComponentGraph(depth, closed);
        Mark mark = Mark.of("frame", "", component.span());
        List<Line> title = new ArrayList<>();
        title.add(Line.bold(component.qualifiedName()));
        title.addAll(ComponentHead.lines(component));
        if (drawing.showsDelay(component, 0)) {
            title.add(PortMarks.LEGEND);
        }
        Node frame = drawing.node(mark, title, component, "", 0);
        return new Graph(component.qualifiedName(), List.of(frame), Graph.Flow.RIGHT);
    }

    private boolean showsDelay(Component component, int level) {
        if (PortMarks.showDelay(component)) {
            return true;
        }
        return level < depth
                && component.body() instanceof Component.Composite composite
                && composite.parts().stream()
                        .anyMatch(part -> showsDelay(part.component(), level + 1));
    }

    private Node node(Mark mark, List<Line> title, Component component, String path, int level) {
        List<Graph.Port> ports = PortMarks.of(component, path);
        if (!(component.body() instanceof Component.Composite composite)
                || level >= depth
                || closed.contains(mark.name())) {
            return new Node(mark, Form.BOX, title, ports, List.of(), List.of(), rank(component));
        }
        List<Node> parts = new ArrayList<>();
        for (Part part : composite.parts()) {
            parts.add(part(part, path, level));
        }
        List<Edge> edges = new ArrayList<>();
        for (Component.Connection connection : composite.connections()) {
            String name = connection.source() + " -> " + connection.target();
            edges.add(
                    new Edge(
                            Mark.of("connector", path + name, connection.span()).telling(name),
                            end(connection.source(), path),
                            end(connection.target(), path),
                            List.of()));
        }
        return new Node(mark, Form.BOX, title, ports, parts, edges, rank(component));
    }

    private Node part(Part part, String path, int level) {
        Component component = part.component();
        Mark mark =
                Mark.of("part", path + part.name(), part.span())
                        .styled(style(component))
                        .telling(part.name() + ": " + component.qualifiedName());
        if (component.isComposite() && closed.contains(mark.name())) {
            mark = mark.styled("folded");
        }
        String arguments =
                part.arguments().isEmpty()
                        ? ""
                        : part.arguments().stream()
                                .map(ExpressionText::of)
                                .collect(Collectors.joining(", ", "(", ")"));
        String type = ComponentHead.simpleName(component.name()) + arguments;
        List<Line> title = List.of(Line.bold(part.name()), Line.small(type));
        return node(mark, title, component, path + part.name() + ".", level + 1);
    }

    private static String style(Component component) {
        return component.layer().name().toLowerCase(Locale.ROOT);
    }

    private static int rank(Component component) {
        return component.layer().ordinal();
    }

    private static End end(Component.Endpoint endpoint, String path) {
        String node = endpoint.part().map(part -> path + part).orElse(null);
        return new End(Optional.ofNullable(node), Optional.of(path + endpoint));
    }
}
