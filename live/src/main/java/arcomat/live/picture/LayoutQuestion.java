package arcomat.live.picture;

import arcomat.diagram.Graph;
import arcomat.diagram.Graph.Edge;
import arcomat.diagram.Graph.Form;
import arcomat.diagram.Graph.Node;
import arcomat.diagram.Lettering;
import arcomat.diagram.TextSize;
import arcomat.live.json.JsonText;

import java.util.List;

/**
 * Says in the JSON of KLay what is to be placed: sizes, the sides of ports, and what is connected.
 * Ports of closed nodes stand in the order of the text, so that a picture keeps its looks while its
 * model is typed.
 */
final class LayoutQuestion {
    /** Around the text of a node. */
    private static final double PADDING = 10;

    /** Around what is inside an open node. */
    private static final double INSIDE = 20;

    /** Above and below a title. */
    private static final double TITLE = 8;

    private static final double DOT = 11;
    private static final double JUNCTION = 5.2;
    private static final double NARROWEST = 60;
    private static final double LOWEST = 34;

    /** Between neighbours, and between layers. */
    private static final int SPACING = 30;

    private final Names names;
    private final boolean across;

    /**
     * @param across whether edges lead through the sides of open nodes
     */
    private LayoutQuestion(Names names, boolean across) {
        this.names = names;
        this.across = across;
    }

    /** The question about a whole graph. */
    static String of(Graph graph, Names names) {
        boolean across = graph.roots().stream().anyMatch(LayoutQuestion::leadsAcross);
        LayoutQuestion question = new LayoutQuestion(names, across);
        return JsonText.object(
                json -> {
                    json.field("id", Names.ROOT);
                    question.options(json);
                    double margin = PADDING + outside(graph.roots());
                    padding(json, PADDING, margin);
                    json.objects("children", graph.roots(), question::node);
                });
    }

    /** From a box to outside of it, or from an own port to inside. */
    private static boolean leadsAcross(Node node) {
        return node.isBox()
                || node.edges().stream()
                        .anyMatch(edge -> isOwn(edge.source()) || isOwn(edge.target()))
                || node.children().stream().anyMatch(LayoutQuestion::leadsAcross);
    }

    private static boolean isOwn(Graph.End end) {
        return end.node().isEmpty();
    }

    /** What the labels of the outermost ports need beside their nodes. */
    private static double outside(List<Node> roots) {
        return roots.stream()
                .filter(Node::isOpen)
                .flatMap(node -> node.ports().stream())
                .mapToDouble(port -> Lettering.SMALL.width(port.label()) + PortPlaces.GAP)
                .max()
                .orElse(0);
    }

    private void options(JsonText json) {
        json.field(
                "properties",
                options -> {
                    options.field("algorithm", "de.cau.cs.kieler.klay.layered");
                    options.field("direction", "RIGHT");
                    options.field("edgeRouting", "ORTHOGONAL");
                    options.field("spacing", SPACING);
                    options.field("layoutHierarchy", across);
                    options.field("separateConnComp", false);
                });
    }

    private void node(JsonText json, Node node) {
        json.field("id", names.of(node));
        if (node.form() == Form.DOT || node.form() == Form.JUNCTION) {
            double size = node.form() == Form.DOT ? DOT : JUNCTION;
            size(json, size, size);
        } else if (node.isOpen()) {
            open(json, node);
        } else {
            closed(json, node);
        }
    }

    private void open(JsonText json, Node node) {
        options(json);
        double top = TextSize.ofLines(node.lines()).height() + 2 * TITLE + PADDING;
        padding(json, top, INSIDE);
        json.objects("ports", node.ports(), this::sidedPort);
        json.objects("children", node.children(), this::node);
        json.objects("edges", node.edges(), (each, edge) -> edge(each, node, edge));
    }

    private static void padding(JsonText json, double top, double sides) {
        json.field(
                "padding",
                sizes -> {
                    number(sizes, "left", sides);
                    number(sizes, "right", sides);
                    number(sizes, "top", top);
                    number(sizes, "bottom", INSIDE);
                });
    }

    private void closed(JsonText json, Node node) {
        TextSize title = TextSize.ofLines(node.lines());
        double top = title.height() + 2 * TITLE;
        double width = Math.max(NARROWEST, title.width() + 2 * PADDING);
        width = Math.max(width, PortPlaces.width(node));
        double height = Math.max(LOWEST, PortPlaces.height(node, top));
        size(json, width, height);
        if (!node.ports().isEmpty()) {
            json.field("properties", options -> options.field("portConstraints", "FIXED_POS"));
            PortPlaces places = new PortPlaces(node, top, width);
            json.objects("ports", node.ports(), (each, port) -> fixedPort(each, port, places));
        }
    }

    private void fixedPort(JsonText json, Graph.Port port, PortPlaces places) {
        sidedPort(json, port);
        number(json, "x", places.x(port));
        number(json, "y", places.y(port));
    }

    private void sidedPort(JsonText json, Graph.Port port) {
        json.field("id", names.of(port));
        size(json, PortPlaces.SIZE, PortPlaces.SIZE);
        json.field(
                "properties", options -> options.field("portSide", port.left() ? "WEST" : "EAST"));
    }

    private void edge(JsonText json, Node holder, Edge edge) {
        json.field("id", names.of(edge));
        end(json, "source", edge.source(), holder);
        end(json, "target", edge.target(), holder);
        if (!edge.captions().isEmpty()) {
            TextSize size = TextSize.of(edge.captions());
            json.objects(
                    "labels",
                    List.of(size),
                    (label, each) -> {
                        label.field("text", "label");
                        size(label, each.width(), each.height());
                        label.field(
                                "properties",
                                options -> options.field("edgeLabelPlacement", "CENTER"));
                    });
        }
    }

    private void end(JsonText json, String side, Graph.End end, Node holder) {
        Node node = end.in(holder);
        json.field(side, names.of(node));
        end.port()
                .flatMap(
                        wanted ->
                                node.ports().stream()
                                        .filter(port -> port.mark().name().equals(wanted))
                                        .findFirst())
                .ifPresent(port -> json.field(side + "Port", names.of(port)));
    }

    private static void size(JsonText json, double width, double height) {
        number(json, "width", width);
        number(json, "height", height);
    }

    /** Whole numbers are enough, and the same everywhere. */
    private static void number(JsonText json, String name, double value) {
        json.field(name, Math.round(Math.ceil(value)));
    }
}
