package arcomat.diagram;

import arcomat.diagram.Graph.Edge;
import arcomat.diagram.Graph.Form;
import arcomat.diagram.Graph.Node;

import org.eclipse.elk.alg.layered.components.ComponentOrderingStrategy;
import org.eclipse.elk.alg.layered.options.CycleBreakingStrategy;
import org.eclipse.elk.alg.layered.options.EdgeLabelSideSelection;
import org.eclipse.elk.alg.layered.options.GraphCompactionStrategy;
import org.eclipse.elk.alg.layered.options.LayeredOptions;
import org.eclipse.elk.alg.layered.options.LayeringStrategy;
import org.eclipse.elk.alg.layered.options.NodePlacementStrategy;
import org.eclipse.elk.alg.layered.options.OrderingStrategy;
import org.eclipse.elk.core.RecursiveGraphLayoutEngine;
import org.eclipse.elk.core.math.ElkMargin;
import org.eclipse.elk.core.math.ElkPadding;
import org.eclipse.elk.core.math.KVector;
import org.eclipse.elk.core.options.CoreOptions;
import org.eclipse.elk.core.options.Direction;
import org.eclipse.elk.core.options.EdgeLabelPlacement;
import org.eclipse.elk.core.options.EdgeRouting;
import org.eclipse.elk.core.options.HierarchyHandling;
import org.eclipse.elk.core.options.NodeLabelPlacement;
import org.eclipse.elk.core.options.PortConstraints;
import org.eclipse.elk.core.options.PortLabelPlacement;
import org.eclipse.elk.core.options.PortSide;
import org.eclipse.elk.core.options.SizeConstraint;
import org.eclipse.elk.core.util.IndividualSpacings;
import org.eclipse.elk.core.util.NullElkProgressMonitor;
import org.eclipse.elk.graph.ElkConnectableShape;
import org.eclipse.elk.graph.ElkEdge;
import org.eclipse.elk.graph.ElkGraphElement;
import org.eclipse.elk.graph.ElkLabel;
import org.eclipse.elk.graph.ElkNode;
import org.eclipse.elk.graph.ElkPort;
import org.eclipse.elk.graph.util.ElkGraphUtil;

import java.util.EnumSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * Finds a place for everything, by the layered method of the Eclipse Layout Kernel: ports on the
 * sides, edges in right angles, labels beside the edges.
 */
public final class LayeredLayout {
    static final double PORT = 9;

    /** Beside other things. */
    private static final Sheet PAGE = new Sheet(1100, 1100);

    /** All of a small one. */
    private static final Sheet SCREEN = new Sheet(1440, 900);

    static final double DOT = 11;

    /** Where lines meet. */
    static final double JUNCTION = 5.2;

    /** Labels without a text are ignored; this one is never shown. */
    private static final String LABEL = "label";

    /** Around the text of a node. */
    private static final double PADDING = 10;

    /** Around what is inside an open node. */
    private static final double INSIDE = 18;

    private static final double PORT_ROW = 20;
    private static final double NARROWEST = 60;
    private static final double LOWEST = 34;

    private final Map<Node, ElkNode> nodes = new IdentityHashMap<>();
    private final Map<Graph.Port, ElkPort> ports = new IdentityHashMap<>();
    private final Map<Edge, List<ElkEdge>> edges = new IdentityHashMap<>();

    /** By junctions: there all edges to it end, and run side by side as one line. */
    private final Map<Node, ElkPort> meetings = new IdentityHashMap<>();

    private final Direction direction;
    private final Method method;

    /** Whether edges lead into boxes and out of them. */
    private final boolean boxed;

    private LayeredLayout(Direction direction, Method method, boolean boxed) {
        this.direction = direction;
        this.method = method;
        this.boxed = boxed;
    }

    /** How nodes get into layers, and where in a layer they stand. */
    private record Method(
            CycleBreakingStrategy backEdges,
            LayeringStrategy layers,
            NodePlacementStrategy places,
            GraphCompactionStrategy compaction) {
        /** For what has no beginning: senders stand before those that listen. */
        static final Method FLOW =
                new Method(
                        CycleBreakingStrategy.GREEDY_MODEL_ORDER,
                        LayeringStrategy.NETWORK_SIMPLEX,
                        NodePlacementStrategy.BRANDES_KOEPF,
                        GraphCompactionStrategy.NONE);

        /** Nodes come in the order in which they are to be read. */
        static final Method READING =
                new Method(
                        CycleBreakingStrategy.MODEL_ORDER,
                        LayeringStrategy.NETWORK_SIMPLEX,
                        NodePlacementStrategy.BRANDES_KOEPF,
                        GraphCompactionStrategy.NONE);

        /**
         * For automata that do not fit a screen in that order, because of long ways back: fewer
         * ways back, fewer layers, and no room that nobody needs.
         */
        static final List<Method> DENSE =
                List.of(
                        new Method(
                                CycleBreakingStrategy.GREEDY_MODEL_ORDER,
                                LayeringStrategy.LONGEST_PATH,
                                NodePlacementStrategy.LINEAR_SEGMENTS,
                                GraphCompactionStrategy.EDGE_LENGTH),
                        new Method(
                                CycleBreakingStrategy.GREEDY,
                                LayeringStrategy.NETWORK_SIMPLEX,
                                NodePlacementStrategy.LINEAR_SEGMENTS,
                                GraphCompactionStrategy.EDGE_LENGTH));
    }

    /** In the order of reading, if that fits; else as it fits a screen best. */
    public static Picture of(Graph graph) {
        if (graph.flow() == Graph.Flow.RIGHT) {
            return of(graph, Direction.RIGHT, Method.FLOW);
        }
        Picture right = of(graph, Direction.RIGHT, Method.READING);
        if (PAGE.scale(right) == 1) {
            return right;
        }
        Picture down = of(graph, Direction.DOWN, Method.READING);
        Picture plain = PAGE.better(right, down);
        boolean single = graph.roots().size() == 1 && !hasBoxes(graph.roots());
        return single && SCREEN.scale(plain) < 1 ? dense(graph, plain) : plain;
    }

    private static Picture dense(Graph graph, Picture plain) {
        Picture best = plain;
        for (Method method : Method.DENSE) {
            for (Direction direction : List.of(Direction.RIGHT, Direction.DOWN)) {
                Picture other = tried(graph, direction, method).orElse(best);
                best = SCREEN.better(best, other);
            }
        }
        return best;
    }

    /** The kernel's compaction moves lines into labels now and then, and fails at some graphs. */
    private static Optional<Picture> tried(Graph graph, Direction direction, Method method) {
        try {
            return Optional.of(of(graph, direction, method)).filter(ClearTexts::in);
        } catch (IllegalStateException compaction) {
            return Optional.empty();
        }
    }

    /** What pictures are to fit, in pixels. */
    private record Sheet(double width, double height) {
        /** To what part of its size a picture has to shrink. */
        double scale(Picture picture) {
            return Math.min(1, Math.min(width / picture.width(), height / picture.height()));
        }

        Picture better(Picture one, Picture other) {
            return scale(other) > scale(one) ? other : one;
        }
    }

    private static Picture of(Graph graph, Direction direction, Method method) {
        LayeredLayout layout = new LayeredLayout(direction, method, hasBoxes(graph.roots()));
        ElkNode root = ElkGraphUtil.createGraph();
        layout.layered(root, graph.roots(), false);
        root.setProperty(LayeredOptions.SEPARATE_CONNECTED_COMPONENTS, false);
        if (graph.roots().size() > 1) {
            // Side by side what leads down, one below the other what leads to the right.
            root.setProperty(
                    LayeredOptions.DIRECTION,
                    direction == Direction.DOWN ? Direction.RIGHT : Direction.DOWN);
        }
        root.setProperty(LayeredOptions.PADDING, new ElkPadding(PADDING));
        graph.roots().forEach(node -> layout.add(node, root, true));
        new RecursiveGraphLayoutEngine().layout(root, new NullElkProgressMonitor());
        LayoutPlaces places = new ElkPlaces(layout.nodes, layout.ports, layout.edges);
        return PlacedPicture.of(graph, root.getWidth(), root.getHeight(), places);
    }

    private static boolean hasBoxes(List<Node> nodes) {
        return nodes.stream().anyMatch(each -> each.isBox() || hasBoxes(each.children()));
    }

    private void layered(ElkNode node, List<Node> children, boolean crowded) {
        node.setProperty(CoreOptions.ALGORITHM, LayeredOptions.ALGORITHM_ID);
        node.setProperty(LayeredOptions.DIRECTION, direction);
        node.setProperty(
                LayeredOptions.CYCLE_BREAKING_STRATEGY,
                boxed ? CycleBreakingStrategy.GREEDY : method.backEdges());
        node.setProperty(LayeredOptions.LAYERING_STRATEGY, method.layers());
        node.setProperty(LayeredOptions.NODE_PLACEMENT_STRATEGY, method.places());
        node.setProperty(LayeredOptions.COMPACTION_POST_COMPACTION_STRATEGY, method.compaction());
        node.setProperty(
                LayeredOptions.CONSIDER_MODEL_ORDER_COMPONENTS,
                ComponentOrderingStrategy.MODEL_ORDER);
        node.setProperty(LayeredOptions.EDGE_ROUTING, EdgeRouting.ORTHOGONAL);
        node.setProperty(LayeredOptions.SPACING_NODE_NODE, 28.0);
        node.setProperty(LayeredOptions.SPACING_NODE_NODE_BETWEEN_LAYERS, crowded ? 32.0 : 44.0);
        node.setProperty(LayeredOptions.SPACING_EDGE_NODE, 16.0);
        node.setProperty(LayeredOptions.SPACING_EDGE_EDGE, 12.0);
        node.setProperty(LayeredOptions.SPACING_EDGE_NODE_BETWEEN_LAYERS, 18.0);
        node.setProperty(LayeredOptions.SPACING_EDGE_EDGE_BETWEEN_LAYERS, 12.0);
        node.setProperty(LayeredOptions.SPACING_EDGE_LABEL, 4.0);
        node.setProperty(LayeredOptions.SPACING_LABEL_LABEL, 4.0);
        node.setProperty(LayeredOptions.SPACING_NODE_SELF_LOOP, 14.0);
        node.setProperty(LayeredOptions.SPACING_PORT_PORT, PORT_ROW - PORT);
        node.setProperty(LayeredOptions.SPACING_LABEL_PORT_HORIZONTAL, 4.0);
        node.setProperty(
                LayeredOptions.EDGE_LABELS_SIDE_SELECTION, EdgeLabelSideSelection.ALWAYS_UP);
        // With edges into boxes the layout cannot keep the order of the text, and fails.
        if (!boxed) {
            node.setProperty(
                    LayeredOptions.CONSIDER_MODEL_ORDER_STRATEGY, OrderingStrategy.PREFER_NODES);
        }
        if (children.stream().mapToInt(Node::rank).distinct().count() > 1) {
            node.setProperty(LayeredOptions.PARTITIONING_ACTIVATE, true);
        }
    }

    private void add(Node node, ElkNode parent, boolean outermost) {
        ElkNode made = ElkGraphUtil.createNode(parent);
        nodes.put(node, made);
        made.setProperty(LayeredOptions.PARTITIONING_PARTITION, node.rank());
        size(node, made);
        labels(node, made);
        node.ports().forEach(port -> add(port, made));
        if (node.form() == Form.JUNCTION) {
            ElkPort meeting = ElkGraphUtil.createPort(made);
            meeting.setProperty(
                    LayeredOptions.PORT_SIDE,
                    direction == Direction.RIGHT ? PortSide.WEST : PortSide.NORTH);
            meetings.put(node, meeting);
        }
        made.setProperty(
                LayeredOptions.PORT_LABELS_PLACEMENT,
                outermost && node.isOpen()
                        ? EnumSet.of(
                                PortLabelPlacement.OUTSIDE,
                                PortLabelPlacement.NEXT_TO_PORT_IF_POSSIBLE)
                        : PortLabelPlacement.inside());
        if (!node.isBox()) {
            made.setProperty(LayeredOptions.PORT_CONSTRAINTS, PortConstraints.FIXED_SIDE);
        }
        if (node.isOpen()) {
            boolean crowded = node.edges().stream().anyMatch(edge -> !edge.captions().isEmpty());
            layered(made, node.children(), crowded);
            double top =
                    TextSize.ofLines(node.lines()).height() + 2 * PlacedPicture.TITLE + PADDING;
            made.setProperty(LayeredOptions.PADDING, new ElkPadding(top, INSIDE, INSIDE, INSIDE));
            node.children().forEach(child -> add(child, made, false));
            if (node.children().stream().anyMatch(Node::isBox)) {
                made.setProperty(
                        CoreOptions.HIERARCHY_HANDLING, HierarchyHandling.INCLUDE_CHILDREN);
            }
            connect(node, made);
        }
    }

    /**
     * A closed node has its title on top, and below it inputs on the left, outputs on the right.
     */
    private static void size(Node node, ElkNode made) {
        if (node.form() == Form.DOT || node.form() == Form.JUNCTION) {
            double size = node.form() == Form.DOT ? DOT : JUNCTION;
            made.setDimensions(size, size);
            return;
        }
        TextSize title = TextSize.ofLines(node.lines());
        double top = title.height() + 2 * PlacedPicture.TITLE;
        if (node.isOpen() || !node.ports().isEmpty()) {
            IndividualSpacings spacings = new IndividualSpacings();
            spacings.setProperty(
                    LayeredOptions.SPACING_PORTS_SURROUNDING,
                    new ElkMargin(top, 0, PADDING - PORT / 2, 0));
            made.setProperty(CoreOptions.SPACING_INDIVIDUAL, spacings);
        }
        double left = widestPort(node, true);
        double right = widestPort(node, false);
        double ports = left + right + (left > 0 && right > 0 ? 2 * PADDING : PADDING);
        double width = Math.max(NARROWEST, Math.max(title.width() + 2 * PADDING, ports));
        made.setProperty(
                LayeredOptions.NODE_SIZE_CONSTRAINTS,
                EnumSet.of(SizeConstraint.PORTS, SizeConstraint.MINIMUM_SIZE));
        made.setProperty(
                LayeredOptions.NODE_SIZE_MINIMUM, new KVector(width, Math.max(LOWEST, top)));
    }

    private static double widestPort(Node node, boolean left) {
        return node.ports().stream()
                .filter(port -> port.left() == left)
                .mapToDouble(port -> Lettering.SMALL.width(port.label()) + PORT)
                .max()
                .orElse(0);
    }

    private static void labels(Node node, ElkNode made) {
        if (node.lines().isEmpty() || node.isOpen()) {
            return;
        }
        label(TextSize.ofLines(node.lines()), made);
        boolean top = !node.ports().isEmpty();
        made.setProperty(
                LayeredOptions.NODE_LABELS_PLACEMENT,
                top ? NodeLabelPlacement.insideTopCenter() : NodeLabelPlacement.insideCenter());
        made.setProperty(
                LayeredOptions.NODE_LABELS_PADDING, new ElkPadding(PlacedPicture.TITLE, PADDING));
    }

    private static ElkLabel label(TextSize size, ElkGraphElement owner) {
        ElkLabel label = ElkGraphUtil.createLabel(owner);
        label.setText(LABEL);
        label.setDimensions(size.width(), size.height());
        return label;
    }

    private void add(Graph.Port port, ElkNode owner) {
        ElkPort made = ElkGraphUtil.createPort(owner);
        ports.put(port, made);
        made.setDimensions(PORT, PORT);
        made.setProperty(LayeredOptions.PORT_SIDE, port.left() ? PortSide.WEST : PortSide.EAST);
        made.setProperty(LayeredOptions.PORT_BORDER_OFFSET, -PORT / 2);
        label(TextSize.ofLines(List.of(Graph.Line.small(port.label()))), made);
    }

    private void connect(Node owner, ElkNode holder) {
        for (Edge edge : owner.edges()) {
            ElkConnectableShape source = end(edge.source(), owner);
            ElkConnectableShape target = target(edge.target(), owner);
            if (edge.source().node().isEmpty() && edge.target().node().isEmpty()) {
                edges.put(edge, through(source, holder, target));
                continue;
            }
            ElkEdge made = connect(source, target);
            edges.put(edge, List.of(made));
            if (!edge.captions().isEmpty()) {
                label(TextSize.of(edge.captions()), made)
                        .setProperty(
                                LayeredOptions.EDGE_LABELS_PLACEMENT, EdgeLabelPlacement.CENTER);
            }
        }
    }

    /** From port to port of one node, by way of a point inside. */
    private static List<ElkEdge> through(
            ElkConnectableShape source, ElkNode holder, ElkConnectableShape target) {
        ElkNode point = ElkGraphUtil.createNode(holder);
        point.setDimensions(1, 1);
        point.setProperty(LayeredOptions.PARTITIONING_PARTITION, 1);
        return List.of(connect(source, point), connect(point, target));
    }

    private static ElkEdge connect(ElkConnectableShape source, ElkConnectableShape target) {
        ElkEdge edge = ElkGraphUtil.createSimpleEdge(source, target);
        ElkGraphUtil.updateContainment(edge);
        return edge;
    }

    private ElkConnectableShape target(Graph.End end, Node owner) {
        ElkPort meeting = meetings.get(end.in(owner));
        return meeting != null ? meeting : end(end, owner);
    }

    private ElkConnectableShape end(Graph.End end, Node owner) {
        Node node = end.in(owner);
        if (end.port().isEmpty()) {
            return Objects.requireNonNull(nodes.get(node));
        }
        String wanted = end.port().get();
        return node.ports().stream()
                .filter(port -> port.mark().name().equals(wanted))
                .findFirst()
                .map(ports::get)
                .orElseThrow();
    }
}
