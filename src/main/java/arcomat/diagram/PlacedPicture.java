package arcomat.diagram;

import arcomat.diagram.Graph.Edge;
import arcomat.diagram.Graph.Form;
import arcomat.diagram.Graph.Node;
import arcomat.diagram.Picture.Box;
import arcomat.diagram.Picture.Element;
import arcomat.diagram.Picture.Point;
import arcomat.diagram.Picture.Shape;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Draws a graph whose layout is known. */
public final class PlacedPicture {
    private static final double ROUND = 9;

    /** Of the dot where a line forks: lines without one only cross each other. */
    private static final double FORK = 2.6;

    /** Above and below the title of a node. */
    static final double TITLE = 8;

    /** Between a line across and the texts above and below. */
    private static final double DIVIDER = 3;

    private final LayoutPlaces places;
    private final List<Element> elements = new ArrayList<>();

    private PlacedPicture(LayoutPlaces places) {
        this.places = places;
    }

    /**
     * @param width of the whole
     */
    public static Picture of(Graph graph, double width, double height, LayoutPlaces places) {
        PlacedPicture picture = new PlacedPicture(places);
        graph.roots().forEach(node -> picture.place(node, 0, 0));
        return new Picture(graph.title(), width, height, picture.elements);
    }

    private void place(Node node, double x, double y) {
        Box box = places.node(node).moved(x, y);
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
            Box label = title(node, box).moved(box.x(), box.y());
            shapes.addAll(
                    node.form() == Form.CARD
                            ? card(node.lines(), label, box)
                            : texts(node.lines(), label, true));
        }
        elements.add(Element.of(node.mark(), shapes));
        node.children().forEach(child -> place(child, box.x(), box.y()));
        for (Edge edge : node.edges()) {
            place(edge, node, box);
        }
        node.ports().forEach(port -> place(port, box.x(), box.y()));
    }

    private Box title(Node node, Box box) {
        return node.isOpen() ? new Box(0, TITLE, box.width(), 0) : places.title(node);
    }

    private void place(Graph.Port port, double x, double y) {
        Box box = places.port(port).moved(x, y);
        List<Shape> shapes = new ArrayList<>();
        shapes.add(new Picture.Rectangle(box, 0));
        Box label = places.label(port).moved(box.x(), box.y());
        shapes.addAll(texts(List.of(Graph.Line.small(port.label())), label, false));
        elements.add(Element.of(port.mark(), shapes));
    }

    private void place(Edge edge, Node node, Box holder) {
        LayoutPlaces.Route route = places.route(node, edge);
        boolean head = edge.target().in(node).form() != Form.JUNCTION;
        List<Point> points =
                route.points().stream().map(each -> each.plus(holder.x(), holder.y())).toList();
        List<Shape> shapes = new ArrayList<>();
        shapes.add(new Picture.Arrow(points, head));
        for (Point fork : route.forks()) {
            shapes.add(new Picture.Circle(fork.plus(holder.x(), holder.y()), FORK));
        }
        Picture.Ends ends =
                new Picture.Ends(node.name(), edge.source().name(node), edge.target().name(node));
        elements.add(new Element(edge.mark(), Optional.of(ends), shapes));
        route.label()
                .ifPresent(label -> place(edge.captions(), label.moved(holder.x(), holder.y())));
    }

    private void place(List<Graph.Caption> captions, Box box) {
        double below = 0;
        for (Graph.Caption caption : captions) {
            double height = TextSize.ofLines(caption.lines()).height();
            Box own = new Box(box.x(), box.y() + below, box.width(), height);
            elements.add(Element.of(caption.mark(), texts(caption.lines(), own, true)));
            below += height + TextSize.GAP;
        }
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
