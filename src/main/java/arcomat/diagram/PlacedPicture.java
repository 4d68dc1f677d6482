package arcomat.diagram;

import arcomat.diagram.Graph.Edge;
import arcomat.diagram.Graph.Form;
import arcomat.diagram.Graph.Node;
import arcomat.diagram.Picture.Box;
import arcomat.diagram.Picture.Element;
import arcomat.diagram.Picture.Point;
import arcomat.diagram.Picture.Shape;

import org.eclipse.elk.core.math.KVector;
import org.eclipse.elk.core.options.CoreOptions;
import org.eclipse.elk.core.util.ElkUtil;
import org.eclipse.elk.graph.ElkEdge;
import org.eclipse.elk.graph.ElkLabel;
import org.eclipse.elk.graph.ElkNode;
import org.eclipse.elk.graph.ElkPort;
import org.eclipse.elk.graph.ElkShape;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;

/** Reads from a graph with a layout where everything is. */
final class PlacedPicture {
    private static final double ROUND = 9;

    /** Of the dot where a line forks: lines without one only cross each other. */
    private static final double FORK = 2.6;

    /** Between a line across and the texts above and below. */
    private static final double DIVIDER = 3;

    private final LayeredLayout layout;
    private final List<Element> elements = new ArrayList<>();

    PlacedPicture(LayeredLayout layout) {
        this.layout = layout;
    }

    Picture picture(Graph graph, ElkNode root) {
        graph.roots().forEach(node -> place(node, 0, 0));
        return new Picture(graph.title(), root.getWidth(), root.getHeight(), elements);
    }

    private void place(Node node, double x, double y) {
        ElkNode placed = Objects.requireNonNull(layout.nodes.get(node));
        Box box = box(placed).moved(x, y);
        List<Shape> shapes = new ArrayList<>();
        switch (node.form()) {
            case BOX, CARD -> shapes.add(new Picture.Rectangle(box, 3));
            case ROUND -> shapes.add(new Picture.Rectangle(box, ROUND));
            case DOT, JUNCTION ->
                    shapes.add(
                            new Picture.Circle(
                                    new Point(
                                            box.x() + box.width() / 2, box.y() + box.height() / 2),
                                    box.width() / 2));
        }
        if (!node.lines().isEmpty()) {
            Box label = title(node, placed).moved(box.x(), box.y());
            shapes.addAll(
                    node.form() == Form.CARD
                            ? card(node.lines(), label, box)
                            : texts(node.lines(), label, true));
        }
        elements.add(new Element(node.mark(), shapes));
        node.children().forEach(child -> place(child, box.x(), box.y()));
        Set<ElkNode> inside =
                node.inside().stream().map(layout.nodes::get).collect(Collectors.toSet());
        for (Edge edge : node.edges()) {
            Node target = LayeredLayout.node(edge.target(), node.inside(), node);
            place(edge, target.form() != Form.JUNCTION, inside, box);
        }
        node.ports().forEach(port -> place(port, box.x(), box.y()));
    }

    private static Box title(Node node, ElkNode placed) {
        return node.isOpen()
                ? new Box(0, LayeredLayout.TITLE, placed.getWidth(), 0)
                : box(placed.getLabels().get(0));
    }

    private void place(Graph.Port port, double x, double y) {
        ElkPort placed = Objects.requireNonNull(layout.ports.get(port));
        Box box = box(placed).moved(x, y);
        List<Shape> shapes = new ArrayList<>();
        shapes.add(new Picture.Rectangle(box, 0));
        Box label = box(placed.getLabels().get(0)).moved(box.x(), box.y());
        shapes.addAll(texts(List.of(Graph.Line.small(port.label())), label, false));
        elements.add(new Element(port.mark(), shapes));
    }

    /**
     * Where it lies is said from the innermost node on that has both its ends.
     *
     * @param inside all nodes between those and who has the edge: one graph may be drawn twice
     */
    private void place(Edge edge, boolean head, Set<ElkNode> inside, Box holder) {
        List<ElkEdge> placed = Objects.requireNonNull(layout.edges.get(edge));
        double x = holder.x();
        double y = holder.y();
        ElkNode inner = placed.get(0).getContainingNode();
        while (inside.contains(inner)) {
            x += inner.getX();
            y += inner.getY();
            inner = inner.getParent();
        }
        List<Point> points = new ArrayList<>();
        List<Shape> shapes = new ArrayList<>();
        for (ElkEdge piece : placed) {
            for (KVector point : ElkUtil.createVectorChain(piece.getSections().get(0))) {
                points.add(new Point(point.x + x, point.y + y));
            }
            for (KVector fork : piece.getProperty(CoreOptions.JUNCTION_POINTS)) {
                shapes.add(new Picture.Circle(new Point(fork.x + x, fork.y + y), FORK));
            }
        }
        shapes.add(0, new Picture.Arrow(points, head));
        elements.add(new Element(edge.mark(), shapes));
        for (ElkLabel label : placed.get(0).getLabels()) {
            place(edge.captions(), box(label).moved(x, y));
        }
    }

    private void place(List<Graph.Caption> captions, Box box) {
        double below = 0;
        for (Graph.Caption caption : captions) {
            double height = TextSize.ofLines(caption.lines()).height();
            Box own = new Box(box.x(), box.y() + below, box.width(), height);
            elements.add(new Element(caption.mark(), texts(caption.lines(), own, true)));
            below += height + TextSize.GAP;
        }
    }

    private static Box box(ElkShape shape) {
        return new Box(shape.getX(), shape.getY(), shape.getWidth(), shape.getHeight());
    }

    /** A title, a line across, and what stands below it. */
    private static List<Shape> card(List<Graph.Line> lines, Box label, Box box) {
        List<Graph.Line> title =
                lines.stream().filter(line -> line.lettering() != Lettering.PLAIN).toList();
        List<Graph.Line> members =
                lines.stream().filter(line -> line.lettering() == Lettering.PLAIN).toList();
        double height = TextSize.ofLines(title).height();
        List<Shape> shapes = texts(title, label.moved(0, -DIVIDER), true);
        double y = label.y() + height;
        shapes.add(new Picture.Line(new Point(box.x(), y), new Point(box.x() + box.width(), y)));
        shapes.addAll(texts(members, label.moved(0, height + DIVIDER), false));
        return shapes;
    }

    /** Lines below each other in a box, in its middle or at its left. */
    private static List<Shape> texts(List<Graph.Line> lines, Box box, boolean centred) {
        List<Shape> texts = new ArrayList<>();
        double y = box.y();
        for (Graph.Line line : lines) {
            double width = line.lettering().width(line.text());
            double x = centred ? box.x() + (box.width() - width) / 2 : box.x();
            double height = line.lettering().lineHeight();
            texts.add(new Picture.Text(new Box(x, y, width, height), line));
            y += height;
        }
        return texts;
    }
}
