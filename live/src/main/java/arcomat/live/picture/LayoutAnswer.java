package arcomat.live.picture;

import arcomat.diagram.Graph;
import arcomat.diagram.Graph.Edge;
import arcomat.diagram.Graph.Node;
import arcomat.diagram.LayoutPlaces;
import arcomat.diagram.Lettering;
import arcomat.diagram.Picture.Box;
import arcomat.diagram.Picture.Point;
import arcomat.diagram.TextSize;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * Where the page's engine has put everything. A line for each element: its name, then numbers; of
 * what has a size place and size, of an edge the place of its label, how many points it has, its
 * points, and the points where it forks.
 */
final class LayoutAnswer implements LayoutPlaces {
    private static final double TITLE = 8;

    private final Names names;
    private final Map<String, double[]> numbers = new HashMap<>();
    private final List<Node> outermost;

    private LayoutAnswer(Names names, List<Node> outermost) {
        this.names = names;
        this.outermost = outermost;
    }

    static LayoutAnswer read(String lines, Names names, Graph graph) {
        LayoutAnswer answer = new LayoutAnswer(names, graph.roots());
        List.of(lines.split("\n")).forEach(answer::add);
        return answer;
    }

    private void add(String line) {
        String[] words = line.split(" ");
        double[] values = new double[words.length - 1];
        for (int i = 0; i < values.length; i++) {
            values[i] = Double.parseDouble(words[i + 1]);
        }
        numbers.put(words[0], values);
    }

    /** Of the whole picture. */
    Box whole() {
        return box(Names.ROOT);
    }

    @Override
    public Box node(Node node) {
        return box(names.of(node));
    }

    @Override
    public Box title(Node node) {
        Box box = node(node);
        TextSize size = TextSize.ofLines(node.lines());
        double y = node.ports().isEmpty() ? (box.height() - size.height()) / 2 : TITLE;
        return new Box((box.width() - size.width()) / 2, y, size.width(), size.height());
    }

    @Override
    public Box port(Graph.Port port) {
        return box(names.of(port));
    }

    /** Inside of its node; outside where that is the outermost one, and open. */
    @Override
    public Box label(Graph.Port port) {
        double width = Lettering.SMALL.width(port.label());
        double height = Lettering.SMALL.lineHeight();
        boolean outside =
                outermost.stream().anyMatch(node -> node.isOpen() && node.ports().contains(port));
        double behind = PortPlaces.SIZE + PortPlaces.GAP;
        double before = -width - PortPlaces.GAP;
        double x = port.left() == outside ? before : behind;
        return new Box(x, (PortPlaces.SIZE - height) / 2, width, height);
    }

    @Override
    public Route route(Node holder, Edge edge) {
        double[] values = values(names.of(edge));
        TextSize size = TextSize.of(edge.captions());
        Optional<Box> label =
                edge.captions().isEmpty()
                        ? Optional.empty()
                        : Optional.of(new Box(values[0], values[1], size.width(), size.height()));
        int end = 3 + 2 * (int) values[2];
        return new Route(points(values, 3, end), points(values, end, values.length), label);
    }

    private static List<Point> points(double[] values, int from, int to) {
        List<Point> points = new ArrayList<>();
        for (int i = from; i + 1 < to; i += 2) {
            points.add(new Point(values[i], values[i + 1]));
        }
        return points;
    }

    private Box box(String name) {
        double[] values = values(name);
        return new Box(values[0], values[1], values[2], values[3]);
    }

    private double[] values(String name) {
        return Objects.requireNonNull(numbers.get(name), name);
    }
}
